#include "pliant/io/workbook.h"

#include <cctype>

#include "pliant/base/errors.h"

#ifdef PLIANT_HAS_ORCUS

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <orcus/exception.hpp>
#include <orcus/orcus_xlsx.hpp>
#include <orcus/spreadsheet/import_interface.hpp>

#include "pliant/base/nearest_name.h"
#include "pliant/base/number_text.h"
#include "pliant/io/text_file.h"

namespace pliant {
namespace {

namespace sheets = orcus::spreadsheet;

constexpr std::size_t kMostCells = 20'000'000;
constexpr long kMostRows = 1 << 20;                          // of a sheet, as the format has it
constexpr std::size_t kLargestFile = std::size_t{64} << 20;  // zipped

std::string quoted_cell(std::string_view text) {
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + "\"";
}

class SharedStrings : public sheets::iface::import_shared_strings {
 public:
  std::size_t append(std::string_view text) override {
    texts_.emplace_back(text);
    return texts_.size() - 1;
  }
  std::size_t add(std::string_view text) override { return append(text); }
  void append_segment(std::string_view text) override { segments_ += text; }
  std::size_t commit_segments() override { return append(std::exchange(segments_, {})); }
  const std::string& at(std::size_t index) const { return texts_.at(index); }

  // How it looks is nothing to a reader of numbers.
  void set_segment_font(std::size_t) override {}
  void set_segment_bold(bool) override {}
  void set_segment_italic(bool) override {}
  void set_segment_font_name(std::string_view) override {}
  void set_segment_font_size(double) override {}
  void set_segment_font_color(sheets::color_elem_t, sheets::color_elem_t, sheets::color_elem_t,
                              sheets::color_elem_t) override {}

 private:
  std::deque<std::string> texts_;
  std::string segments_;
};

/// The cells of a sheet; of formulas what they had come to.
class Sheet : public sheets::iface::import_sheet, sheets::iface::import_formula {
 public:
  Sheet(std::string name, const SharedStrings& strings)
      : name_(std::move(name)), strings_(strings) {}

  const std::string& name() const { return name_; }

  bool has_numbers() const {
    return std::any_of(rows_.begin(), rows_.end(), [](const auto& row) {
      return std::count_if(row.second.begin(), row.second.end(), [](const auto& cell) {
               return parse_number(cell.second).has_value();
             }) > 1;
    });
  }

  std::string text() const {
    std::string text;
    sheets::row_t line = 0;
    for (const auto& [row, cells] : rows_) {
      for (; line < row; ++line) text += '\n';
      sheets::col_t column = 0;
      for (const auto& [at, cell] : cells) {
        for (; column < at; ++column) text += '\t';
        text += parse_number(cell) ? cell : quoted_cell(cell);
      }
      for (; column < last_column_; ++column) text += '\t';
    }
    return text + "\n";
  }

  void set_auto(sheets::row_t row, sheets::col_t column, std::string_view text) override {
    put(row, column, std::string(text));
  }
  void set_string(sheets::row_t row, sheets::col_t column, sheets::string_id_t index) override {
    put(row, column, strings_.at(index));
  }
  void set_value(sheets::row_t row, sheets::col_t column, double value) override {
    put(row, column, format_number(value));
  }
  void set_bool(sheets::row_t row, sheets::col_t column, bool value) override {
    put(row, column, value ? "true" : "false");
  }
  void set_date_time(sheets::row_t row, sheets::col_t column, int year, int month, int day,
                     int hour, int minute, double second) override {
    put(row, column,
        fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:06.3f}", year, month, day, hour, minute,
                    second));
  }
  void set_format(sheets::row_t, sheets::col_t, std::size_t) override {}
  void set_format(sheets::row_t, sheets::col_t, sheets::row_t, sheets::col_t,
                  std::size_t) override {}
  void fill_down_cells(sheets::row_t, sheets::col_t, sheets::row_t) override {}
  sheets::range_size_t get_sheet_size() const override { return {kMostRows, 1 << 14}; }
  import_formula* get_formula() override { return this; }

 private:
  void put(sheets::row_t row, sheets::col_t column, std::string text) {
    if (text.empty()) return;
    if (++count_ > kMostCells) throw InputError({}, "the sheet is too large");
    rows_[row][column] = std::move(text);
    last_column_ = std::max(last_column_, column);
  }

