#include "pliant/io/csv.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/letter_case.h"
#include "pliant/base/nearest_name.h"
#include "pliant/base/number_text.h"

namespace pliant {
namespace {

constexpr std::size_t kMaxUnitSize = 40;  // no unit is longer

/// "Load (N)" -> "N", "Load[N]" -> "N"; none when the header does not end in brackets.
std::optional<std::string_view> bracketed_unit(std::string_view header) {
  if (header.empty()) return std::nullopt;
  const char open = header.back() == ')' ? '(' : header.back() == ']' ? '[' : '\0';
  const std::size_t begin = open == '\0' ? std::string_view::npos : header.rfind(open);
  if (begin == std::string_view::npos) return std::nullopt;
  return trimmed(header.substr(begin + 1, header.size() - begin - 2));
}

/// The unit at the end of a header: in brackets, or the longest unit after a space or underscore
/// ("Force_N_per_m" ends in N_per_m, not in m). Empty when there is none.
std::string unit_of_header(std::string_view header) {
  if (const auto unit = bracketed_unit(header)) return std::string(*unit);
  const std::size_t first = header.size() - std::min(header.size(), kMaxUnitSize);
  for (std::size_t at = header.find_first_of(" _", first); at != std::string_view::npos;
       at = header.find_first_of(" _", at + 1)) {
    const std::string_view ending = header.substr(at + 1);
    if (is_unit(ending)) return std::string(ending);
  }
  return {};
}

/// "1,234.5" and "1.234,5": a separator of thousands, and another one of decimals.
bool has_thousands_separator(std::string_view cell) {
  const auto commas = std::ranges::count(cell, ',');
  const auto points = std::ranges::count(cell, '.');
  if (cell.find_first_not_of("+-.,0123456789") != std::string_view::npos) return false;
  return (commas > 0 && points > 0) || commas > 1 || points > 1;
}

std::string problem_of_number(std::string_view cell) {
  if (cell.empty()) return "the cell is empty";
  return quoted_value(cell) +
         (has_thousands_separator(cell) ? " has a thousands separator" : " is not a finite number");
}

/// The unit of a header that names the quantity `name`, as NAME_UNIT, NAME (UNIT), NAME [UNIT],
/// NAME / UNIT, NAME in UNIT, or NAME alone (empty); none when the header is something else.
std::optional<std::string> unit_of_quantity(std::string_view header, std::string_view name) {
  if (header.size() < name.size() || !same_letters(header.substr(0, name.size()), name)) {
    return std::nullopt;
  }
  const std::string_view rest = header.substr(name.size());
  if (rest.empty()) return std::string();
  const std::string_view words = trimmed(rest);
  if (words.empty()) return std::string();
  if (words.front() == '(' || words.front() == '[') {
    const auto unit = bracketed_unit(words);
    return unit ? std::optional<std::string>(*unit) : std::nullopt;
  }
  for (const std::string_view before : {"_", "/", ",", " in ", " "}) {
    if (!rest.starts_with(before) && !words.starts_with(before)) continue;
    const std::string_view start = rest.starts_with(before) ? rest : words;
    const std::string_view unit = trimmed(start.substr(before.size()));
    if (is_unit(unit)) return std::string(unit);
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> CsvTable::headers() const {
  std::vector<std::string> headers;
  for (const Column& column : columns_) headers.push_back(column.header);
  return headers;
}

bool CsvTable::has(std::string_view column) const { return find_column(column).has_value(); }

std::optional<std::string> CsvTable::quantity_column(std::string_view name,
                                                     std::optional<Dimension> dimension) const {
  const std::optional<QuantityColumn> column = find_quantity(name, dimension);
  return column ? std::optional(columns_[column->index].header) : std::nullopt;
}

std::optional<std::string> CsvTable::only_column_in(Dimension dimension) const {
  std::optional<std::string> found;
  for (const Column& column : columns_) {
    const std::string unit = column.unit.empty() ? unit_of_header(column.header) : column.unit;
    if (unit.empty() || !unit_conversion(unit, dimension)) continue;
    if (found) return std::nullopt;
    found = column.header;
  }
  return found;
}

std::optional<std::string> CsvTable::quantity_unit(std::string_view name,
                                                   std::optional<Dimension> dimension) const {
  const std::optional<QuantityColumn> column = find_quantity(name, dimension);
  return column ? std::optional(column->unit) : std::nullopt;
}

std::vector<double> CsvTable::quantity(std::string_view name, Dimension dimension) const {
  std::optional<std::vector<double>> values = optional_quantity(name, dimension);
  if (values) return *std::move(values);
  const std::vector<std::string> units = units_of(dimension);
  const std::string suffix = units.empty() ? "" : fmt::format("_UNIT ({})", fmt::join(units, ", "));
  fail_missing(name, fmt::format("a column {}{}", name, suffix));
}

std::optional<std::vector<double>> CsvTable::optional_quantity(std::string_view name,
                                                               Dimension dimension) const {
  const std::optional<QuantityColumn> column = find_quantity(name, dimension);
  if (!column) return std::nullopt;
  const std::string& header = columns_[column->index].header;
  if (!mapping_.contains(std::string(name)) && !unit_of_quantity(header, name)) {
    found_[std::string(name)] = header;
  }
  const UnitConversion conversion = conversion_of(*column, dimension);
  std::vector<double> values = read_numbers(column->index);
  for (double& value : values) value = conversion.to_si(value);
  return values;
}

std::vector<double> CsvTable::numbers(std::string_view name) const {
  return read_numbers(require_column(name));
}

std::vector<long> CsvTable::integers(std::string_view name) const {
  const std::size_t column = require_column(name);
  used_.insert(column);
  std::vector<long> values;
  values.reserve(rows());
  for (std::size_t row = 0; row < rows(); ++row) {
    const std::optional<long> value = parse_integer(trimmed(cell(row, column)));
    if (!value) fail(lines_[row], column, quoted_value(cell(row, column)), "a whole number");
    values.push_back(*value);
  }
  return values;
}

std::vector<std::string> CsvTable::texts(std::string_view name) const {
  const std::size_t column = require_column(name);
  used_.insert(column);
  std::vector<std::string> values;
  values.reserve(rows());
  for (std::size_t row = 0; row < rows(); ++row) values.emplace_back(cell(row, column));
  return values;
}

std::vector<std::string> CsvTable::unused_columns() const {
  std::vector<std::string> unused;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (!used_.contains(i) && !columns_[i].header.empty()) unused.push_back(columns_[i].header);
  }
  return unused;
}

std::string_view CsvTable::cell(std::size_t row, std::size_t column) const {
  const Cell& cell = cells_[row * columns_.size() + column];
  return std::string_view(text_).substr(cell.begin, cell.size);
}

std::optional<std::size_t> CsvTable::find_header(std::string_view header) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].header == header) return i;
  }
  return std::nullopt;
}

