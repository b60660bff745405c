#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pliant/experiment/test_type.h"
#include "pliant/io/csv.h"
#include "pliant/measurement/tester_preamble.h"

namespace pliant {

/// What a table of a testing machine was understood to be.
struct TesterFile {
  std::filesystem::path path;
  CsvOptions csv;                  ///< how it is read; an encoding that is not told is found out
  const TestType* type = nullptr;  ///< the test whose data it holds
  bool is_type_known = true;       ///< by its columns, or as asked
  std::map<std::string, std::string> columns;  ///< what a study must say of them, blanks included
  std::vector<std::string> headers;            ///< of the columns
  std::vector<std::string> sheets;             ///< of a workbook, all of them; else none
  std::vector<TesterFact> facts;               ///< what stands above the table
  std::string direction;  ///< by the preamble or the file's name; empty: not told
  int rows = 0;
  int specimens = 1;
  /// Ways to and fro of the specimen with most of them; 1 is a pull without return. Nothing where
  /// no column tells how far it was taken.
  std::optional<int> passes = {};
};

/// Reads and understands a table.
/// @param csv   how to read it, as far as it is known; columns that it names are taken as they are;
///              of a workbook whose sheet is not told the first that holds a test is taken
/// @param type  of the test; null: found by the columns
/// @throws InputError when it is no table, or one that a given type cannot use
TesterFile read_tester_file(const std::filesystem::path& path, CsvOptions csv,
                            const TestType* type = nullptr);

}  // namespace pliant
