#include "pliant/experiment/clamp_column.h"

#include <utility>

#include "pliant/experiment/test_type.h"

namespace pliant {
namespace {

/// "Extension (%)" is a strain.
bool is_extension(const DataRows& data) {
  const std::string unit = data.quantity_unit("extension");
  return unit.empty() || !unit_conversion(unit, Dimension::fraction);
}

}  // namespace

double ClampColumn::length(double value, double gauge_length) const {
  if (name == "extension") return gauge_length + value;
  return name == "strain" ? gauge_length * (1 + value) : value;
}

std::vector<double> ClampColumn::lengths(double gauge_length) const {
  std::vector<double> all;
  for (const double value : values) all.push_back(length(value, gauge_length));
  return all;
}

ClampColumn clamp_column(const DataRows& data) {
  const auto lengths = [&] {
    return ClampColumn{"length", data.quantity("length", Dimension::length)};
  };
  if (data.is_stated("length")) return lengths();
  if (is_extension(data)) {
    if (auto extension = data.optional_quantity("extension", Dimension::length)) {
      return {"extension", std::move(*extension)};
    }
  }
  if (auto strain = data.optional_quantity("strain", Dimension::fraction)) {
    return {"strain", std::move(*strain)};
  }
  return lengths();
}

bool has_clamp_column(const TableColumns& columns) {
  return columns.has("length", Dimension::length) || columns.has("extension", Dimension::length) ||
         columns.has("strain", Dimension::fraction);
}

}  // namespace pliant
