#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/letter_case.h"
#include "pliant/base/number_text.h"
#include "pliant/io/csv.h"
#include "pliant/io/csv_finder.h"
#include "pliant/io/csv_specimens.h"
#include "pliant/io/file_kind.h"
#include "pliant/io/text_file.h"
#include "pliant/io/workbook.h"

namespace pliant {
namespace {

constexpr const char* kSkipRowsHint = R"("skip_rows: N" leaves out the lines before the header)";

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
    numbered_columns_ = options.numbered_columns;
    skip_lines(options.skip_rows);
  }

  CsvTable parse() && {
    skip_preamble();
    table_.decimal_comma_allowed_ = separator_ != ',';
    bool more = read_header();
    if (more && is_units_row()) {
      take_units(record_cells());
      more = next_record();
    } else {
      take_units(csv_units_above(table_.preamble(), table_.columns_.size()));
    }
    if (!more && !rows_optional_) fail_without_rows();
    while (more) {
      if (begins_next_specimen()) {
        more = skip_to_next_specimen();
      } else if (begins_footer()) {
        take_footer();
        more = false;
      } else {
        add_row();
        more = next_record();
      }
    }
    if (groups_.count > 0) specimens_.take_apart(groups_, std::move(above_), table_);
    if (!specimens_.empty()) specimens_.add_column(table_);
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
    skip_comments_and_blank_lines();
    const CsvStart start = find_csv_table(text(), at_, numbered_columns_);
    while (at_ < start.at) {
      const auto cells = csv_cells(text(), at_, start.separator);
      if (!cells.empty()) above_.assign(cells.begin(), cells.end());
      skip_line();
    }
    skip_comments_and_blank_lines();
    separator_ = start.separator;
    table_.preamble_size_ = at_;
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

  /// Reads the names of the columns, or numbers them. Then the record at hand is the one after
  /// them.
  /// @return whether there is one
  bool read_header() {
    if (!next_record()) fail(0, "the file is empty", "a header row and rows of data");
    header_line_text_ = trimmed(text_between(record_begin_, at_));
    header_comes_again_ = text().find(header_line_text_, at_) != std::string::npos;
    while (record_.back().size == 0) record_.pop_back();
    const bool numbers = std::all_of(record_.begin(), record_.end(), [&](const Cell& cell) {
      return is_csv_number(view(cell), separator_);
    });
    if (numbers) return number_columns();
    table_.header_line_ = record_line_;
    std::vector<std::string> names;
    for (const Cell& cell : record_) names.push_back(simplified(view(cell)));
    groups_ = repeated_columns(names);
    if (groups_.count > 0) {
      names.resize(groups_.common + groups_.count * groups_.size);
      for (std::string& name : names) table_.columns_.push_back({std::move(name), {}});
    } else {
      for (std::string& name : names) add_column(std::move(name));
    }
    return next_record();
  }

  bool number_columns() {
    if (!numbered_columns_) {
      fail(record_line_, "the first row holds numbers, not the names of the columns",
           fmt::format("a header row, or columns by their numbers and units under \"columns:\", "
                       "e.g. `force: 2 (N)`; {}",
                       kSkipRowsHint));
    }
    for (std::size_t i = 1; i <= record_.size(); ++i) add_column(std::to_string(i));
    return true;
  }

  void add_column(std::string header) {
    if (!header.empty() && !known_headers_.insert(header).second) {
      throw InputError({table_.file_, record_line_, header}, "the column is given twice",
                       "each header once");
    }
    table_.columns_.push_back({std::move(header), {}});
  }

  bool is_units_row() {
    drop_empty_cells_beyond(table_.columns_.size());
    return record_.size() <= table_.columns_.size() && are_csv_units(record_cells());
  }

  std::vector<std::string_view> record_cells() const {
    std::vector<std::string_view> cells;
    for (const Cell& cell : record_) cells.push_back(view(cell));
    return cells;
  }

  void drop_empty_cells_beyond(std::size_t columns) {
    while (record_.size() > columns && record_.back().size == 0) record_.pop_back();
  }

  void take_units(const std::vector<std::string_view>& units) {
    for (std::size_t i = 0; i < units.size(); ++i) table_.columns_[i].unit = csv_unit(units[i]);
  }

  void add_row() {
    const std::size_t columns = table_.columns_.size();
    drop_empty_cells_beyond(columns);
    if (groups_.count > 0 && record_.size() < columns) record_.resize(columns);
    if (record_.size() != columns) fail_row();
    table_.lines_.push_back(record_line_);
    table_.cells_.insert(table_.cells_.end(), record_.begin(), record_.end());
    if (table_.lines_.size() > kMaxCsvRows || table_.cells_.size() > kMaxCsvCells) {
      fail(record_line_, "the table is too large",
           fmt::format("at most {} rows and {} cells", kMaxCsvRows, kMaxCsvCells));
    }
  }

  /// Whether rows were read, and begin with a number.
  bool has_readings() const {
    return !table_.lines_.empty() && is_csv_number(view(table_.cells_.front()), separator_);
  }

  /// A row of another length than its header. Unless readings stand between them, it may be the
  /// header that is wrong.
  [[noreturn]] void fail_row() const {
    const std::size_t columns = table_.columns_.size();
    if (is_remark(view(record_.front()))) {
      fail(record_line_,
           fmt::format("{} stands among the rows", quoted_value(view(record_.front()))),
           "rows alone, and words below the last of them");
    }
    std::string expected = table_.header_line_ == 0 ? fmt::format("{} as in the first row", columns)
                                                    : fmt::format("{} as in the header in line {}",
                                                                  columns, table_.header_line_);
    if (table_.header_line_ > 0 && !has_readings()) {
      expected += fmt::format(" ({})", kSkipRowsHint);
    }
    fail(record_line_, fmt::format("the row has {} cells", record_.size()), expected);
  }

  /// Whether the first cell of a line is words, where rows begin with a number.
  bool is_remark(std::string_view first_cell) const {
    if (!has_readings()) return false;
    const std::string word = lower_case(first_cell);
    const bool is_letter =
        !word.empty() && ((word[0] >= 'a' && word[0] <= 'z') || (word[0] & 0x80) != 0);
    return is_letter && word != "nan" && word != "inf" && word != "infinity";
  }

  /// Whether lines without numbers begin, and no row follows them.
  bool begins_footer() const {
    if (!is_remark(view(record_.front()))) return false;
    const auto is_number = [&](std::string_view cell) { return is_csv_number(cell, separator_); };
    if (std::ranges::any_of(record_, [&](const Cell& cell) { return is_number(view(cell)); })) {
      return false;
    }
    for (std::size_t at = at_; at < text().size(); at = next_csv_line(text(), at)) {
      const std::vector<std::string_view> cells = csv_cells(text(), at, separator_);
      if (!cells.empty() && is_number(cells.front())) return false;
    }
    return true;
  }

  void take_footer() {
    const std::string_view words = trimmed(text_between(record_begin_, text().size()));
    table_.footer_ = make_cell(record_begin_, record_begin_ + words.size());
  }

  /// Whether cells are those of a row: one a column, and numbers where the first row has them.
  template <class TextOf>
  bool are_a_row(std::size_t cells, const TextOf& text_of) const {
    const std::size_t columns = table_.columns_.size();
    if (cells != columns) return false;
    const auto is_number = [&](std::string_view cell) { return is_csv_number(cell, separator_); };
    bool any = false;
    for (std::size_t i = 0; i < columns; ++i) {
      const bool number = is_number(text_of(i));
      any = any || number;
      if (!number && !table_.lines_.empty() && is_number(view(table_.cells_[i]))) return false;
    }
    return any;
  }

  bool record_is_row() {
    drop_empty_cells_beyond(table_.columns_.size());
    return are_a_row(record_.size(), [&](std::size_t i) { return view(record_[i]); });
  }

  bool line_is_row(std::size_t at) const {
    const std::vector<std::string_view> cells = csv_cells(text(), at, separator_);
    return are_a_row(cells.size(), [&](std::size_t i) { return cells[i]; });
  }

  /// Whether the header comes again, perhaps below some lines on the next specimen. A row among
  /// these lines says that the present record is a wrong row.
  bool begins_next_specimen() {
    constexpr int kMostLinesBetween = 30;
    if (!header_comes_again_ || record_is_row()) return false;
    if (table_.header_line_ == 0 || table_.columns_.size() < 2) return false;
    next_specimen_ = record_begin_;
    for (int i = 0; i < kMostLinesBetween && next_specimen_ < text().size(); ++i) {
      const std::size_t end = next_csv_line(text(), next_specimen_);
      if (trimmed(text_between(next_specimen_, end)) == header_line_text_) return true;
      if (line_is_row(next_specimen_)) return false;
      next_specimen_ = end;
    }
    return false;
  }

  /// Goes to the first row of the next specimen; whether there is one.
  bool skip_to_next_specimen() {
    if (specimens_.empty()) begin_specimen(0);
    at_ = record_begin_;
    line_ = record_line_;
    while (at_ < next_specimen_) {
      const auto cells = csv_cells(text(), at_, separator_);
      if (!cells.empty()) above_.assign(cells.begin(), cells.end());
      skip_line();
    }
    begin_specimen(table_.lines_.size());
    skip_line();
    const bool more = next_record();
    return more && is_units_row() ? next_record() : more;
  }

  void begin_specimen(std::size_t first_row) {
    specimens_.begin(first_row, above_);
    above_.clear();
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
  bool numbered_columns_ = false;
  char separator_ = ',';
  std::size_t at_ = 0;
  int line_ = 1;
  std::set<std::string> known_headers_;
  std::vector<Cell> record_;
  int record_line_ = 0;
  std::size_t record_begin_ = 0;

  std::string header_line_text_;
  bool header_comes_again_ = false;  // rows need not be told from headers else
  std::vector<std::string> above_;   ///< the cells of the last line above the header
  RepeatedColumns groups_;
  std::size_t next_specimen_ = 0;  ///< where its header begins
  CsvSpecimens specimens_;
};

CsvTable parse_csv(std::string text, std::string file, const CsvOptions& options) {
  return CsvParser(std::move(text), std::move(file), options).parse();
}

CsvTable read_csv(const std::filesystem::path& path, const CsvOptions& options) {
  require_table(path);
  if (is_workbook(path))
    return parse_csv(workbook_text(path, options.sheet), path.string(), options);
  return parse_csv(read_text_file(path), path.string(), options);
}

}  // namespace pliant
