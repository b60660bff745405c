#include "pliant/io/fields.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/base/nearest_name.h"
#include "pliant/base/number_text.h"

namespace pliant {
namespace {

const char* kind_text(Node::Kind kind) {
  switch (kind) {
    case Node::Kind::null:
      return "has no value";
    case Node::Kind::scalar:
      return "is a single value";
    case Node::Kind::sequence:
      return "is a list";
    case Node::Kind::mapping:
      return "is a mapping";
  }
  return "";
}

const Node* find_field(const Node& mapping, std::string_view key) {
  const auto found = std::find_if(mapping.fields.begin(), mapping.fields.end(),
                                  [&](const Node::Field& field) { return field.key == key; });
  return found == mapping.fields.end() ? nullptr : &found->value;
}

}  // namespace

Value::Value(const Document& document) : Value(document, document.root, {}) {}

Value::Value(const Document& document, const Node& node, std::string path)
    : document_(&document), node_(&node), path_(std::move(path)) {}

Location Value::location() const { return {document_->file, node_->line, path_}; }

void Value::fail(const std::string& problem, const std::string& expected) const {
  throw InputError(location(), problem, expected);
}

void Value::fail_kind(const std::string& expected) const {
  fail(missing_ ? *missing_ : kind_text(kind()), expected);
}

const std::string& Value::scalar(const std::string& expected) const {
  if (!is_scalar()) fail_kind(expected);
  return node_->text;
}

std::string Value::text(const std::string& expected) const { return scalar(expected); }

double Value::number() const {
  const std::string& text = scalar("a number");
  const std::optional<double> value = parse_number(trimmed(text));
  if (!value) fail(quoted_value(text) + " is not a finite number", "a number");
  return *value;
}

double Value::quantity(Dimension dimension) const {
  const std::string expected = expected_quantity(dimension);
  try {
    return parse_quantity(scalar(expected), dimension);
  } catch (const QuantityError& error) {
    fail(error.problem(), error.expected());
  }
}

double Value::positive_quantity(Dimension dimension) const {
  const double si = quantity(dimension);
  if (si <= 0) fail("is not positive", "a value above 0");
  return si;
}

double Value::quantity_from_zero(Dimension dimension) const {
  const double si = quantity(dimension);
  if (si < 0) fail("is negative", "a value of at least 0");
  return si;
}

bool Value::flag() const {
  const std::string& text = scalar("true or false");
  if (text != "true" && text != "false") fail(quoted_value(text), "true or false");
  return text == "true";
}

int Value::integer(int low, int high) const {
  const std::string expected = fmt::format("a whole number from {} to {}", low, high);
  const std::string& text = scalar(expected);
  const std::optional<long> value = parse_integer(trimmed(text));
  if (!value || *value < low || *value > high) fail(quoted_value(text), expected);
  return static_cast<int>(*value);
}

std::string Value::choice(std::span<const std::string_view> allowed) const {
  const std::vector<std::string> names(allowed.begin(), allowed.end());
  const std::string text = scalar(list_of_names(names));
  if (std::find(allowed.begin(), allowed.end(), text) != allowed.end()) return text;
  fail(quoted_value(text) + did_you_mean(text, names), list_of_names(names));
}

std::string Value::choice(std::initializer_list<std::string_view> allowed) const {
  return choice(std::span(allowed.begin(), allowed.size()));
}

std::vector<Value> Value::items() const {
  if (!is_sequence()) fail_kind("a list");
  std::vector<Value> items;
  items.reserve(node_->items.size());
  for (const Node& item : node_->items) {
    items.push_back(Value(*document_, item, fmt::format("{}[{}]", path_, items.size())));
  }
  return items;
}

std::vector<double> Value::numbers() const {
  if (!is_sequence()) fail_kind("a list of numbers");
  std::vector<double> numbers;
  numbers.reserve(node_->items.size());
  for (const Node& item : node_->items) {
    const std::optional<double> value =
        item.kind == Node::Kind::scalar ? parse_number(trimmed(item.text)) : std::nullopt;
    // `number` finds the words for what is wrong.
    numbers.push_back(
        value ? *value
              : Value(*document_, item, fmt::format("{}[{}]", path_, numbers.size())).number());
  }
  return numbers;
}

Fields Value::fields() const {
  if (!is_mapping()) fail_kind("a mapping (KEY: VALUE)");
  return Fields(*this);
}

std::string Fields::path_of(std::string_view key) const {
  return mapping_.path_.empty() ? std::string(key) : fmt::format("{}.{}", mapping_.path_, key);
}

Value Fields::require(std::string_view key) {
  asked_.emplace(key);
  const Node* node = find_field(*mapping_.node_, key);
  if (node != nullptr) return Value(*mapping_.document_, *node, path_of(key));
  Value missing(*mapping_.document_, *mapping_.node_, path_of(key));
  missing.missing_ = "is missing" + did_you_mean_by(key);
  return missing;
}

std::string Fields::did_you_mean_by(std::string_view key) const {
  std::vector<std::string> others;
  for (const auto& [other, node] : mapping_.node_->fields) {
    if (!asked_.contains(other)) others.push_back(other);
  }
  const std::string near = nearest_name(key, others);
  return near.empty() ? near : fmt::format(" (did you mean it by `{}`?)", near);
}

std::optional<Value> Fields::optional(std::string_view key) {
  asked_.emplace(key);
  const Node* node = find_field(*mapping_.node_, key);
  if (node == nullptr || node->kind == Node::Kind::null) return std::nullopt;
  return Value(*mapping_.document_, *node, path_of(key));
}

std::vector<std::string> Fields::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, node] : mapping_.node_->fields) keys.push_back(key);
  return keys;
}

std::map<std::string, std::string> Fields::texts(std::string_view key) {
  std::map<std::string, std::string> texts;
  const std::optional<Value> node = optional(key);
  if (!node) return texts;
  Fields inner = node->fields();
  for (const auto& [name, value] : inner.all()) texts[name] = value.text();
  return texts;
}

std::vector<std::pair<std::string, Value>> Fields::all() {
  std::vector<std::pair<std::string, Value>> values;
  for (const auto& [key, node] : mapping_.node_->fields) {
    asked_.insert(key);
    values.emplace_back(key, Value(*mapping_.document_, node, path_of(key)));
  }
  return values;
}

void Fields::finish() const {
  const std::vector<std::string> known(asked_.begin(), asked_.end());
  for (const auto& [key, node] : mapping_.node_->fields) {
    if (asked_.contains(key)) continue;
    throw InputError({location().file, node.line, path_of(key)},
                     "unknown key" + did_you_mean(key, known), list_of_names(known));
  }
}

void require_document(Fields& fields, std::string_view type, int version) {
  const std::string expected = fmt::format("\"{}/{}\"", type, version);
  const Value value = fields.require("pliant");
  const std::string found = value.text(expected);
  const std::size_t slash = found.find('/');
  const std::string_view found_type = std::string_view(found).substr(0, slash);
  const std::string_view found_version =
      slash == std::string::npos ? std::string_view() : std::string_view(found).substr(slash + 1);
  if (found_type != type) {
    value.fail(fmt::format("this is a {} document", quoted_value(found)), expected);
  }
  if (found_version != std::to_string(version)) {
    value.fail(fmt::format("unknown version {}", quoted_value(found_version)), expected);
  }
}

std::optional<std::string> document_type(const Document& document) {
  if (document.root.kind != Node::Kind::mapping) return std::nullopt;
  const Node* type = find_field(document.root, "pliant");
  if (type == nullptr || type->kind != Node::Kind::scalar) return std::nullopt;
  return type->text;
}

}  // namespace pliant
