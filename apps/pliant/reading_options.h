#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "pliant/io/csv.h"

namespace pliant {

/// How a table is read, as the command line says it: what `data:` of a study may say.
struct ReadingOptions {
  std::vector<std::string> columns;  ///< NAME=HEADER
  std::string encoding;
  std::string sheet;
  int skip_rows = 0;

  /// @throws InputError for a column without `=`
  CsvOptions csv() const;
};

/// Adds --columns, --encoding, --sheet and --skip-rows.
void add_reading_options(CLI::App& command, ReadingOptions& options);

}  // namespace pliant