std::vector<std::string> CsvTable::names_for(std::string_view name) const {
  std::vector<std::string> names{std::string(name)};
  const auto others = synonyms_.find(names.front());
  if (others != synonyms_.end()) {
    names.insert(names.end(), others->second.begin(), others->second.end());
  }
  return names;
}

std::optional<std::size_t> CsvTable::find_told_header(std::string_view header) const {
  if (const auto column = find_header(header)) return column;
  const auto alike = std::ranges::find_if(
      columns_, [&](const Column& column) { return same_letters(column.header, header); });
  if (alike != columns_.end()) return static_cast<std::size_t>(alike - columns_.begin());
  const std::optional<long> number = parse_integer(header);
  const bool exists = number && *number >= 1 && *number <= static_cast<long>(columns_.size());
  return exists ? std::optional(static_cast<std::size_t>(*number - 1)) : std::nullopt;
}

CsvTable::QuantityColumn CsvTable::mapped_column(const std::string& name,
                                                 const std::string& header) const {
  if (const auto column = find_told_header(header)) return {*column, {}};
  if (const auto unit = bracketed_unit(header)) {
    const std::string_view rest =
        trimmed(std::string_view(header).substr(0, header.find_last_of("([")));
    if (const auto column = find_told_header(rest)) return {*column, std::string(*unit)};
  }
  const std::vector<std::string> known = headers();
  throw InputError(
      {file_, header_line_, name},
      fmt::format("there is no column {}{}", quoted_value(header), did_you_mean(header, known)),
      list_of_names(known));
}

std::optional<std::size_t> CsvTable::find_column(std::string_view name) const {
  const auto mapped = mapping_.find(std::string(name));
  if (mapped != mapping_.end()) return mapped_column(mapped->first, mapped->second).index;
  return find_header(name);
}

std::size_t CsvTable::require_column(std::string_view name) const {
  const std::optional<std::size_t> column = find_column(name);
  if (!column) fail_missing(name, fmt::format("a column {}", name));
  return *column;
}

std::optional<CsvTable::QuantityColumn> CsvTable::mapped_quantity(std::string_view name) const {
  std::optional<QuantityColumn> found;
  for (const auto& [our_name, header] : mapping_) {
    std::optional<std::string> stated = unit_of_quantity(our_name, name);
    if (!stated) continue;
    const auto [index, unit_behind] = mapped_column(our_name, header);
    if (stated->empty()) stated = unit_behind;
    if (found) {
      fail(header_line_, index, fmt::format("a second column for {}", name),
           fmt::format("one column for {}", name));
    }
    const std::string& row_unit = columns_[index].unit;
    const std::string told = row_unit.empty() ? unit_of_header(columns_[index].header) : row_unit;
    if (!stated->empty() && is_unit(told) && !same_letters(told, *stated)) {
      fail(header_line_, index, fmt::format("its unit is {}, not {}", told, *stated));
    }
    found = QuantityColumn{index, stated->empty() ? told : *stated};
  }
  return found;
}

