#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/quantity.h"

namespace pliant {

struct CsvOptions {
  std::string encoding = {};  ///< an iconv name; empty: UTF-8, or UTF-16 by its byte order mark
  int skip_rows = 0;  ///< lines of the file before the header row (an instrument's preamble)
  /// Our name of a column -> its header in the file, e.g. force -> "Load (N)". A unit may stand in
  /// our name (force_N -> "Load"), or in brackets behind the header ("Load (N)"), where the file
  /// does not tell it. A column's number stands for its header ("2 (N)") where no header is that
  /// number.
  std::map<std::string, std::string> columns = {};
  /// Other names that headers may have for ours, the likeliest first: force -> load, ...
  std::map<std::string, std::vector<std::string>> synonyms = {};
  bool rows_optional = false;     ///< a header alone is a table too
  bool numbered_columns = false;  ///< rows alone are a table too, of columns called 1, 2, 3, ...
  std::string sheet = {};         ///< of a workbook; empty: the first that holds numbers
};

/// A table of text cells under a header row, read from a CSV file as spreadsheets, scripts and
/// testing machines write them.
///
/// Columns are separated by tab, `;` or `,`, whichever fits the header and the row after it. Cells
/// may be quoted (RFC 4180). Lines that start with `#` and empty rows are left out, and so is what
/// an instrument writes above: the header is the first row of names with a row of numbers under it.
/// Lines of words below the last row are left out, too.
/// A row of units under the header, "(s);(mm);(N)" or "s;mm;N", gives the units of its columns.
/// Specimens side by side (a header that repeats its names) or one below the other (a header that
/// comes again) are told apart by a column `specimen`.
/// Numbers have a decimal point, or a decimal comma where the separator is none. Names are found in
/// upper and lower case.
///
/// Every access by name throws an InputError, with line and column, where the column is missing or
/// a cell is not what was asked for; it also marks the column as used.
class CsvTable {
 public:
  const std::string& file() const { return file_; }
  std::size_t rows() const { return lines_.size(); }
  /// The line of the file on which a row starts, counted from 1.
  int line(std::size_t row) const { return lines_.at(row); }
  /// What stands above the header, an instrument's preamble.
  std::string_view preamble() const { return std::string_view(text_).substr(0, preamble_size_); }
  /// What stands below the last row, a machine's closing words.
  std::string_view footer() const {
    return std::string_view(text_).substr(footer_.begin, footer_.size);
  }
  /// The line of the header row; 0 where the columns are numbered.
  int header_line() const { return header_line_; }
  /// The headers as they stand in the file, in its order.
  std::vector<std::string> headers() const;

  /// Whether there is a column of exactly this name, or one that `columns` maps to it.
  bool has(std::string_view column) const;
  /// The header of the column that holds the quantity `name`, whatever its unit. A synonym counts
  /// only where its unit, if it tells one, is of the dimension.
  /// @throws InputError when several columns do, or when a mapped header is not in the file
  std::optional<std::string> quantity_column(std::string_view name,
                                             std::optional<Dimension> dimension = {}) const;
  /// The header of the only column that tells a unit of the dimension; nothing where none does, or
  /// several do.
  std::optional<std::string> only_column_in(Dimension dimension) const;
  /// Whether a column has the name itself, as we write it, or `columns` maps one to it.
  bool is_stated(std::string_view name) const;
  /// The unit of that column as the file tells it; empty when it tells none. Tells a weight in
  /// newtons from one in grams.
  std::optional<std::string> quantity_unit(std::string_view name,
                                           std::optional<Dimension> dimension = {}) const;

  /// The quantity `name` in SI, from the one column called `NAME_UNIT`, `NAME (UNIT)`,
  /// `NAME [UNIT]`, `NAME / UNIT`, `NAME in UNIT` or `NAME` with a units row, or by a synonym of
  /// the name, or from the column that `columns` maps to it, whose unit stands in brackets or after
  /// a space or underscore at the end of its header.
  std::vector<double> quantity(std::string_view name, Dimension dimension) const;
  std::optional<std::vector<double>> optional_quantity(std::string_view name,
                                                       Dimension dimension) const;

  /// The column of exactly this name (or mapped to it) as plain numbers, whole numbers or text.
  std::vector<double> numbers(std::string_view name) const;
  std::vector<long> integers(std::string_view name) const;
  std::vector<std::string> texts(std::string_view name) const;

  /// The number that a cell is, with a decimal comma too where the table may have it.
  std::optional<double> number_of_cell(std::string_view cell) const;

  /// Our names of the columns that were found by a synonym, with their headers.
  const std::map<std::string, std::string>& found_by_synonym() const { return found_; }

  /// The headers of the columns that were never read, for a warning.
  std::vector<std::string> unused_columns() const;

 private:
  friend class CsvParser;
  friend class CsvSpecimens;

  struct Cell {
    std::uint32_t begin = 0;  // in text_
    std::uint32_t size = 0;
  };
  struct Column {
    std::string header;
    std::string unit;  // of the units row; empty without one
  };
  struct QuantityColumn {
    std::size_t index;
    std::string unit;  // empty: none is told
  };

  std::string_view cell(std::size_t row, std::size_t column) const;
  std::optional<std::size_t> find_header(std::string_view header) const;
  /// A header as a study tells it: exactly, in other letters' case, or by its column's number.
  std::optional<std::size_t> find_told_header(std::string_view header) const;
  std::vector<std::string> names_for(std::string_view name) const;
  QuantityColumn mapped_column(const std::string& name, const std::string& header) const;
  std::optional<std::size_t> find_column(std::string_view name) const;
  std::size_t require_column(std::string_view name) const;
  std::optional<QuantityColumn> mapped_quantity(std::string_view name) const;
  std::optional<QuantityColumn> find_quantity(std::string_view name,
                                              std::optional<Dimension> dimension = {}) const;
  std::optional<QuantityColumn> quantity_called(std::string_view name, bool ours,
                                                std::optional<Dimension> dimension) const;
  UnitConversion conversion_of(const QuantityColumn& column, Dimension dimension) const;
  std::vector<double> read_numbers(std::size_t column) const;
  [[noreturn]] void fail(int line, std::size_t column, const std::string& problem,
                         const std::string& expected = {}) const;
  [[noreturn]] void fail_missing(std::string_view name, const std::string& expected) const;

  std::string file_;
  std::map<std::string, std::string> mapping_;  // CsvOptions::columns
  std::map<std::string, std::vector<std::string>> synonyms_;
  std::string text_;
  bool decimal_comma_allowed_ = false;
  std::size_t preamble_size_ = 0;
  Cell footer_;
  int header_line_ = 0;
  std::vector<Column> columns_;
  std::vector<Cell> cells_;  // row by row
  std::vector<int> lines_;
  mutable std::set<std::size_t> used_;
  mutable std::map<std::string, std::string> found_;
};

inline constexpr std::size_t kMaxCsvRows = 5'000'000;
inline constexpr std::size_t kMaxCsvCells = 60'000'000;
inline constexpr std::size_t kMaxCsvLineSize = std::size_t{1} << 20;

/// @throws InputError when the file cannot be read as a table with at least one row of data (unless
///         rows are optional)
CsvTable read_csv(const std::filesystem::path& path, const CsvOptions& options = {});

/// The same for the contents of a file.
CsvTable parse_csv(std::string text, std::string file, const CsvOptions& options = {});

}  // namespace pliant
