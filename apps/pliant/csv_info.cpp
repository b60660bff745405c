#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/registry.h"
#include "pliant/experiment/standard_figures.h"
#include "pliant/io/csv.h"
#include "pliant/measurement/column_synonyms.h"

#include "apps/pliant/file_info.h"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDigits = 6;

struct KnownQuantity {
  const char* name;
  std::vector<Dimension> dimensions;  ///< that its unit may have
};

/// The quantities that the experiments' data files hold (docs/formats/tables.md).
const std::vector<KnownQuantity>& known_quantities() {
  using enum Dimension;
  static const std::vector<KnownQuantity> quantities{
      {"force", {Dimension::force, force_per_length}},
      {"length", {Dimension::length}},
      {"extension", {Dimension::length}},
      {"strain", {fraction}},
      {"weight", {Dimension::force, mass}},
      {"peak", {Dimension::force}},
      {"angle", {Dimension::angle}},
      {"time", {Dimension::time}},
      {"distance", {Dimension::length}},
      {"curvature", {Dimension::curvature}},
      {"moment", {Dimension::force}},
      {"overhang", {Dimension::length}},
      {"radius", {Dimension::length}},
      {"x", {Dimension::length}},
      {"y", {Dimension::length}},
      {"depth", {Dimension::length}},
      {"area", {Dimension::area}},
      {"nominal_stress", {Dimension::stress}}};
  return quantities;
}

/// What a column was understood to be.
struct UnderstoodColumn {
  std::string quantity;
  std::string unit;
  Dimension dimension = Dimension::number;
};

/// By header. A quantity without a unit is a plain column: an experiment would refuse it.
std::map<std::string, UnderstoodColumn> understood_columns(const CsvTable& table) {
  std::map<std::string, UnderstoodColumn> columns;
  for (const auto& [name, dimensions] : known_quantities()) {
    for (const Dimension dimension : dimensions) {
      const std::optional<std::string> header = table.quantity_column(name, dimension);
      if (!header || columns.contains(*header)) continue;
      const std::string unit = *table.quantity_unit(name, dimension);
      if (unit_conversion(unit, dimension)) columns[*header] = {name, unit, dimension};
    }
  }
  return columns;
}

std::string range_text(const std::vector<double>& values, const std::string& unit) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return fmt::format("{} to {}{}{}", format_number(*low, kDigits), format_number(*high, kDigits),
                     unit.empty() ? "" : " ", unit);
}

/// The numbers of a column; none where a cell holds something else. Empty cells are left out:
/// result tables use them for numbers that do not exist.
std::optional<std::vector<double>> plain_numbers(const std::vector<std::string>& cells) {
  std::vector<double> numbers;
  for (const std::string& cell : cells) {
    if (trimmed(cell).empty()) continue;
    const std::optional<double> number = parse_number(trimmed(cell));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers.empty() ? std::nullopt : std::optional(numbers);
}

void add_range(const std::vector<double>& values, Json& json) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  json["min"] = *low;
  json["max"] = *high;
}

void add_quantity(const CsvTable& table, const std::string& header, const UnderstoodColumn& column,
                  FileInfo& info) {
  const std::vector<double> values = table.quantity(column.quantity, column.dimension);  // SI
  Json json{{"header", header},
            {"quantity", column.quantity},
            {"dimension", dimension_name(column.dimension)},
            {"unit", column.unit},
            {"si_unit", si_unit(column.dimension)}};
  add_range(values, json);
  info.json["columns"].push_back(std::move(json));
  const UnitConversion unit = *unit_conversion(column.unit, column.dimension);
  std::vector<double> shown;
  for (const double value : values) shown.push_back((value - unit.offset) / unit.scale);
  info.lines.push_back(
      labelled(header,
               fmt::format("{} ({}), {}", column.quantity, dimension_name(column.dimension),
                           range_text(shown, column.unit)),
               1));
}

void add_other(const CsvTable& table, const std::string& header, FileInfo& info) {
  const std::vector<std::string> cells = table.texts(header);
  Json json{{"header", header}, {"quantity", nullptr}};
  std::string text;
  if (const auto numbers = plain_numbers(cells)) {
    add_range(*numbers, json);
    text = "numbers, " + range_text(*numbers, "");
  } else {
    const std::set<std::string> different(cells.begin(), cells.end());
    const bool empty = different.size() == 1 && different.begin()->empty();
    json["different_texts"] = empty ? 0 : different.size();
    text = empty ? "empty" : fmt::format("texts, {} different", different.size());
  }
  info.json["columns"].push_back(std::move(json));
  info.lines.push_back(labelled(header, text, 1));
}

/// Understood columns, as types of tests ask for them.
class UnderstoodColumns : public TableColumns {
 public:
  explicit UnderstoodColumns(const std::map<std::string, UnderstoodColumn>& columns)
      : columns_(columns) {}

  bool has(std::string_view quantity, Dimension dimension) const override {
    return std::any_of(columns_.begin(), columns_.end(), [&](const auto& entry) {
      return entry.second.quantity == quantity && entry.second.dimension == dimension;
    });
  }

 private:
  const std::map<std::string, UnderstoodColumn>& columns_;
};

/// Types of tests whose columns are all there, in their dimensions.
std::vector<const TestType*> usable_types(const std::map<std::string, UnderstoodColumn>& columns) {
  std::vector<const TestType*> types;
  for (const TestType* type : test_types()) {
    if (type->is_table && type->is_table(UnderstoodColumns(columns))) types.push_back(type);
  }
  return types;
}

/// A table alone tells neither how the test was set up nor what the cloth weighs.
void add_standard_figures(const TestType& type, const std::filesystem::path& path, FileInfo& info) {
  DataSource source;
  source.files = {path};
  source.csv.synonyms = column_synonyms();
  const StandardFigures figures = type.standard_figures(DataRows(source), nullptr, 0);
  info.json[figures.key] = figures.json;
  for (const std::string& text : figures.texts) info.lines.push_back(labelled(figures.label, text));
}

}  // namespace

FileInfo csv_info(const std::filesystem::path& path) {
  const CsvTable table = read_csv(path, {.synonyms = column_synonyms()});
  const auto understood = understood_columns(table);
  FileInfo info = begin_info(path, "csv");
  info.json["rows"] = table.rows();
  info.json["header_line"] = table.header_line();
  info.json["columns"] = Json::array();
  info.lines.push_back(labelled("rows", fmt::format("{}", table.rows())));
  info.lines.push_back(labelled("columns", fmt::format("{}", table.headers().size())));
  for (const std::string& header : table.headers()) {
    if (header.empty()) continue;
    const auto found = understood.find(header);
    if (found != understood.end()) {
      add_quantity(table, header, found->second, info);
    } else {
      add_other(table, header, info);
    }
  }
  const std::vector<const TestType*> types = usable_types(understood);
  std::vector<std::string_view> names;
  for (const TestType* type : types) names.push_back(type->name);
  info.json["usable_as"] = names;
  info.lines.push_back(labelled("usable as data of",
                                names.empty() ? "no test without a map of its columns (`columns:`)"
                                              : fmt::format("{}", fmt::join(names, ", "))));
  for (const TestType* type : types) {
    if (type->standard_figures) add_standard_figures(*type, path, info);
  }
  info.json["warnings"] = info.warnings;
  return info;
}

}  // namespace pliant