std::optional<CsvTable::QuantityColumn> CsvTable::find_quantity(
    std::string_view name, std::optional<Dimension> dimension) const {
  if (auto mapped = mapped_quantity(name)) return mapped;
  for (const std::string& own : names_for(name)) {
    if (auto found = quantity_called(own, own == name, dimension)) return found;
  }
  return std::nullopt;
}

bool CsvTable::is_stated(std::string_view name) const {
  if (mapped_quantity(name)) return true;
  return std::ranges::any_of(columns_, [&](const Column& column) {
    return column.header.starts_with(name) && unit_of_quantity(column.header, name);
  });
}

std::optional<CsvTable::QuantityColumn> CsvTable::quantity_called(
    std::string_view name, bool ours, std::optional<Dimension> dimension) const {
  std::vector<QuantityColumn> found, stated;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::optional<std::string> unit = unit_of_quantity(columns_[i].header, name);
    if (!unit) continue;
    if (unit->empty()) unit = columns_[i].unit;
    found.push_back({i, *unit});
    if (ours && columns_[i].header.starts_with(name)) stated.push_back(found.back());
  }
  if (stated.size() > 1) {
    fail(header_line_, stated[1].index,
         fmt::format("a second column for {} (the first is {})", name,
                     quoted_value(columns_[stated[0].index].header)),
         fmt::format("one column for {}", name));
  }
  if (!stated.empty()) return stated.front();
  // Elongation may be in mm, or in per cent: then it is another quantity.
  const auto fits = [&](const QuantityColumn& column) {
    return column.unit.empty() || !dimension || unit_conversion(column.unit, *dimension);
  };
  const auto first = std::ranges::find_if(found, fits);
  if (first != found.end()) return *first;
  return ours && !found.empty() ? std::optional(found.front()) : std::nullopt;
}

UnitConversion CsvTable::conversion_of(const QuantityColumn& column, Dimension dimension) const {
  const std::optional<UnitConversion> conversion = unit_conversion(column.unit, dimension);
  if (conversion) return *conversion;
  const bool pure = dimension == Dimension::number || dimension == Dimension::fraction;
  if (column.unit.empty() && pure) return {};
  const std::string problem = column.unit.empty()
                                  ? "the column has no unit"
                                  : fmt::format("{} is no unit of {}", quoted_value(column.unit),
                                                dimension_name(dimension));
  fail(header_line_, column.index, problem, expected_quantity(dimension));
}

std::optional<double> CsvTable::number_of_cell(std::string_view cell) const {
  const std::size_t comma = decimal_comma_allowed_ ? cell.find(',') : std::string_view::npos;
  if (comma == std::string_view::npos) return parse_number(cell);
  std::string with_point(cell);
  with_point[comma] = '.';
  return parse_number(with_point);
}

std::vector<double> CsvTable::read_numbers(std::size_t column) const {
  used_.insert(column);
  std::vector<double> values;
  values.reserve(rows());
  int comma_line = 0;
  int point_line = 0;
  for (std::size_t row = 0; row < rows(); ++row) {
    const std::string_view text = trimmed(cell(row, column));
    if (text.find(',') != std::string_view::npos) comma_line = lines_[row];
    if (text.find('.') != std::string_view::npos) point_line = lines_[row];
    const std::optional<double> value = number_of_cell(text);
    if (!value) {
      fail(lines_[row], column, problem_of_number(text),
           has_thousands_separator(text) ? "numbers without separators of thousands" : "a number");
    }
    if (comma_line > 0 && point_line > 0) {
      fail(
          lines_[row], column,
          fmt::format("decimal comma in line {}, decimal point in line {}", comma_line, point_line),
          "one of the two in a column, without thousands separators");
    }
    values.push_back(*value);
  }
  return values;
}

void CsvTable::fail(int line, std::size_t column, const std::string& problem,
                    const std::string& expected) const {
  throw InputError({file_, line, columns_[column].header}, problem, expected);
}

void CsvTable::fail_missing(std::string_view name, const std::string& expected) const {
  const std::vector<std::string> known = headers();
  throw InputError({file_, header_line_, std::string(name)},
                   fmt::format("there is no such column (the file has {})", list_of_names(known)),
                   expected + R"(, or its header under "columns:")");
}

}  // namespace pliant
