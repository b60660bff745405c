#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/io/csv.h"
#include "pliant/io/fields.h"

namespace pliant {

/// Where an experiment's rows come from: one file, or a pattern with one specimen a file.
struct DataSource {
  std::vector<std::filesystem::path> files;  ///< sorted by name, as of `comes_before`
  std::string written;                       ///< as the study says it
  CsvOptions csv;
  Location where;
};

/// A column of a data file, as it was written there.
struct OwnColumn {
  std::string header;
  std::vector<std::string> cells;
};

/// Reads `data:` of an experiment: a file, a pattern, or {file, columns, encoding, skip_rows,
/// sheet}. Paths are relative to the document.
/// @throws InputError when no file matches
DataSource read_data_source(const Value& value);

/// Whether `columns:` names columns by number, as it must where no names stand above them.
bool names_column_numbers(const std::map<std::string, std::string>& columns);

/// A range of consecutive rows that belong to one specimen.
struct SpecimenRows {
  std::string name;
  int first = 0;
  int count = 0;
};

/// The rows of all files of a data source, one after the other.
class DataRows {
 public:
  explicit DataRows(const DataSource& source);

  int rows() const { return rows_; }
  std::vector<double> quantity(std::string_view name, Dimension dimension) const;
  /// The quantity, or nothing when no file has it; an error when only some have it.
  std::optional<std::vector<double>> optional_quantity(std::string_view name,
                                                       Dimension dimension) const;
  /// Whether the first file has a column of exactly this name, or the study maps one to it.
  bool is_stated(std::string_view name) const { return tables_.front().is_stated(name); }
  /// The unit that the first file tells for a quantity; empty when it tells none.
  std::string quantity_unit(std::string_view name) const;
  std::optional<std::vector<long>> optional_integers(std::string_view name) const;
  std::optional<std::vector<std::string>> optional_texts(std::string_view name) const;

  /// One specimen a file, or one for each run of equal values in the column `specimen`.
  std::vector<SpecimenRows> specimens() const;
  /// The columns of the files as they are written there.
  std::vector<OwnColumn> own_columns() const;
  /// What was found under another name than ours: `force: the column "Load (N)"`.
  std::vector<std::string> columns_by_synonym() const;
  /// What stands below the rows of a file and is none of them: `"End of test" below the rows ...`.
  std::vector<std::string> lines_left_out() const;
  /// Columns that nothing has asked for.
  std::vector<std::string> unused_columns() const;

  Location location(int row, std::string_view column) const;

 private:
  template <class Read>
  auto gather(Read read) const;

  std::vector<CsvTable> tables_;
  int rows_ = 0;
};

}  // namespace pliant
