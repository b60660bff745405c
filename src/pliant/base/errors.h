#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace pliant {

/// Where in the user's input something was found; a part that is unknown is empty or 0.
struct Location {
  std::string file = {};
  int line = 0;  ///< counted from 1
  std::string field =
      {};  ///< dotted path of a document ("experiments[2].clip_mass") or a column's header
};

/// The input cannot be used as it is: a file, an option or an environment that its owner must mend.
class InputError : public std::runtime_error {
 public:
  /// @param problem   what is wrong, with the offending value (see `quoted_value`)
  /// @param expected  what would be right; may be empty
  InputError(Location where, std::string problem, std::string expected = {});

  const Location& where() const { return where_; }
  const std::string& problem() const { return problem_; }
  const std::string& expected() const { return expected_; }

 private:
  Location where_;
  std::string problem_;
  std::string expected_;
};

/// A numerical method found no answer that could be given.
class SolverError : public std::runtime_error {
 public:
  /// @param what_failed    e.g. "the equilibrium of frame 12"
  /// @param iterations     of the search; 0: not known
  /// @param best_residual  smallest residual reached, in the unit of `what_failed`; 0 or infinite:
  ///                       not known
  SolverError(std::string what_failed, int iterations, double best_residual);

  int iterations() const { return iterations_; }
  double best_residual() const { return best_residual_; }

 private:
  int iterations_;
  double best_residual_;
};

/// Writing a result failed on the way: the disk is full, the medium failed, a quota was reached.
class OutputError : public std::runtime_error {
 public:
  OutputError(std::string path, std::string reason);

  const std::string& path() const { return path_; }
  const std::string& reason() const { return reason_; }

 private:
  std::string path_;
  std::string reason_;
};

/// The user asked to stop.
class Interrupted : public std::runtime_error {
 public:
  Interrupted();
};

/// A value from a file between double quotes, fit for an error message: control characters and
/// bytes that are not UTF-8 are shown as escapes, and a long value is cut.
std::string quoted_value(std::string_view value);

/// `text` on one readable line of at most `max_bytes` bytes (plus an ellipsis), cut between
/// characters.
std::string one_line(std::string_view text, std::size_t max_bytes);

}  // namespace pliant
