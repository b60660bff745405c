#include "pliant/io/csv_finder.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "pliant/base/letter_case.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/io/csv.h"

namespace pliant {
namespace {

constexpr std::array<char, 3> kSeparators = {'\t', ';', ','};
constexpr int kMostLinesAbove = 200;  // of a table
constexpr int kRowsThatTell = 50;     // no table of results is longer

bool is_bracketed(std::string_view text) {
  return text.size() >= 2 && ((text.front() == '(' && text.back() == ')') ||
                              (text.front() == '[' && text.back() == ']'));
}

/// What follows the label of a list of units in its cell; none where a cell begins otherwise.
std::optional<std::string_view> after_units_label(std::string_view cell) {
  constexpr std::array<std::string_view, 4> kLabels = {"units", "unit", "einheiten", "einheit"};
  cell.remove_prefix(std::min(cell.find_first_not_of("# "), cell.size()));
  for (const std::string_view label : kLabels) {
    const std::string_view rest = cell.substr(std::min(label.size(), cell.size()));
    if (!same_letters(cell.substr(0, label.size()), label)) continue;
    if (rest.empty() || rest.front() == ':' || rest.front() == ' ' || rest.front() == '=') {
      return rest.substr(std::min(rest.find_first_not_of(":= "), rest.size()));
    }
  }
  return std::nullopt;
}

struct SeparatorCounts {
  std::array<int, kSeparators.size()> counts = {};
  std::size_t end = 0;  // where the record ends
};

/// How often each separator stands outside quotes in the record that starts at `begin`.
SeparatorCounts count_separators(std::string_view text, std::size_t begin) {
  SeparatorCounts result;
  bool in_quotes = false;
  bool at_cell_start = true;
  std::size_t at = begin;
  const std::size_t limit = std::min(text.size(), begin + kMaxCsvLineSize);
  for (; at < limit && (in_quotes || !is_line_end(text[at])); ++at) {
    const char c = text[at];
    if (c == '"' && (in_quotes || at_cell_start)) in_quotes = !in_quotes;
    const auto separator = std::find(kSeparators.begin(), kSeparators.end(), c);
    at_cell_start = separator != kSeparators.end();
    if (at_cell_start && !in_quotes) ++result.counts[separator - kSeparators.begin()];
  }
  result.end = at;
  return result;
}

/// Where the first line with content after the line end at `at` begins; comments have content.
std::size_t start_of_content(std::string_view text, std::size_t at) {
  return std::min(text.size(), text.find_first_not_of(" \r\n", at));
}

/// Of a quantity that has none, as a row's number.
bool is_dash(std::string_view cell) { return cell == "-" || cell == "--"; }

/// A row that is of numbers mostly.
bool is_row(const std::vector<std::string_view>& cells, char separator) {
  const auto filled = std::ranges::count_if(cells, [](const auto& c) { return !c.empty(); });
  const auto numbers =
      std::ranges::count_if(cells, [&](const auto& c) { return is_csv_number(c, separator); });
  return numbers >= 2 && 2 * numbers >= filled;
}

/// How many rows, as far as it matters, the table has whose header or first row is at `at`; 0 where
/// none begins there.
int rows_of_table(std::string_view text, std::size_t at, char separator, bool numbered) {
  const auto row_after = [&](std::size_t line) {
    return start_of_content(text, next_csv_line(text, line));
  };
  const std::vector<std::string_view> first = csv_cells(text, at, separator);
  if (first.size() < 2 || are_csv_units(first) || first.front().starts_with('#')) return 0;
  const auto is_number = [&](const auto& c) { return is_csv_number(c, separator); };
  if (numbered ? !std::ranges::all_of(first, is_number) : std::ranges::any_of(first, is_number)) {
    return 0;
  }
  std::size_t row = numbered ? at : row_after(at);
  if (are_csv_units(csv_cells(text, row, separator))) row = row_after(row);
  if (!is_row(csv_cells(text, row, separator), separator)) return 0;
  int rows = 0;
  for (; row < text.size() && rows < kRowsThatTell; row = next_csv_line(text, row), ++rows) {
    if (csv_cells(text, row, separator).size() != first.size()) break;
  }
  return rows;
}

}  // namespace

bool are_csv_units(const std::vector<std::string_view>& cells) {
  const auto is_told = [](std::string_view cell) { return is_bracketed(cell) || is_unit(cell); };
  const auto may_be = [&](std::string_view cell) {
    return cell.empty() || is_dash(cell) || is_told(cell);
  };
  return std::ranges::any_of(cells, is_told) && std::ranges::all_of(cells, may_be);
}

std::string_view csv_unit(std::string_view cell) {
  if (is_bracketed(cell)) cell = trimmed(cell.substr(1, cell.size() - 2));
  return is_dash(cell) ? std::string_view() : cell;
}

std::vector<std::string_view> csv_units_above(std::string_view preamble, std::size_t columns) {
  std::vector<std::string_view> found;
  for (std::size_t at = 0; at < preamble.size(); at = next_csv_line(preamble, at)) {
    std::vector<std::string_view> cells = csv_cells(preamble, at, csv_separator(preamble, at));
    if (cells.empty()) continue;
    const auto rest = after_units_label(cells.front());
    if (!rest) continue;
    // A label in a cell of its own stands above the first column, or before it.
    cells.front() = *rest;
    if (rest->empty() && cells.size() == columns + 1) cells.erase(cells.begin());
    if (cells.size() == columns && are_csv_units(cells)) found = std::move(cells);
  }
  return found;
}

bool is_csv_number(std::string_view cell, char separator) {
  if (parse_number(cell)) return true;
  const std::size_t comma = separator == ',' ? std::string_view::npos : cell.find(',');
  if (comma == std::string_view::npos) return false;
  std::string with_point(cell);
  with_point[comma] = '.';
  return parse_number(with_point).has_value();
}

std::size_t next_csv_line(std::string_view text, std::size_t at) {
  const std::size_t end = count_separators(text, at).end;
  if (end >= text.size()) return text.size();
  return end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
}

std::vector<std::string_view> csv_cells(std::string_view text, std::size_t at, char separator) {
  const std::size_t end = count_separators(text, at).end;
  std::vector<std::string_view> cells;
  bool in_quotes = false;
  for (std::size_t from = at; at <= end && from <= end; ++at) {
    if (at < end && text[at] == '"') in_quotes = !in_quotes;
    if (at < end && (in_quotes || text[at] != separator)) continue;
    std::string_view cell = trimmed(text.substr(from, at - from));
    const bool quoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
    cells.push_back(quoted ? cell.substr(1, cell.size() - 2) : cell);
    from = at + 1;
  }
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
  return cells;
}

char csv_separator(std::string_view text, std::size_t at) {
  const SeparatorCounts header = count_separators(text, at);
  const SeparatorCounts row = count_separators(text, start_of_content(text, header.end));
  for (std::size_t i = 0; i < kSeparators.size(); ++i) {
    if (header.counts[i] > 0 && header.counts[i] == row.counts[i]) return kSeparators[i];
  }
  for (std::size_t i = 0; i < kSeparators.size(); ++i) {
    if (header.counts[i] > 0) return kSeparators[i];
  }
  return ',';
}

namespace {

std::string_view line_at(std::string_view text, std::size_t at) {
  return trimmed(text.substr(at, count_separators(text, at).end - at));
}

}  // namespace

CsvStart find_csv_table(std::string_view text, std::size_t from, bool numbered) {
  CsvStart best{from, csv_separator(text, from)};
  int most = 0;
  std::size_t at = from;
  for (int i = 0; i < kMostLinesAbove && at < text.size() && most < kRowsThatTell; ++i) {
    const char separator = csv_separator(text, at);
    int rows = rows_of_table(text, at, separator, /*numbered=*/false);
    if (rows == 0 && numbered) rows = rows_of_table(text, at, separator, /*numbered=*/true);
    // A header that comes again begins the next specimen of the same table.
    const bool again = most > 0 && line_at(text, at) == line_at(text, best.at);
    if (rows > most && !again) {
      most = rows;
      best = {at, separator};
    }
    at = next_csv_line(text, at);
  }
  return best;
}

RepeatedColumns repeated_columns(const std::vector<std::string>& header) {
  for (std::size_t common = 0; common + 3 < header.size(); ++common) {
    for (std::size_t size = 2; common + size < header.size(); ++size) {
      const std::size_t count = (header.size() - common + size - 1) / size;
      const auto name = [&](std::size_t i) {
        return i < header.size() ? header[i] : std::string();
      };
      std::size_t i = common + size;
      while (i < common + count * size && name(i) == name(common + (i - common) % size)) ++i;
      if (i < common + count * size) continue;
      const auto last = header.begin() + static_cast<std::ptrdiff_t>(common + size);
      std::set<std::string> different(header.begin(), last);
      const auto empty = std::count(header.begin(), last, "");
      const auto repeated = different.size() - (empty > 0 ? 1 : 0);
      if (repeated + static_cast<std::size_t>(empty) == common + size && repeated >= common + 2) {
        return {common, size, count};
      }
    }
  }
  return {};
}

}  // namespace pliant
