#include "pliant/io/result_manifest.h"

#include <algorithm>
#include <system_error>

#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/io/atomic_file.h"
#include "pliant/io/document.h"
#include "pliant/io/fields.h"

namespace pliant {
namespace {

constexpr int kManifestVersion = 1;

}  // namespace

bool is_safe_relative_name(const std::string& name) {
  const std::filesystem::path path(name);
  return !path.empty() && path.is_relative() && path.has_filename() &&
         std::none_of(path.begin(), path.end(),
                      [](const auto& part) { return part == ".." || part == "."; });
}

std::optional<ResultManifest> read_manifest(const std::filesystem::path& directory) {
  const std::filesystem::path path = directory / kManifestName;
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return std::nullopt;
  const Document document = read_json(path);
  Fields fields = Value(document).fields();
  require_document(fields, "results", kManifestVersion);
  ResultManifest manifest;
  manifest.command = fields.require("command").text();
  for (const Value& file : fields.require("files").items()) {
    const std::string name = file.text();
    if (!is_safe_relative_name(name)) file.fail(quoted_value(name), "a name inside the folder");
    manifest.files.insert(name);
  }
  fields.finish();
  return manifest;
}

std::string manifest_text(const ResultManifest& manifest) {
  nlohmann::ordered_json json;
  json["pliant"] = "results/" + std::to_string(kManifestVersion);
  json["command"] = manifest.command;
  json["files"] = manifest.files;
  // File names need not be UTF-8; what is not is replaced rather than refused.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

void list_result(const std::filesystem::path& directory, const std::string& name) {
  std::optional<ResultManifest> manifest = read_manifest(directory);
  if (!manifest || !manifest->files.insert(name).second) return;
  write_file_atomically(directory / kManifestName, manifest_text(*manifest));
}

}  // namespace pliant
