#include "apps/pliant/file_info.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/exchange/u3m_file.h"
#include "pliant/geometry/polygon_mesh.h"
#include "pliant/geometry/volume_file.h"
#include "pliant/io/answer_file.h"
#include "pliant/io/document.h"
#include "pliant/io/fields.h"
#include "pliant/io/file_kind.h"
#include "pliant/io/journal_file.h"
#include "pliant/io/text_file.h"
#include "pliant/io/workbook.h"
#include "pliant/scene/checkpoint.h"

#include "apps/pliant/mesh_info.h"
#include "apps/pliant/volume_info.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

constexpr int kLabelWidth = 28;

enum class Syntax { yaml, json, csv };

/// By the name, else by the beginning of the content.
Syntax syntax_of(const fs::path& path) {
  const std::string extension = lower_case_extension(path);
  if (extension == ".yaml" || extension == ".yml") return Syntax::yaml;
  if (extension == ".json") return Syntax::json;
  if (extension == ".csv" || extension == ".tsv" || extension == ".txt") return Syntax::csv;
  if (is_workbook(path)) return Syntax::csv;
  const std::string text = read_text_file(path);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && text[first] == '{') return Syntax::json;
  const bool document = text.starts_with("pliant:") || text.find("\npliant:") != std::string::npos;
  return document ? Syntax::yaml : Syntax::csv;
}

FileInfo document_info(const fs::path& path, const Document& document) {
  const std::string expected =
      "study/1, lab/1, scene/1, session/1, dic/1, pattern/1, rig/1, calibration/1, material/1, "
      "fit/1, "
      "evaluation/1 or simulation/1";
  const std::optional<std::string> type = document_type(document);
  const auto foreign = type ? std::nullopt : kind_of_foreign_document(document);
  if (foreign) throw InputError({document.file}, "is " + foreign->what, foreign->way_in);
  if (!type) {
    throw InputError({document.file, document.root.line, "pliant"}, "is missing",
                     "type and version of the document: " + expected);
  }
  // The readers judge the version.
  const std::string name = type->substr(0, type->find('/'));
  if (name == "study") return study_info(path);
  if (name == "lab") return lab_info(path);
  if (name == "scene") return scene_info(path);
  if (name == "session") return session_info(path);
  if (name == "dic") return dic_info(path);
  if (name == "pattern") return pattern_info(path);
  if (name == "rig") return rig_info(path);
  if (name == "calibration") return calibration_info(path);
  if (name == "material") return material_info(path);
  if (name == "fit" || name == "evaluation") return results_file_info(path);
  if (name == "simulation") return simulation_info(path);
  throw InputError({document.file, document.root.line, "pliant"},
                   "unknown type of document " + quoted_value(*type), expected);
}

}  // namespace

std::string lower_case_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

FileInfo begin_info(const fs::path& path, const std::string& type) {
  FileInfo info;
  info.json["file"] = path.string();
  info.json["type"] = type;
  info.lines.push_back(fmt::format("{}: {}", path.string(), type));
  return info;
}

std::string labelled(std::string_view label, std::string_view text, int indent) {
  return fmt::format("{:{}}{:<{}} {}", "", 2 * indent, label, kLabelWidth - 2 * indent, text);
}

FileInfo describe_file(const fs::path& path, const CsvOptions& reading) {
  if (fs::is_directory(path)) return directory_info(path);
  if (is_mesh_file(path)) return mesh_info(path);
  if (lower_case_extension(path) == ".vtu") return vtu_info(path);
  if (is_volume_file(path)) return volume_info(path);
  if (is_checkpoint(path)) return checkpoint_info(path);
  if (is_journal(path)) return progress_info(path);
  if (is_answer_file(path)) return answers_info(path);
  if (is_u3m(path)) return u3m_file_info(path);
  switch (syntax_of(path)) {
    case Syntax::yaml:
      return document_info(path, read_yaml(path));
    case Syntax::json:
      return document_info(path, read_json(path));
    case Syntax::csv:
      break;
  }
  return csv_info(path, reading);
}

}  // namespace pliant
