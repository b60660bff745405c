#pragma once

#include <string>
#include <vector>

#include "pliant/measurement/data_source.h"

namespace pliant {

class TableColumns;

/// How far clamps, or marks, are apart, as a table tells it.
struct ClampColumn {
  std::string name;            ///< length, extension or strain
  std::vector<double> values;  ///< m; of a strain shares of the gauge length

  /// The distance at a value (m).
  double length(double value, double gauge_length) const;
  std::vector<double> lengths(double gauge_length) const;
};

/// Reads the column of a table that tells it. What a tester calls a length may be that of the
/// specimen: it is taken last, unless it is called as we call it.
/// @throws InputError where none does
ClampColumn clamp_column(const DataRows& data);

/// Whether a table has such a column.
bool has_clamp_column(const TableColumns& columns);

}  // namespace pliant
