#include "pliant/material/use_warnings.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/material/fill.h"

namespace pliant {
namespace {

/// The heaviest technical fabrics weigh about 2 kg/m^2; grams in place of kilograms make 100.
constexpr double kLargestDensity = 5;  // kg/m^2

}  // namespace

std::vector<std::string> use_warnings(const Material& material, std::span<const std::string> used) {
  std::vector<std::string> warnings;
  const std::string name = quoted_value(material.name);
  if (material.density > kLargestDensity) {
    warnings.push_back(
        fmt::format("the density of {} is {} kg/m^2, more than any cloth's: was it "
                    "written in g/m^2?",
                    name, format_number(material.density, 4)));
  }
  std::vector<std::string> unused;
  for (const auto& [component, given] : material.components) {
    if (given.status != ComponentStatus::measured || !is_known(material, component)) continue;
    if (std::find(used.begin(), used.end(), component) == used.end()) unused.push_back(component);
  }
  if (!unused.empty()) {
    warnings.push_back(fmt::format("{} of {} {} measured, but the simulation of a sheet uses {}",
                                   fmt::join(unused, ", "), name,
                                   unused.size() == 1 ? "was" : "were", fmt::join(used, ", ")));
  }
  return warnings;
}

}  // namespace pliant
