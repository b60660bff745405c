#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace pliant {

/// @throws InputError for a file that cannot be read or is not JSON
nlohmann::json read_json_file(const std::filesystem::path& file);

/// Typed access to one JSON object of a results file; every mismatch is an InputError that names
/// the file and the dotted path of the field. The JSON value must outlive the reader.
class JsonObject {
 public:
  JsonObject(const nlohmann::json& value, std::string file, std::string path);

  bool has(std::string_view key) const;  ///< present and not null

  std::string text(std::string_view key) const;  ///< throws where absent
  std::string text_or(std::string_view key, std::string_view fallback) const;
  /// The name of a file; results are read from their directory only, whatever the file names.
  std::string relative_file_or(std::string_view key, std::string_view fallback) const;
  bool flag_or(std::string_view key, bool fallback) const;
  int integer_or(std::string_view key, int fallback) const;
  std::optional<double> number(std::string_view key) const;  ///< none where absent or null

  std::optional<JsonObject> object(std::string_view key) const;
  std::vector<JsonObject> objects(std::string_view key) const;  ///< empty where absent
  std::vector<std::string> texts(std::string_view key) const;
  std::vector<double> numbers(std::string_view key) const;  ///< NaN for null
  std::vector<std::vector<double>> number_rows(std::string_view key) const;
  /// A mapping of free text; values that are no strings are given as they stand in the file.
  std::map<std::string, std::string> entries(std::string_view key) const;

  [[noreturn]] void fail(std::string_view key, std::string problem, std::string expected) const;

 private:
  const nlohmann::json* find(std::string_view key) const;
  const nlohmann::json& list(std::string_view key) const;
  std::vector<double> number_list(const nlohmann::json& value, std::string_view key) const;

  const nlohmann::json* value_;
  std::string file_;
  std::string path_;
};

}  // namespace pliant
