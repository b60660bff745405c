#include "apps/pliant/given_document.h"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/io/document.h"
#include "pliant/io/fields.h"

#include "apps/pliant/file_info.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

/// What a file is called, and what may be done with it.
struct Way {
  std::string what;
  std::string in;  ///< {} stands for the file
};

const Way* way_of_ending(const std::string& ending) {
  static const Way table{"a table of measurements",
                         "a study of it, which `pliant init --from {0} -o DIR` writes"};
  static const Way photo{
      "a photograph", "a study of its strip, which `pliant import {0} -o DIR --scale ...` makes"};
  static const Way mesh{"a mesh", "a scene that names it (`mesh: {{file: {0}, unit: mm}}`)"};
  static const Way hdf{"an HDF5 file, which no command reads",
                       "its series saved as CSV, and `pliant init --from` that"};
  static const Way old_workbook{
      "a workbook of the old kind, which no command reads",
      "the workbook saved as .xlsx or CSV, and `pliant init --from` that"};
  static const std::map<std::string, const Way*> ways{
      {".csv", &table},       {".tsv", &table},  {".txt", &table},  {".xlsx", &table},
      {".xlsm", &table},      {".jpg", &photo},  {".jpeg", &photo}, {".png", &photo},
      {".tif", &photo},       {".tiff", &photo}, {".bmp", &photo},  {".obj", &mesh},
      {".ply", &mesh},        {".vtu", &mesh},   {".h5", &hdf},     {".hdf5", &hdf},
      {".xls", &old_workbook}};
  const auto found = ways.find(ending);
  return found == ways.end() ? nullptr : found->second;
}

Way way_of_document(const std::string& type) {
  static const std::map<std::string, Way> ways{
      {"study/1", {"a study", "`pliant fit {0} -o DIR`"}},
      {"lab/1", {"a lab", "`pliant lab {0} -o DIR`"}},
      {"scene/1", {"a scene", "`pliant simulate {0} -o DIR`"}},
      {"session/1", {"a session", "a study that names its folder (`type: session`)"}},
      {"material/1",
       {"a material", "`pliant evaluate STUDY -m {0} -o DIR`, or a scene that names it"}},
      {"fit/1", {"the result of a fit", "`pliant report` of its folder"}},
      {"evaluation/1", {"the result of an evaluation", "`pliant report` of its folder"}},
      {"simulation/1", {"the result of a simulation", "`pliant report` of its folder"}}};
  const auto found = ways.find(type);
  return found == ways.end() ? Way{"a document of type " + quoted_value(type), "{0}"}
                             : found->second;
}

[[noreturn]] void refuse(const fs::path& file, const Way& way, const std::string& type,
                         int line = 0) {
  const std::string field = line > 0 ? "pliant" : "";
  throw InputError({file.string(), line, field}, fmt::format("is {}, not a {}/1", way.what, type),
                   fmt::format(fmt::runtime(way.in), file.string()));
}

/// ARCSim's materials are JSON without a type of document.
bool is_arcsim_material(const Document& document) {
  if (document.root.kind != Node::Kind::mapping) return false;
  const auto has = [&](std::string_view key) {
    return std::ranges::find(document.root.fields, key, &Node::Field::key) !=
           document.root.fields.end();
  };
  return has("stretching") && has("bending");
}

void refuse_other_document(const fs::path& file, const std::string& ending,
                           const std::string& type) {
  const Document document = ending == ".json" ? read_json(file) : read_yaml(file);
  const std::optional<std::string> told = document_type(document);
  if (!told && is_arcsim_material(document)) {
    refuse(file, {"a material of ARCSim, which no command reads yet", "a " + type}, type);
  }
  if (told && !told->starts_with(type + "/")) {
    refuse(file, way_of_document(*told), type, document.root.line);
  }
}

fs::path document_of_folder(const fs::path& folder, const std::string& type) {
  const fs::path document = folder / (type + (type == "material" ? ".json" : ".yaml"));
  if (fs::exists(document)) return document;
  if (fs::exists(folder / "session.yaml")) refuse(folder, way_of_document("session/1"), type);
  throw InputError({folder.string()},
                   fmt::format("is a directory that holds no {}", document.filename().string()),
                   fmt::format("a {}, or a folder that holds one", type));
}

}  // namespace

fs::path given_document(const fs::path& file, const std::string& type) {
  if (fs::is_directory(file)) return document_of_folder(file, type);
  if (!fs::exists(file)) return file;  // its reader says so
  const std::string ending = lower_case_extension(file);
  if (const Way* way = way_of_ending(ending)) refuse(file, *way, type);
  if (ending == ".json" || ending == ".yaml" || ending == ".yml") {
    refuse_other_document(file, ending, type);
  }
  return file;
}

}  // namespace pliant
