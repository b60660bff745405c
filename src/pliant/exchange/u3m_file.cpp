#include "pliant/exchange/u3m_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/io/text_file.h"
#include "pliant/io/workbook.h"
#include "pliant/io/zip_file.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr std::string_view kNoMeasurements = "has no raw measurements";
constexpr std::string_view kExpectedMeasurements =
    "a U3M 1.1 physics file: raw_data with at least one of L, W, B";

/// The text of the file at a path relative to the material description.
using ReadRelated = std::function<Document(const std::string&)>;

[[noreturn]] void fail_without_measurements(const Location& where) {
  throw InputError(where, std::string(kNoMeasurements), std::string(kExpectedMeasurements));
}

std::string lower_case_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool is_zip(std::string_view bytes) { return bytes.starts_with("PK\x03\x04"); }

bool has_key(const Fields& fields, std::string_view key) {
  const std::vector<std::string> keys = fields.keys();
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// The path under `material.physics.devices.fab`; the specification writes "null" for none.
std::optional<Value> physics_file_name(const Document& document) {
  auto name = find_value(Value(document), {"material", "physics", "devices", "fab"});
  if (!name || name->text() == "null" || name->text().empty()) return std::nullopt;
  return name;
}

/// Paths of a material stay within its folder, as the specification demands.
void refuse_outside_path(const Value& name) {
  const fs::path path(name.text());
  const bool outside =
      path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
  if (outside) {
    name.fail(quoted_value(name.text()) + " leads out of the folder of the material",
              "a relative path within it");
  }
}

/// @param named  what the material description's own path of the physics file is relative to
U3mFile follow(Document document, const ReadRelated& read_related) {
  if (find_physics(document)) return {std::move(document), std::nullopt};
  const std::optional<Value> name = physics_file_name(document);
  if (!name) fail_without_measurements({document.file});
  refuse_outside_path(*name);
  Document physics = read_related(name->text());
  if (!find_physics(physics)) fail_without_measurements({physics.file});
  return {std::move(physics), std::move(document)};
}

Document parse_entry(const fs::path& archive, const std::string& entry) {
  const std::string file = (archive / entry).string();
  return parse_json(decode_text(read_zip_entry(archive, entry), {}, file), file);
}

/// A material description names its physics file; without one, the first JSON file with
/// measurements counts.
U3mFile read_archive(const fs::path& path) {
  const std::vector<std::string> entries = zip_entries(path);
  for (const std::string& entry : entries) {
    if (lower_case_extension(entry) != ".u3m") continue;
    return follow(parse_entry(path, entry), [&](const std::string& name) {
      return parse_entry(path, (fs::path(entry).parent_path() / name).generic_string());
    });
  }
  for (const std::string& entry : entries) {
    if (lower_case_extension(entry) != ".json") continue;
    Document document = parse_entry(path, entry);
    if (find_physics(document)) return {std::move(document), std::nullopt};
  }
  fail_without_measurements({path.string()});
}

bool has_u3m_keys(const Document& document) {
  const Value root(document);
  if (!root.is_mapping()) return false;
  const Fields fields = root.fields();
  if (has_key(fields, "pliant")) return false;
  return find_physics(document) || (has_key(fields, "schema") && has_key(fields, "material"));
}

}  // namespace

std::optional<Value> find_value(const std::optional<Value>& root,
                                std::initializer_list<std::string_view> path) {
  std::optional<Value> value = root;
  for (const std::string_view key : path) {
    if (!value || !value->is_mapping()) return std::nullopt;
    value = value->fields().optional(key);
  }
  return value;
}

std::optional<Value> find_physics(const Document& document) {
  const Value root(document);
  for (const std::optional<Value>& place : {std::optional(root), find_value(root, {"physics"}),
                                            find_value(root, {"material", "physics"})}) {
    if (place && place->is_mapping() && has_key(place->fields(), "raw_data")) return place;
  }
  return std::nullopt;
}

std::optional<Value> find_material(const U3mFile& file) {
  return find_value(Value(file.material ? *file.material : file.physics), {"material"});
}

bool is_u3m(const fs::path& path) {
  if (is_workbook(path)) return false;  // a zip archive too
  const std::string extension = lower_case_extension(path);
  const std::string bytes = read_text_file(path);
  if (extension == ".u3m" || extension == ".u3ma" || is_zip(bytes)) return true;

  std::string_view text = bytes;
  if (text.starts_with(kUtf8Mark)) text.remove_prefix(kUtf8Mark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || text[first] != '{') return false;
  try {
    return has_u3m_keys(parse_json(text, path.string()));
  } catch (const InputError&) {
    return text.find("\"raw_data\"") != std::string_view::npos;
  }
}

U3mFile read_u3m_file(const fs::path& path) {
  std::string bytes = read_text_file(path);
  if (is_zip(bytes)) return read_archive(path);
  Document document = parse_json(decode_text(std::move(bytes), {}, path.string()), path.string());
  return follow(std::move(document),
                [&](const std::string& name) { return read_json(path.parent_path() / name); });
}

}  // namespace pliant
