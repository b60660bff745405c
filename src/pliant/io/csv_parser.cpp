#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/io/csv.h"
#include "pliant/io/text_file.h"

namespace pliant {
namespace {

constexpr std::array<char, 3> kSeparators = {'\t', ';', ','};
constexpr const char* kSkipRowsHint = R"("skip_rows: N" leaves out the lines before the header)";

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

bool is_bracketed(std::string_view text) {
  return text.size() >= 2 && ((text.front() == '(' && text.back() == ')') ||
                              (text.front() == '[' && text.back() == ']'));
}

/// A cell of a row of units, which may be empty.
bool may_be_unit(std::string_view cell) {
  return cell.empty() || is_bracketed(cell) || is_unit(cell);
}

/// A header on one line: every run of blanks and line ends in it becomes one space.
std::string simplified(std::string_view header) {
  std::string result;
  for (const char c : trimmed(header)) {
    const bool blank = c == ' ' || c == '\t' || is_line_end(c);
    if (blank && result.ends_with(' ')) continue;
    result += blank ? ' ' : c;
  }
  return result;
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

}  // namespace

/// Cuts a text into the cells of a CsvTable. Quoted cells are unescaped in place.
class CsvParser {
 public:
  CsvParser(std::string text, std::string file, const CsvOptions& options) {
    table_.text_ = decode_text(std::move(text), options.encoding, file);
    table_.file_ = std::move(file);
    table_.mapping_ = options.columns;
    table_.synonyms_ = options.synonyms;
    if (table_.text_.size() > std::numeric_limits<std::uint32_t>::max()) {
      fail(0, "the file is too large");
    }
    rows_optional_ = options.rows_optional;
    skip_lines(options.skip_rows);
  }

  CsvTable parse() && {
    skip_comments_and_blank_lines();
    skip_preamble();
    separator_ = detect_separator();
    table_.decimal_comma_allowed_ = separator_ != ',';
    read_header();
    bool more = next_record();
    if (more && is_units_row()) {
      take_units();
      more = next_record();
    }
    if (!more && !rows_optional_) fail_without_rows();
    for (; more; more = next_record()) add_row();
    return std::move(table_);
  }

 private:
  using Cell = CsvTable::Cell;

  const std::string& text() const { return table_.text_; }
  std::string_view view(const Cell& cell) const {
    return std::string_view(text()).substr(cell.begin, cell.size);
  }
  bool at_end() const { return at_ >= text().size(); }
  bool is_blank(char c) const { return c == ' ' || (c == '\t' && separator_ != '\t'); }

  void skip_lines(int count) {
    if (count < 0) fail(0, "skip_rows is negative", "a number of lines");
    for (int i = 0; i < count && !at_end(); ++i) skip_line();
  }

  void skip_line() {
    while (!at_end() && !is_line_end(text()[at_])) ++at_;
    skip_line_end();
  }

  void skip_line_end() {
    if (at_end()) return;
    const bool pair = text().compare(at_, 2, "\r\n") == 0;
    at_ += pair ? 2 : 1;
    ++line_;
  }

  bool at_comment() const {
    const std::size_t first = text().find_first_not_of(" \t", at_);
    return first != std::string::npos && text()[first] == '#';
  }

  bool at_blank_line() const {
    const std::size_t first = text().find_first_not_of(" \t", at_);
    return first == std::string::npos || is_line_end(text()[first]);
  }

  void skip_comments_and_blank_lines() {
    while (!at_end() && (at_comment() || at_blank_line())) skip_line();
  }

  /// What an instrument has written above the header. Where there is no header to be found nothing
  /// is left out, and the reader says what it misses.
  void skip_preamble() {
    constexpr int kMostLines = 200;
    const std::size_t begin = at_;
    const int first_line = line_;
    for (int i = 0; i < kMostLines && !at_end(); ++i) {
      if (begins_table()) return;
      skip_line();
      skip_comments_and_blank_lines();
    }
    at_ = begin;
    line_ = first_line;
  }

