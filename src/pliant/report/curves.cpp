#include "pliant/report/curves.h"

#include <algorithm>
#include <cmath>

#include "pliant/io/csv.h"
#include "pliant/report/numbers_or_none.h"

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

/// Empty cells stand for what is not known; nothing is left of what is known nowhere.
void drop_unknown(std::vector<double>& numbers) {
  if (std::ranges::all_of(numbers, [](double x) { return std::isnan(x); })) numbers.clear();
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
    const std::vector<double> numbers =
        column.required ? table.numbers(column.name) : numbers_or_none(table, column.name);
    for (std::size_t row = 0; row < numbers.size(); ++row) {
      (curve_of(curves, components[row]).*column.member).push_back(numbers[row]);
    }
    for (ComponentCurve& curve : curves) drop_unknown(curve.*column.member);
  }
  return curves;
}

}  // namespace pliant::report
