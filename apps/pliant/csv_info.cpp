#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/nearest_name.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/exchange/tester_study.h"
#include "pliant/experiment/standard_figures.h"
#include "pliant/experiment/understood_columns.h"
#include "pliant/study/blank_fields.h"

#include "apps/pliant/file_info.h"

namespace pliant {
namespace {

constexpr int kDigits = 6;

std::string range_text(const std::vector<double>& values, const std::string& unit) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return fmt::format("{} to {}{}{}", format_number(*low, kDigits), format_number(*high, kDigits),
                     unit.empty() ? "" : " ", unit);
}

/// The numbers of a column; none where a cell holds something else. Empty cells are left out:
/// result tables use them for numbers that do not exist.
std::optional<std::vector<double>> plain_numbers(const CsvTable& table,
                                                 const std::vector<std::string>& cells) {
  std::vector<double> numbers;
  for (const std::string& cell : cells) {
    if (trimmed(cell).empty()) continue;
    const std::optional<double> number = table.number_of_cell(trimmed(cell));
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
  if (const auto numbers = plain_numbers(table, cells)) {
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

/// A table alone tells neither how the test was set up nor what the cloth weighs.
void add_standard_figures(const TestType& type, const TesterFile& file, FileInfo& info) {
  DataSource source;
  source.files = {file.path};
  source.csv = file.csv;
  const StandardFigures figures = type.standard_figures(DataRows(source), nullptr, 0);
  info.json[figures.key] = figures.json;
  for (const std::string& text : figures.texts) info.lines.push_back(labelled(figures.label, text));
}

/// Which sheet of a workbook is described.
void add_sheet(const TesterFile& file, FileInfo& info) {
  if (file.sheets.empty()) return;
  const std::string& sheet = file.csv.sheet.empty() ? file.sheets.front() : file.csv.sheet;
  info.json["sheet"] = sheet;
  info.json["sheets"] = file.sheets;
  const std::string others =
      file.sheets.size() == 1
          ? std::string()
          : fmt::format(" (of {}; `--sheet NAME` takes another)", list_of_names(file.sheets));
  info.lines.push_back(labelled("sheet", sheet + others));
}

/// What stands above the table, and how its rows go to and fro.
void add_tester(const TesterFile& file, FileInfo& info) {
  if (!file.csv.encoding.empty()) info.lines.push_back(labelled("encoding", file.csv.encoding));
  info.json["specimens"] = file.specimens;
  info.json["passes"] = file.passes ? Json(*file.passes) : Json(nullptr);
  if (file.specimens > 1) {
    info.lines.push_back(labelled("specimens", fmt::format("{}", file.specimens)));
  }
  if (file.passes) {
    info.lines.push_back(labelled("ways to and fro", fmt::format("{}", *file.passes)));
  }
  info.json["facts"] = Json::object();
  for (const TesterFact& fact : file.facts) {
    info.json["facts"][fact.field] = fact.value;
    info.lines.push_back(labelled(fact.field, fmt::format("{} (line {}: {})", fact.value, fact.line,
                                                          one_line(fact.written, 60))));
  }
}

void add_footer(const CsvTable& table, FileInfo& info) {
  if (table.footer().empty()) return;
  info.json["footer"] = table.footer();
  info.lines.push_back(labelled("below the rows", one_line(table.footer(), 60) + " (left out)"));
}

/// The lines of a study that take the table; none where nothing of a test was recognised.
void add_study_lines(const TesterFile& file, FileInfo& info) {
  const bool recognised =
      file.is_type_known ||
      std::ranges::any_of(file.columns, [](const auto& column) { return column.second != kBlank; });
  if (!recognised) return;
  const std::string text = experiment_lines(std::span(&file, 1));
  info.json["study"] = text;
  info.lines.push_back("for a study (`pliant init --from` writes all of it):");
  info.lines.push_back("experiments:\n" + text.substr(0, text.size() - 1));
}

}  // namespace

FileInfo csv_info(const std::filesystem::path& path, const CsvOptions& reading) {
  const TesterFile file = read_tester_file(path, reading);
  const CsvTable table = read_csv(path, file.csv);
  const UnderstoodColumns understood = understood_columns(table);
  FileInfo info = begin_info(path, file.sheets.empty() ? "csv" : "workbook");
  add_sheet(file, info);
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
    if (type->standard_figures) add_standard_figures(*type, file, info);
  }
  add_tester(file, info);
  add_footer(table, info);
  add_study_lines(file, info);
  info.json["warnings"] = info.warnings;
  return info;
}

}  // namespace pliant