  /// Whether the line at hand holds names, and numbers stand under them.
  bool begins_table() {
    separator_ = detect_separator();
    std::size_t next = at_;
    const std::vector<std::string_view> names = cells_of_line(next);
    const bool numbered = std::ranges::any_of(names, [&](const auto& c) { return is_number(c); });
    if (names.size() < 2 || numbered || are_units(names)) return false;
    std::vector<std::string_view> row = cells_of_line(next);
    if (are_units(row)) row = cells_of_line(next);
    const auto filled = std::ranges::count_if(row, [](const auto& c) { return !c.empty(); });
    const auto numbers = std::ranges::count_if(row, [&](const auto& c) { return is_number(c); });
    return row.size() == names.size() && numbers >= 2 && 2 * numbers >= filled;
  }

  /// The cells of the line with content at or after a place, without the quotes around them. The
  /// place moves on behind it.
  std::vector<std::string_view> cells_of_line(std::size_t& at) const {
    at = start_of_content(text(), at);
    const std::size_t end = count_separators(text(), at).end;
    std::vector<std::string_view> cells;
    bool in_quotes = false;
    for (std::size_t from = at; at <= end && from <= end; ++at) {
      if (at < end && text()[at] == '"') in_quotes = !in_quotes;
      if (at < end && (in_quotes || text()[at] != separator_)) continue;
      std::string_view cell = trimmed(text_between(from, at));
      const bool quoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
      cells.push_back(quoted ? cell.substr(1, cell.size() - 2) : cell);
      from = at + 1;
    }
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
    return cells;
  }

  bool is_number(std::string_view cell) const {
    if (parse_number(cell)) return true;
    std::string with_point(cell);
    std::ranges::replace(with_point, ',', '.');
    return separator_ != ',' && parse_number(with_point).has_value();
  }

  static bool are_units(const std::vector<std::string_view>& cells) {
    return !cells.empty() && std::ranges::all_of(cells, may_be_unit);
  }

  /// The first separator that cuts the header and the row after it into equally many cells; else
  /// the first that cuts the header at all.
  char detect_separator() {
    const SeparatorCounts header = count_separators(text(), at_);
    const SeparatorCounts row = count_separators(text(), start_of_content(text(), header.end));
    for (std::size_t i = 0; i < kSeparators.size(); ++i) {
      if (header.counts[i] > 0 && header.counts[i] == row.counts[i]) return kSeparators[i];
    }
    for (std::size_t i = 0; i < kSeparators.size(); ++i) {
      if (header.counts[i] > 0) return kSeparators[i];
    }
    return ',';
  }

  /// Reads the next record that has any content into `record_`.
  bool next_record() {
    while (true) {
      skip_comments_and_blank_lines();
      if (at_end()) return false;
      read_record();
      const bool empty = std::all_of(record_.begin(), record_.end(),
                                     [](const Cell& cell) { return cell.size == 0; });
      if (!empty) return true;
    }
  }

  void read_record() {
    record_.clear();
    record_line_ = line_;
    record_begin_ = at_;
    while (true) {
      record_.push_back(read_cell());
      check_record_size();
      if (at_end() || text()[at_] != separator_) break;
      ++at_;
    }
    skip_line_end();
  }

  Cell read_cell() {
    while (!at_end() && is_blank(text()[at_])) ++at_;
    if (!at_end() && text()[at_] == '"') return read_quoted_cell();
    const std::size_t begin = at_;
    while (!at_end() && text()[at_] != separator_ && !is_line_end(text()[at_])) ++at_;
    return make_cell(begin, begin + trimmed(text_between(begin, at_)).size());
  }

  Cell read_quoted_cell() {
    const std::size_t begin = ++at_;
    std::size_t end = begin;
    while (true) {
      const std::size_t quote = text().find('"', at_);
      if (quote == std::string::npos) fail(record_line_, "a quote is opened and never closed");
      line_ += count_line_ends(text_between(at_, quote));
      end = move_back(at_, quote, end);
      at_ = quote + 1;
      if (at_end() || text()[at_] != '"') break;
      table_.text_[end++] = '"';
      ++at_;
      check_record_size();
    }
    while (!at_end() && is_blank(text()[at_])) ++at_;
    if (!at_end() && text()[at_] != separator_ && !is_line_end(text()[at_])) {
      fail(line_, "text after a closing quote", "a separator or the end of the line");
    }
    return make_cell(begin, end);
  }

