#include "apps/pliant/reading_options.h"

#include "pliant/base/errors.h"

namespace pliant {

CsvOptions ReadingOptions::csv() const {
  CsvOptions csv;
  csv.encoding = encoding;
  csv.sheet = sheet;
  csv.skip_rows = skip_rows;
  for (const std::string& column : columns) {
    const std::size_t equals = column.find('=');
    if (equals == 0 || equals >= column.size() - 1) {
      throw InputError({"--columns", 0, ""}, quoted_value(column) + " maps no column",
                       "NAME=HEADER, e.g. \"force=Load (N)\" or \"force=2 (N)\"");
    }
    csv.columns[column.substr(0, equals)] = column.substr(equals + 1);
  }
  return csv;
}

void add_reading_options(CLI::App& command, ReadingOptions& options) {
  constexpr const char* kGroup = "Reading of tables, as `data:` of a study says it";
  command
      .add_option("--columns", options.columns,
                  "Our name of a column and its header or number in the file, NAME=HEADER, e.g. "
                  "\"force=Load (N)\" \"extension=2 (mm)\"")
      ->group(kGroup);
  command.add_option("--encoding", options.encoding, "Of the text, e.g. gbk (default: found out)")
      ->group(kGroup);
  command.add_option("--skip-rows", options.skip_rows, "Lines before the header")
      ->check(CLI::Range(0, 100000))
      ->group(kGroup);
  command
      .add_option("--sheet", options.sheet, "Of a workbook (default: the first that holds a test)")
      ->group(kGroup);
}

}  // namespace pliant
