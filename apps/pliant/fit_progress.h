#pragma once

#include <filesystem>

#include "pliant/base/journal.h"
#include "pliant/base/stopwatch.h"
#include "pliant/io/result_directory.h"

namespace pliant {

/// The progress of a long fit as a file in the folder of its results, beside those of an earlier
/// fit, until it has its own.
class FitProgress {
 public:
  /// @param results  outlive the progress
  /// @param resume   whether to go on from what stands there
  /// @throws InputError where nothing does
  FitProgress(ResultDirectory& results, bool resume);

  Journal& journal() { return journal_; }
  std::filesystem::path file() const;
  /// Writes what there is.
  /// @return false where there is nothing to go on from
  bool save();

 private:
  void save_now_and_then();

  ResultDirectory& results_;
  Journal journal_;
  Stopwatch since_saved_;
};

}  // namespace pliant
