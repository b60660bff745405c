#include "pliant/io/json_object.h"

#include <limits>

#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/io/text_file.h"

namespace pliant {

nlohmann::json read_json_file(const std::filesystem::path& file) {
  const std::string text = read_text_file(file);
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw InputError({file.string(), 0, {}}, std::string("not valid JSON (") + error.what() + ")",
                     "a complete results file");
  }
}

JsonObject::JsonObject(const nlohmann::json& value, std::string file, std::string path)
    : value_(&value), file_(std::move(file)), path_(std::move(path)) {
  if (!value.is_object()) {
    throw InputError({file_, 0, path_}, "not a JSON object", "an object");
  }
}

void JsonObject::fail(std::string_view key, std::string problem, std::string expected) const {
  const std::string field = path_.empty() ? std::string(key) : path_ + "." + std::string(key);
  throw InputError({file_, 0, field}, std::move(problem), std::move(expected));
}

const nlohmann::json* JsonObject::find(std::string_view key) const {
  const auto it = value_->find(key);
  return it == value_->end() || it->is_null() ? nullptr : &*it;
}

bool JsonObject::has(std::string_view key) const { return find(key) != nullptr; }

std::string JsonObject::text(std::string_view key) const {
  const nlohmann::json* value = find(key);
  if (value == nullptr) fail(key, "missing", "a text");
  if (!value->is_string()) fail(key, "not a text", "a text");
  return value->get<std::string>();
}

std::string JsonObject::text_or(std::string_view key, std::string_view fallback) const {
  return has(key) ? text(key) : std::string(fallback);
}

std::string JsonObject::relative_file_or(std::string_view key, std::string_view fallback) const {
  const std::string name = text_or(key, fallback);
  const std::filesystem::path path(name);
  bool inside = path.is_relative();
  for (const auto& part : path) inside = inside && part != "..";
  if (!inside) fail(key, "leaves the results directory", "a relative path");
  return name;
}

bool JsonObject::flag_or(std::string_view key, bool fallback) const {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return fallback;
  if (!value->is_boolean()) fail(key, "not a truth value", "true or false");
  return value->get<bool>();
}

int JsonObject::integer_or(std::string_view key, int fallback) const {
  const std::optional<double> value = number(key);
  if (!value) return fallback;
  if (*value < 0 || *value > std::numeric_limits<int>::max()) {
    fail(key, "out of range", "a count");
  }
  return static_cast<int>(*value);
}

std::optional<double> JsonObject::number(std::string_view key) const {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (!value->is_number()) fail(key, "not a number", "a number or null");
  return value->get<double>();
}

std::optional<JsonObject> JsonObject::object(std::string_view key) const {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return std::nullopt;
  return JsonObject(*value, file_,
                    path_.empty() ? std::string(key) : path_ + "." + std::string(key));
}

const nlohmann::json& JsonObject::list(std::string_view key) const {
  static const nlohmann::json kEmpty = nlohmann::json::array();
  const nlohmann::json* value = find(key);
  if (value == nullptr) return kEmpty;
  if (!value->is_array()) fail(key, "not a list", "a list");
  return *value;
}

std::vector<JsonObject> JsonObject::objects(std::string_view key) const {
  const std::string prefix = path_.empty() ? std::string(key) : path_ + "." + std::string(key);
  std::vector<JsonObject> readers;
  for (const nlohmann::json& item : list(key)) {
    readers.emplace_back(item, file_, prefix + "[" + std::to_string(readers.size()) + "]");
  }
  return readers;
}

std::vector<std::string> JsonObject::texts(std::string_view key) const {
  std::vector<std::string> texts;
  for (const nlohmann::json& item : list(key)) {
    if (!item.is_string()) fail(key, "an item is not a text", "a list of texts");
    texts.push_back(item.get<std::string>());
  }
  return texts;
}

std::vector<double> JsonObject::number_list(const nlohmann::json& value,
                                            std::string_view key) const {
  if (!value.is_array()) fail(key, "not a list of numbers", "a list of numbers");
  std::vector<double> numbers;
  for (const nlohmann::json& item : value) {
    if (!item.is_number() && !item.is_null()) fail(key, "an item is not a number", "numbers");
    numbers.push_back(item.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                     : item.get<double>());
  }
  return numbers;
}

std::vector<double> JsonObject::numbers(std::string_view key) const {
  return number_list(list(key), key);
}

std::vector<std::vector<double>> JsonObject::number_rows(std::string_view key) const {
  std::vector<std::vector<double>> rows;
  for (const nlohmann::json& row : list(key)) rows.push_back(number_list(row, key));
  return rows;
}

std::map<std::string, std::string> JsonObject::entries(std::string_view key) const {
  std::map<std::string, std::string> entries;
  const nlohmann::json* value = find(key);
  if (value == nullptr) return entries;
  if (!value->is_object()) fail(key, "not an object", "an object of texts");
  for (const auto& [name, item] : value->items()) {
    entries.emplace(name, item.is_string() ? item.get<std::string>() : item.dump());
  }
  return entries;
}

}  // namespace pliant
