#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "pliant/base/journal.h"
#include "pliant/base/stopwatch.h"

namespace pliant {

/// A journal that remembers answers alone, in a file to which they are appended: for computations
/// whose answers are too large to be kept in memory, or to be written anew with each.
///
/// The file is a line that says what it is, and for each answer a line of its lengths and digest,
/// the question, and the numbers to the bit. What was cut off while it was written is left out.
class AnswerFile : public Journal {
 public:
  /// @param begin  makes the file anew of the bytes that it is given, the first answers among them;
  ///               is called where an earlier file is not gone on from
  AnswerFile(std::filesystem::path file, std::function<void(const std::string&)> begin);

  /// Begins with the answers in the file.
  /// @throws InputError where there is none
  void resume();

  /// @throws InputError as Journal's; OutputError where it cannot be written
  Numbers answer(const std::string& question, const std::function<Numbers()>& work) override;

  /// Writes what is not written yet.
  /// @return false where there is nothing to go on from
  /// @throws OutputError
  bool save();

  /// Whether answers were written, or read that are those of this computation: a short one ends
  /// before any are.
  bool is_begun() const { return whole_ > 0 && !is_of_another_; }
  const std::filesystem::path& file() const { return file_; }

  /// How many a file has.
  /// @throws InputError as `resume`
  static int count(const std::filesystem::path& file);

 private:
  struct Record;

  Record read_record();

  std::filesystem::path file_;
  std::function<void(const std::string&)> begin_;
  std::ifstream known_;         // open while it may hold the next answer
  std::size_t whole_ = 0;       // bytes of the file up to the last whole answer
  bool is_of_another_ = false;  // computation
  std::string unwritten_;
  Stopwatch since_saved_;
};

/// Whether a file begins as these do.
bool is_answer_file(const std::filesystem::path& file);

}  // namespace pliant
