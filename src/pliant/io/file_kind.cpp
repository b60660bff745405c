#include "pliant/io/file_kind.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/letter_case.h"

namespace pliant {
namespace {

/// Kinds by endings; {0} stands for the file.
const std::map<std::string, FileKind>& kinds() {
  static const FileKind table{"a table of measurements",
                              "a study of it, which `pliant init --from {0} -o DIR` writes", true};
  static const FileKind photo{
      "a photograph", "a study of its strip, which `pliant import {0} -o DIR --scale ...` makes"};
  static const FileKind mesh{"a mesh", "a scene that names it (`mesh: {{file: {0}, unit: mm}}`)"};
  static const FileKind hdf{"an HDF5 file, which no command reads",
                            "its series saved as CSV, and `pliant init --from` that"};
  static const FileKind other_workbook{
      "a workbook of another kind than .xlsx, which no command reads",
      "the workbook saved as .xlsx or CSV, and `pliant init --from` that"};
  static const std::map<std::string, FileKind> kinds{
      {".csv", table},          {".tsv", table},         {".txt", table},  {".xlsx", table},
      {".xlsm", table},         {".jpg", photo},         {".jpeg", photo}, {".png", photo},
      {".tif", photo},          {".tiff", photo},        {".bmp", photo},  {".obj", mesh},
      {".ply", mesh},           {".vtu", mesh},          {".h5", hdf},     {".hdf5", hdf},
      {".xls", other_workbook}, {".ods", other_workbook}};
  return kinds;
}

}  // namespace

std::optional<FileKind> kind_of_file(const std::filesystem::path& file) {
  const auto found = kinds().find(lower_case(file.extension().string()));
  if (found == kinds().end()) return std::nullopt;
  FileKind kind = found->second;
  kind.way_in = fmt::format(fmt::runtime(kind.way_in), file.string());
  return kind;
}

std::optional<FileKind> kind_of_foreign_document(const Document& document) {
  const auto has = [&](std::string_view key) {
    return std::ranges::find(document.root.fields, key, &Node::Field::key) !=
           document.root.fields.end();
  };
  if (!has("stretching") || !has("bending")) return std::nullopt;
  return FileKind{"a material of ARCSim, which no command reads yet",
                  "a material of Pliant (material/1), e.g. of the folder materials/"};
}

void require_table(const std::filesystem::path& file) {
  const std::optional<FileKind> kind = kind_of_file(file);
  if (!kind || kind->is_table) return;
  throw InputError({file.string()}, fmt::format("is {}, not a table of measurements", kind->what),
                   kind->way_in);
}

}  // namespace pliant
