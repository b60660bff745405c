#pragma once

#include <map>
#include <string>
#include <vector>

#include "pliant/base/quantity.h"
#include "pliant/experiment/test_type.h"
#include "pliant/io/csv.h"

namespace pliant {

/// What a column was understood to be.
struct UnderstoodColumn {
  std::string quantity;  ///< force, length, ... as data files call them (docs/formats/tables.md)
  std::string unit;
  Dimension dimension = Dimension::number;
};

/// What the columns of a table hold, by their headers. A column without a unit holds nothing that
/// an experiment could use, but for what is a number.
using UnderstoodColumns = std::map<std::string, UnderstoodColumn>;
UnderstoodColumns understood_columns(const CsvTable& table);

/// Types of tests whose columns are all there, in their dimensions.
std::vector<const TestType*> usable_types(const UnderstoodColumns& columns);

}  // namespace pliant
