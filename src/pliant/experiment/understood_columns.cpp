#include "pliant/experiment/understood_columns.h"

#include <algorithm>
#include <optional>

#include "pliant/experiment/registry.h"

namespace pliant {
namespace {

struct KnownQuantity {
  const char* name;
  std::vector<Dimension> dimensions;  ///< that its unit may have
};

const std::vector<KnownQuantity>& known_quantities() {
  using enum Dimension;
  static const std::vector<KnownQuantity> quantities{
      {"force", {Dimension::force, force_per_length}},
      {"length", {Dimension::length}},
      {"extension", {Dimension::length}},
      {"strain", {fraction}},
      {"weight", {Dimension::force, mass}},
      {"peak", {Dimension::force}},
      {"angle", {Dimension::angle}},
      {"time", {Dimension::time}},
      {"distance", {Dimension::length}},
      {"curvature", {Dimension::curvature}},
      {"moment", {Dimension::force}},
      {"overhang", {Dimension::length}},
      {"radius", {Dimension::length}},
      {"x", {Dimension::length}},
      {"y", {Dimension::length}},
      {"depth", {Dimension::length}},
      {"area", {Dimension::area}},
      {"nominal_stress", {Dimension::stress}}};
  return quantities;
}

/// Understood columns, as types of tests ask for them.
class UnderstoodTable : public TableColumns {
 public:
  explicit UnderstoodTable(const UnderstoodColumns& columns) : columns_(columns) {}

  bool has(std::string_view quantity, Dimension dimension) const override {
    return std::any_of(columns_.begin(), columns_.end(), [&](const auto& entry) {
      return entry.second.quantity == quantity && entry.second.dimension == dimension;
    });
  }

 private:
  const UnderstoodColumns& columns_;
};

}  // namespace

UnderstoodColumns understood_columns(const CsvTable& table) {
  UnderstoodColumns columns;
  const auto understand = [&](const std::string& name, Dimension dimension) {
    const std::optional<std::string> header = table.quantity_column(name, dimension);
    if (!header || columns.contains(*header)) return;
    const std::string unit = *table.quantity_unit(name, dimension);
    const bool is_number = dimension == Dimension::number && unit.empty();
    if (is_number || unit_conversion(unit, dimension)) columns[*header] = {name, unit, dimension};
  };
  for (const auto& [name, dimensions] : known_quantities()) {
    for (const Dimension dimension : dimensions) understand(name, dimension);
  }
  for (const TestType* type : test_types()) {
    for (const auto& [name, dimension] : type->own_quantities) understand(name, dimension);
  }
  return columns;
}

std::vector<const TestType*> usable_types(const UnderstoodColumns& columns) {
  std::vector<const TestType*> types;
  for (const TestType* type : test_types()) {
    if (type->is_table && type->is_table(UnderstoodTable(columns))) types.push_back(type);
  }
  return types;
}

}  // namespace pliant
