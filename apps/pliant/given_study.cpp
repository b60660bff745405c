#include "apps/pliant/given_study.h"

#include "pliant/exchange/u3m_import.h"

namespace pliant {

StudyFile study_or_imported(const CommandContext& context, const std::filesystem::path& file,
                            ResultDirectory& results) {
  if (!is_u3m(file)) return {file, results.path()};
  const ImportedStudy imported = import_u3m(file, {});
  for (const std::string& note : imported.notes) context.say(note);
  for (const std::string& warning : imported.warnings) {
    context.run.progress.message(Level::warning, warning);
  }
  results.write("imported/study.yaml", imported.study_yaml);
  for (const auto& [name, content] : imported.files) results.write("imported/" + name, content);
  // The files stand in the staging folder now and in the results in the end: relative paths are the
  // same.
  return {results.staging() / "imported" / "study.yaml", results.staging()};
}

std::string folder_name(const std::filesystem::path& study) {
  if (study.stem() != "study") return study.stem().string();
  const std::filesystem::path folder = std::filesystem::absolute(study).parent_path().filename();
  return folder.empty() ? "study" : folder.string();
}

}  // namespace pliant
