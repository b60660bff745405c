#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pliant/io/csv.h"
#include "pliant/io/csv_finder.h"

namespace pliant {

/// The specimens of a table that holds several, which a column `specimen` tells apart.
class CsvSpecimens {
 public:
  bool empty() const { return specimens_.empty(); }

  /// The next one begins at a row. It is called as the line above its header calls it, else by its
  /// number.
  /// @param above  the cells of that line
  void begin(std::size_t first_row, const std::vector<std::string>& above);

  /// Puts groups of columns, a specimen each, one below the other.
  /// @param above  the cells of the line above the header, which may name them
  void take_apart(const RepeatedColumns& groups, std::vector<std::string> above, CsvTable& table);

  /// Adds the column, which the table has beside those of its header.
  void add_column(CsvTable& table) const;

 private:
  struct Specimen {
    std::size_t first_row;
    std::string name;
  };

  std::vector<Specimen> specimens_;
};

}  // namespace pliant
