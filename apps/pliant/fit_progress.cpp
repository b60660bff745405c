#include "apps/pliant/fit_progress.h"

#include "pliant/base/errors.h"
#include "pliant/io/journal_file.h"

namespace pliant {
namespace {

constexpr double kPeriod = 10;  // s, what a crash may lose

}  // namespace

FitProgress::FitProgress(ResultDirectory& results, bool resume)
    : results_(results), journal_([this](const auto&) { save_now_and_then(); }) {
  if (!resume) return;
  if (!std::filesystem::exists(file())) {
    throw InputError({results.path().string()}, "holds no progress of a fit to go on from",
                     "the results folder of a fit that was stopped");
  }
  journal_.resume(read_journal(file()), file().string());
}

std::filesystem::path FitProgress::file() const { return results_.path() / kProgressFile; }

bool FitProgress::save() {
  const Journal::Content& content = journal_.content();
  if (content.entries.empty()) return false;
  results_.set_aside(kProgressFile, journal_bytes(content));
  since_saved_ = {};
  return true;
}

void FitProgress::save_now_and_then() {
  if (since_saved_.seconds() > kPeriod) save();
}

}  // namespace pliant
