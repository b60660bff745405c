#include "pliant/exchange/u3m_info.h"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/assert.h"
#include "pliant/base/number_text.h"

namespace pliant {
namespace {

using Entries = std::vector<std::pair<std::string, std::string>>;

constexpr std::string_view kDirections[] = {"L", "W", "B"};
constexpr std::string_view kTests[] = {"S2", "S1", "D2", "D1", "U1"};
constexpr std::string_view kVendorParameters[] = {
    "stretch", "stretch_linearity", "shear",    "shear_linearity",
    "bend",    "hysteresis",        "friction", "thickness"};

using Path = std::initializer_list<std::string_view>;

std::string text_at(const std::optional<Value>& root, Path path) {
  const std::optional<Value> value = find_value(root, path);
  return value && value->is_scalar() ? value->text() : std::string();
}

void add_entry(Entries& entries, const std::string& key, const std::string& text) {
  if (!text.empty()) entries.emplace_back(key, text);
}

/// Different paths of a file may give the same key: the first one keeps it.
void drop_repeated_keys(Entries& entries) {
  std::set<std::string> seen;
  std::erase_if(entries, [&](const auto& entry) { return !seen.insert(entry.first).second; });
}

/// The vendor's name and its section of `custom`. Nothing when the section is kept encrypted.
std::optional<std::pair<std::string, Value>> vendor_section(const Value& physics) {
  const std::optional<Value> custom = find_value(physics, {"custom"});
  if (!custom || !custom->is_mapping()) return std::nullopt;
  Fields vendors = custom->fields();
  for (const auto& [name, section] : vendors.all()) {
    if (section.is_mapping()) return std::pair{name, section};
  }
  return std::nullopt;
}

/// "Cotton 95 %, Elastane 5 %" from a list of fibres, each with a name and a share of 1.
std::string composition_text(const std::optional<Value>& fibres, std::string_view name_key,
                             std::string_view share_key) {
  if (!fibres || !fibres->is_sequence()) return {};
  std::vector<std::string> texts;
  for (const Value& fibre : fibres->items()) {
    const std::string name = text_at(fibre, {name_key});
    if (name.empty()) continue;
    const std::optional<double> share = parse_number(text_at(fibre, {share_key}));
    texts.push_back(share ? fmt::format("{} {} %", name, format_number(100 * *share, 4)) : name);
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

void add_material_entries(const Value& material, Entries& entries) {
  add_entry(entries, "description", text_at(material, {"description"}));
  add_entry(entries, "material_type", text_at(material, {"physics", "material_type", "type"}));
  add_entry(entries, "construction", text_at(material, {"physics", "construction", "type"}));
  const auto parts = find_value(material, {"physics", "composition", "parts"});
  add_entry(entries, "composition", composition_text(parts, "type", "ratio"));
}

/// Every different text under `key` of the directions and of their tests.
std::string instrument_text(const Value& raw, std::string_view key) {
  std::vector<std::string> texts;
  const auto collect = [&](Path path) {
    const std::string text = text_at(raw, path);
    if (text.empty() || std::find(texts.begin(), texts.end(), text) != texts.end()) return;
    texts.push_back(text);
  };
  for (const std::string_view direction : kDirections) {
    collect({direction, key});
    for (const std::string_view test : kTests) collect({direction, test, key});
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string instrument_warnings(const Value& raw) {
  const auto warnings = find_value(raw, {"warnings"});
  if (!warnings || !warnings->is_mapping()) return {};
  std::vector<std::string> texts;
  Fields fields = warnings->fields();
  for (const auto& [name, value] : fields.all()) {
    if (value.is_scalar()) texts.push_back(fmt::format("{}: {}", name, value.text()));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// One entry for each number at or below `value`, named by its path.
void add_vendor_numbers(const std::string& name, const Value& value, Entries& entries) {
  if (value.is_mapping()) {
    Fields fields = value.fields();
    for (const auto& [key, inner] : fields.all()) {
      add_vendor_numbers(name + "_" + key, inner, entries);
    }
  } else if (value.is_scalar() && parse_number(value.text())) {
    entries.emplace_back(name, value.text() + " (vendor's own export)");
  }
}

void add_vendor_entries(const std::string& vendor, const Value& section, U3mInfo& info) {
  info.name = text_at(section, {"name"});
  add_entry(info.entries, "vendor", vendor);
  for (const char* key : {"company", "category"}) {
    add_entry(info.entries, key, text_at(section, {key}));
  }
  add_entry(info.entries, "composition",
            composition_text(find_value(section, {"composition"}), "fiber_name", "percentage"));
}

void add_vendor_parameters(const Value& section, Entries& entries) {
  for (const std::string_view key : kVendorParameters) {
    if (const auto value = find_value(section, {key})) {
      add_vendor_numbers(fmt::format("vendor_{}", key), *value, entries);
    }
  }
}

}  // namespace

U3mInfo read_u3m_info(const U3mFile& file) {
  const std::optional<Value> physics = find_physics(file.physics);
  PLIANT_ASSERT(physics.has_value(), "the file has a physics record");
  U3mInfo info;
  const auto vendor = vendor_section(*physics);
  if (vendor) add_vendor_entries(vendor->first, vendor->second, info);

  if (const auto material = find_material(file)) {
    if (std::string name = text_at(material, {"name"}); !name.empty()) info.name = std::move(name);
    add_material_entries(*material, info.entries);
  }
  if (const auto raw = find_value(physics, {"raw_data"})) {
    add_entry(info.entries, "hardware_serial", instrument_text(*raw, "hwSerialNumber"));
    add_entry(info.entries, "hardware_version", instrument_text(*raw, "hwVersion"));
    add_entry(info.entries, "test_version", instrument_text(*raw, "testVersion"));
    add_entry(info.entries, "instrument_warnings", instrument_warnings(*raw));
  }
  if (vendor) {
    add_vendor_parameters(vendor->second, info.vendor_parameters);
    drop_repeated_keys(info.vendor_parameters);
  }
  return info;
}

}  // namespace pliant
