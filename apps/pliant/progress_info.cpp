#include <fmt/format.h>

#include "pliant/io/answer_file.h"
#include "pliant/io/journal_file.h"

#include "apps/pliant/file_info.h"

namespace pliant {

FileInfo progress_info(const std::filesystem::path& path) {
  const Journal::Content content = read_journal(path);
  FileInfo info = begin_info(path, "progress/1");
  std::size_t answers = content.entries.size();
  for (const auto& [part, entries] : content.parts) answers += entries.size();
  info.json["answers"] = answers;
  info.json["last"] = nullptr;
  info.json["warnings"] = info.warnings;
  info.lines.push_back(labelled("what it is", "the progress of a fit, for --resume"));
  if (content.entries.empty()) return info;
  const std::string& last = content.entries.back().question;
  info.json["last"] = last;
  info.lines.push_back(labelled("begun", content.entries.front().question));
  info.lines.push_back(labelled("finished", fmt::format("{} steps", answers)));
  info.lines.push_back(labelled("last", last));
  for (const auto& [part, entries] : content.parts) {
    if (entries.empty()) continue;
    info.lines.push_back(labelled("last of " + part, entries.back().question));
  }
  return info;
}

FileInfo answers_info(const std::filesystem::path& path) {
  FileInfo info = begin_info(path, "answers/1");
  const int answers = AnswerFile::count(path);
  info.json["answers"] = answers;
  info.json["warnings"] = info.warnings;
  info.lines.push_back(labelled("what it is", "the progress of an import, for --resume"));
  info.lines.push_back(labelled("finished", fmt::format("{} searches of pictures", answers)));
  return info;
}

}  // namespace pliant