  /// Moves the text from `begin` to `end` back to `to`; returns where it then ends.
  std::size_t move_back(std::size_t begin, std::size_t end, std::size_t to) {
    char* data = table_.text_.data();
    return static_cast<std::size_t>(std::copy(data + begin, data + end, data + to) - data);
  }

  static int count_line_ends(std::string_view text) {
    const auto feeds = std::count(text.begin(), text.end(), '\n');
    const auto returns = std::count(text.begin(), text.end(), '\r');
    return static_cast<int>(std::max(feeds, returns));  // LF, CR or CRLF, not mixed
  }

  std::string_view text_between(std::size_t begin, std::size_t end) const {
    return std::string_view(text()).substr(begin, end - begin);
  }

  static Cell make_cell(std::size_t begin, std::size_t end) {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin)};
  }

  void check_record_size() const {
    if (at_ - record_begin_ <= kMaxCsvLineSize) return;
    fail(record_line_, "the line is too long",
         fmt::format("at most {} characters a line", kMaxCsvLineSize));
  }

  void read_header() {
    if (!next_record()) fail(0, "the file is empty", "a header row and rows of data");
    table_.header_line_ = record_line_;
    while (record_.back().size == 0) record_.pop_back();
    const bool numbers = std::all_of(record_.begin(), record_.end(), [&](const Cell& cell) {
      return parse_number(view(cell)).has_value();
    });
    if (numbers) {
      fail(record_line_, "the first row holds numbers, not the names of the columns",
           fmt::format("a header row; {}", kSkipRowsHint));
    }
    for (const Cell& cell : record_) add_column(simplified(view(cell)));
  }

  void add_column(std::string header) {
    if (!header.empty() && !known_headers_.insert(header).second) {
      throw InputError({table_.file_, record_line_, header}, "the column is given twice",
                       "each header once");
    }
    table_.columns_.push_back({std::move(header), {}});
  }

  bool is_units_row() const {
    return record_.size() <= table_.columns_.size() &&
           std::all_of(record_.begin(), record_.end(),
                       [&](const Cell& cell) { return may_be_unit(view(cell)); });
  }

  void take_units() {
    for (std::size_t i = 0; i < record_.size(); ++i) {
      const std::string_view unit = view(record_[i]);
      if (unit.empty()) continue;
      table_.columns_[i].unit =
          is_bracketed(unit) ? trimmed(unit.substr(1, unit.size() - 2)) : unit;
    }
  }

  void add_row() {
    const std::size_t columns = table_.columns_.size();
    while (record_.size() > columns && record_.back().size == 0) record_.pop_back();
    if (record_.size() != columns) {
      fail(record_line_, fmt::format("the row has {} cells", record_.size()),
           fmt::format("{} as in the header in line {} ({})", columns, table_.header_line_,
                       kSkipRowsHint));
    }
    table_.lines_.push_back(record_line_);
    table_.cells_.insert(table_.cells_.end(), record_.begin(), record_.end());
    if (table_.lines_.size() > kMaxCsvRows || table_.cells_.size() > kMaxCsvCells) {
      fail(record_line_, "the table is too large",
           fmt::format("at most {} rows and {} cells", kMaxCsvRows, kMaxCsvCells));
    }
  }

  [[noreturn]] void fail_without_rows() const {
    fail(table_.header_line_, "there are no rows of data under the header", "one row at least");
  }

  [[noreturn]] void fail(int line, const std::string& problem,
                         const std::string& expected = {}) const {
    throw InputError({table_.file_, line}, problem, expected);
  }

  CsvTable table_;
  bool rows_optional_ = false;
  char separator_ = ',';
  std::size_t at_ = 0;
  int line_ = 1;
  std::set<std::string> known_headers_;
  std::vector<Cell> record_;
  int record_line_ = 0;
  std::size_t record_begin_ = 0;
};

CsvTable parse_csv(std::string text, std::string file, const CsvOptions& options) {
  return CsvParser(std::move(text), std::move(file), options).parse();
}

CsvTable read_csv(const std::filesystem::path& path, const CsvOptions& options) {
  return parse_csv(read_text_file(path), path.string(), options);
}

}  // namespace pliant