  void set_position(sheets::row_t row, sheets::col_t column) override {
    row_ = row;
    column_ = column;
  }
  void set_result_string(std::string_view text) override { put(row_, column_, std::string(text)); }
  void set_result_value(double value) override { put(row_, column_, format_number(value)); }
  void set_result_bool(bool value) override { set_bool(row_, column_, value); }
  void set_result_empty() override {}
  void set_formula(sheets::formula_grammar_t, std::string_view) override {}
  void set_shared_formula_index(std::size_t) override {}
  void commit() override {}

  std::string name_;
  const SharedStrings& strings_;
  std::map<sheets::row_t, std::map<sheets::col_t, std::string>> rows_;
  sheets::col_t last_column_ = 0;
  std::size_t count_ = 0;
  sheets::row_t row_ = 0;  // of the formula
  sheets::col_t column_ = 0;
};

/// Addresses of cells, `B12`; of ranges, which tables of numbers are read without, the first cell.
class CellAddresses : public sheets::iface::import_reference_resolver {
 public:
  sheets::src_address_t resolve_address(std::string_view address) override {
    sheets::col_t column = 0;
    std::size_t at = 0;
    for (; at < address.size() && address[at] >= 'A' && address[at] <= 'Z' && at < 3; ++at) {
      column = 26 * column + (address[at] - 'A' + 1);
    }
    const std::optional<long> row = parse_integer(address.substr(at));
    if (at == 0 || !row || *row < 1 || *row > kMostRows) {
      throw orcus::invalid_arg_error("no address of a cell: " + std::string(address));
    }
    return {0, static_cast<sheets::row_t>(*row - 1), column - 1};
  }
  sheets::src_range_t resolve_range(std::string_view range) override {
    const auto first = resolve_address(range.substr(0, range.find(':')));
    return {first, first};
  }
};

class Workbook : public sheets::iface::import_factory {
 public:
  sheets::iface::import_reference_resolver* get_reference_resolver(
      sheets::formula_ref_context_t) override {
    return &addresses_;
  }
  sheets::iface::import_shared_strings* get_shared_strings() override { return &strings_; }
  sheets::iface::import_sheet* append_sheet(sheets::sheet_t, std::string_view name) override {
    return &sheets_.emplace_back(std::string(name), strings_);
  }
  sheets::iface::import_sheet* get_sheet(std::string_view name) override {
    const auto found = std::ranges::find(sheets_, name, &Sheet::name);
    return found == sheets_.end() ? nullptr : &*found;
  }
  sheets::iface::import_sheet* get_sheet(sheets::sheet_t index) override {
    const auto i = static_cast<std::size_t>(index);
    return i < sheets_.size() ? &sheets_[i] : nullptr;
  }
  void finalize() override {}

  const std::deque<Sheet>& sheets() const { return sheets_; }

 private:
  CellAddresses addresses_;
  SharedStrings strings_;
  std::deque<Sheet> sheets_;
};

}  // namespace

bool reads_workbooks() { return true; }

std::string workbook_text(const std::filesystem::path& path, const std::string& sheet) {
  const std::string bytes = read_text_file(path, kLargestFile);
  Workbook workbook;
  try {
    orcus::orcus_xlsx(&workbook).read_stream(bytes);
  } catch (const std::exception& error) {
    throw InputError({path.string()},
                     fmt::format("cannot be read as a workbook: {}", one_line(error.what(), 200)));
  }
  const auto found = std::ranges::find_if(workbook.sheets(), [&](const Sheet& candidate) {
    return sheet.empty() ? candidate.has_numbers() : candidate.name() == sheet;
  });
  if (found != workbook.sheets().end()) return found->text();
  if (sheet.empty()) throw InputError({path.string()}, "no sheet holds a table of numbers");
  std::vector<std::string> names;
  for (const Sheet& known : workbook.sheets()) names.push_back(known.name());
  throw InputError({path.string(), 0, "sheet"},
                   "there is no sheet " + quoted_value(sheet) + did_you_mean(sheet, names),
                   list_of_names(names));
}

#else

namespace pliant {

bool reads_workbooks() { return false; }

std::string workbook_text(const std::filesystem::path& path, const std::string&) {
  throw InputError({path.string()}, "is a workbook, which this build does not read",
                   "the sheet saved as CSV, or a build with liborcus (packages.txt)");
}

#endif

bool is_workbook(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".xlsx" || ending == ".xlsm";
}

}  // namespace pliant
