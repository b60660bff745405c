#include "apps/pliant/given_document.h"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/nearest_name.h"
#include "pliant/io/document.h"
#include "pliant/io/fields.h"
#include "pliant/io/file_kind.h"

#include "apps/pliant/file_info.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

FileKind kind_of_document(const std::string& type, const std::string& file) {
  static const std::map<std::string, FileKind> kinds{
      {"study/1", {"a study", "`pliant fit {0} -o DIR`"}},
      {"lab/1", {"a lab", "`pliant lab {0} -o DIR`"}},
      {"scene/1", {"a scene", "`pliant simulate {0} -o DIR`"}},
      {"session/1", {"a session", "a study that names its folder (`type: session`)"}},
      {"material/1",
       {"a material", "`pliant evaluate STUDY -m {0} -o DIR`, or a scene that names it"}},
      {"fit/1", {"the result of a fit", "`pliant report` of its folder"}},
      {"evaluation/1", {"the result of an evaluation", "`pliant report` of its folder"}},
      {"simulation/1", {"the result of a simulation", "`pliant report` of its folder"}}};
  const auto found = kinds.find(type);
  if (found == kinds.end()) return {"a document of type " + quoted_value(type), file};
  return {found->second.what, fmt::format(fmt::runtime(found->second.way_in), file)};
}

[[noreturn]] void refuse(const fs::path& file, const FileKind& kind, const std::string& type,
                         int line = 0) {
  const std::string field = line > 0 ? "pliant" : "";
  throw InputError({file.string(), line, field}, fmt::format("is {}, not a {}/1", kind.what, type),
                   kind.way_in);
}

Document read_document(const fs::path& file) {
  return lower_case_extension(file) == ".json" ? read_json(file) : read_yaml(file);
}

bool may_be_document(const fs::path& file) {
  const std::string ending = lower_case_extension(file);
  return ending == ".json" || ending == ".yaml" || ending == ".yml";
}

void refuse_other_document(const fs::path& file, const std::string& type) {
  const Document document = read_document(file);
  const std::optional<std::string> told = document_type(document);
  const auto foreign = told ? std::nullopt : kind_of_foreign_document(document);
  if (foreign) refuse(file, *foreign, type);
  if (told && !told->starts_with(type + "/")) {
    refuse(file, kind_of_document(*told, file.string()), type, document.root.line);
  }
}

bool is_document_of(const fs::path& file, const std::string& type) {
  if (!may_be_document(file)) return false;
  try {
    return document_type(read_document(file)).value_or("").starts_with(type + "/");
  } catch (const InputError&) {
    return false;
  }
}

/// The files of a folder that fit, by name.
template <class Fits>
std::vector<fs::path> files_of(const fs::path& folder, Fits fits) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && fits(entry.path())) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// Files as a shell takes them: by a pattern, where it means no other kind of table.
std::string shell_names(const std::vector<fs::path>& tables) {
  const fs::path& first = tables.front();
  const bool alike = std::ranges::all_of(
      tables, [&](const fs::path& table) { return table.extension() == first.extension(); });
  if (alike && tables.size() > 1) {
    return (first.parent_path() / ("*" + first.extension().string())).string();
  }
  std::vector<std::string> names;
  for (const fs::path& table : tables) names.push_back(table.string());
  return fmt::format("{}", fmt::join(names, " "));
}

/// A folder of measurements that are in no study yet.
[[noreturn]] void refuse_tables(const fs::path& folder, const std::vector<fs::path>& tables) {
  throw InputError(
      {folder.string()}, "is a directory of tables that holds no study",
      fmt::format("a study, which `pliant init --from {} -o DIR` writes", shell_names(tables)));
}

fs::path document_of_folder(const fs::path& folder, const std::string& type) {
  const fs::path document = folder / (type + (type == "material" ? ".json" : ".yaml"));
  if (fs::exists(document)) return document;
  if (fs::exists(folder / "session.yaml")) {
    refuse(folder, kind_of_document("session/1", folder.string()), type);
  }
  const auto others = files_of(folder, [&](const fs::path& f) { return is_document_of(f, type); });
  if (others.size() == 1) return others.front();
  if (others.size() > 1) {
    std::vector<std::string> names;
    for (const fs::path& other : others) names.push_back(other.filename().string());
    throw InputError({folder.string()},
                     fmt::format("is a directory of several documents of type {}", type),
                     list_of_names(names));
  }
  const auto tables = files_of(folder, [](const fs::path& file) {
    const auto kind = kind_of_file(file);
    return kind && kind->is_table;
  });
  if (type == "study" && !tables.empty()) refuse_tables(folder, tables);
  throw InputError({folder.string()},
                   fmt::format("is a directory that holds no {}", document.filename().string()),
                   fmt::format("a {}, or a folder that holds one", type));
}

}  // namespace

fs::path given_document(const fs::path& file, const std::string& type) {
  if (fs::is_directory(file)) return document_of_folder(file, type);
  if (!fs::exists(file)) return file;  // its reader says so
  if (const auto kind = kind_of_file(file)) refuse(file, *kind, type);
  if (may_be_document(file)) refuse_other_document(file, type);
  return file;
}

}  // namespace pliant
