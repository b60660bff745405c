#include "pliant/report/curves.h"

#include <algorithm>
#include <optional>

#include "pliant/io/csv.h"

namespace pliant::report {
namespace {

ComponentCurve& curve_of(std::vector<ComponentCurve>& curves, const std::string& component) {
  const auto it = std::find_if(curves.begin(), curves.end(), [&](const ComponentCurve& curve) {
    return curve.component == component;
  });
  if (it != curves.end()) return *it;
  curves.push_back({});
  curves.back().component = component;
  return curves.back();
}

/// An empty column stands for a quantity that is not known.
std::optional<std::vector<double>> numbers_if_any(const CsvTable& table, const char* column) {
  const std::vector<std::string> cells = table.texts(column);
  const bool any = std::any_of(cells.begin(), cells.end(),
                               [](const std::string& cell) { return !cell.empty(); });
  return any ? std::optional(table.numbers(column)) : std::nullopt;
}

}  // namespace

std::vector<ComponentCurve> read_curves(const std::filesystem::path& file) {
  struct Column {
    const char* name;
    std::vector<double> ComponentCurve::*member;
    bool required;
  };
  constexpr Column kColumns[] = {{"strain", &ComponentCurve::strain, true},
                                 {"load", &ComponentCurve::load, true},
                                 {"unload", &ComponentCurve::unload, true},
                                 {"low", &ComponentCurve::low, false},
                                 {"high", &ComponentCurve::high, false},
                                 {"elastic", &ComponentCurve::elastic, false},
                                 {"friction_max", &ComponentCurve::max_friction, false}};
  CsvOptions options;
  options.rows_optional = true;  // an evaluation of sessions has no curves
  const CsvTable table = read_csv(file, options);
  const std::vector<std::string> components = table.texts("component");
  std::vector<ComponentCurve> curves;
  for (const Column& column : kColumns) {
    if (!column.required && !table.has(column.name)) continue;
    const std::optional<std::vector<double>> numbers = numbers_if_any(table, column.name);
    if (!numbers) continue;
    for (std::size_t row = 0; row < numbers->size(); ++row) {
      (curve_of(curves, components[row]).*column.member).push_back((*numbers)[row]);
    }
  }
  return curves;
}

}  // namespace pliant::report
