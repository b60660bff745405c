#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pliant {

/// The words of a text, one after the other, with their lines. `#` begins a comment where asked.
class TokenReader {
 public:
  /// @param text  outlives the reader
  /// @param file  for errors
  TokenReader(std::string_view text, std::string file, bool comments = false)
      : rest_(text), file_(std::move(file)), comments_(comments) {}

  /// The next word; nothing at the end.
  std::optional<std::string_view> next();
  /// The next word, which has to be there.
  /// @throws InputError
  std::string_view word(const std::string& expected);
  /// The next word as a number.
  double number(const std::string& what);
  /// The next word as a whole number from `low` on.
  int integer(const std::string& what, int low = 0);
  /// Text between quotes.
  std::string quoted(const std::string& what);

  /// Of the last word, counted from 1.
  int line() const { return line_; }
  [[noreturn]] void fail(const std::string& problem, const std::string& expected = {}) const;

 private:
  void skip();

  std::string_view rest_;
  std::string file_;
  bool comments_;
  int line_ = 1;
};

}  // namespace pliant
