#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

inline bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// Where a table stands in the text of a file, and how its cells are separated.
struct CsvStart {
  std::size_t at = 0;  ///< of the header; without one of the first row
  char separator = ',';
};

/// Finds the table in a text: a row of names with numbers, or units and then numbers, under it. Of
/// several the one with most rows, for instruments write tables of results above that of the
/// readings. Where there is none the text itself is the table.
/// @param from      where the search begins
/// @param numbered  whether rows of numbers are a table without names above them, too
CsvStart find_csv_table(std::string_view text, std::size_t from, bool numbered);

/// Tab, `;` or `,`: the first that cuts the line at `at` and the one after it into equally many
/// cells; else the first that cuts the line at all.
char csv_separator(std::string_view text, std::size_t at);

/// The cells of the line that begins at `at`, without the quotes around them and without the empty
/// ones at its end.
std::vector<std::string_view> csv_cells(std::string_view text, std::size_t at, char separator);

/// Where the line after the one at `at` begins; the end of the text after the last one.
std::size_t next_csv_line(std::string_view text, std::size_t at);

/// Whether a cell is a number, with a decimal comma too where the separator is none.
bool is_csv_number(std::string_view cell, char separator);

/// Whether cells are a row of units: each a unit, in brackets, a dash or nothing.
bool are_csv_units(const std::vector<std::string_view>& cells);

/// The unit that a cell of such a row tells: without its brackets; empty for a dash.
std::string_view csv_unit(std::string_view cell);

/// The units of columns that an instrument lists above the table in a line of their own, `Units: N,
/// mm, s` or `Unit;;N;mm`: one a column, or a label and one for each column but the first. Empty
/// where no line does.
std::vector<std::string_view> csv_units_above(std::string_view preamble, std::size_t columns);

/// Columns that stand in a table several times, group after group: a specimen a group.
struct RepeatedColumns {
  std::size_t common = 0;  ///< columns before the first group, which all specimens share
  std::size_t size = 0;    ///< of a group
  std::size_t count = 0;   ///< groups; the last may lack empty columns at its end
};

/// How a header repeats itself; a count of 0 where it does not.
RepeatedColumns repeated_columns(const std::vector<std::string>& header);

}  // namespace pliant
