#include "pliant/material/sheet_metric.h"

#include <algorithm>
#include <array>
#include <utility>

#include "pliant/base/assert.h"
#include "pliant/material/solid/pair_metric.h"

namespace pliant {
namespace {

constexpr std::array kMetrics{
    SheetMetric{kCoupling, "sum of both strains", "green.xx+yy", true},
    SheetMetric{kCrossModal, "squares of principal strains", "trace-of-square", true},
    SheetMetric{"area", "change of area", "J"},
    SheetMetric{"log-area", "logarithm of the change of area", "log-J"},
    SheetMetric{"invariant.1", "I1 - 3", "I1"},
    SheetMetric{"invariant.2", "I2 - 3", "I2"},
    SheetMetric{"thread.weft", "extension of weft", "fibre.x"},
    SheetMetric{"thread.warp", "extension of warp", "fibre.y"},
    SheetMetric{"principal.stretch", "principal extension", "stretch"},
    SheetMetric{"principal.log-stretch", "logarithm of principal stretch", "log-stretch"},
};

/// Stretches and shear, and the components of the Green strain that they are.
using Renaming = std::pair<std::string_view, std::string_view>;
constexpr std::array kGreenStrains{Renaming{"stretch.weft", "green.xx"},
                                   Renaming{"stretch.warp", "green.yy"},
                                   Renaming{"shear", "green.xy"}};

std::string component_of(std::string_view green) {
  const auto found = std::ranges::find(kGreenStrains, green, &Renaming::second);
  PLIANT_ASSERT(found != kGreenStrains.end(), "a strain of a sheet");
  return std::string(found->first);
}

std::optional<PairMetric> pair_of_solid(std::string_view name) {
  const std::size_t times = name.find('*');
  if (times == std::string_view::npos) return std::nullopt;
  const std::size_t at = std::min(name.find('@'), name.size());
  if (at < times) return std::nullopt;
  const std::string first = green_strain_of(name.substr(0, times));
  const std::string second = green_strain_of(name.substr(times + 1, at - times - 1));
  return find_pair_metric(first + "*" + second + std::string(name.substr(at)));
}

}  // namespace

std::string green_strain_of(std::string_view component) {
  const auto found = std::ranges::find(kGreenStrains, component, &Renaming::first);
  return found == kGreenStrains.end() ? std::string() : std::string(found->second);
}

std::span<const SheetMetric> sheet_metrics() { return kMetrics; }

const SheetMetric* find_sheet_metric(std::string_view name) {
  const auto found = std::ranges::find(kMetrics, name, &SheetMetric::name);
  return found == kMetrics.end() ? nullptr : &*found;
}

std::optional<std::string> solid_metric_of(std::string_view cloth_component) {
  const SheetMetric* metric = find_sheet_metric(cloth_component);
  if (metric) return std::string(metric->of_solid);
  const auto pair = pair_of_solid(cloth_component);
  return pair ? std::optional(pair->name()) : std::nullopt;
}

std::optional<std::string> sheet_pair_name(std::string_view component) {
  const auto of_solid = pair_of_solid(component);
  return of_solid ? std::optional(sheet_term_of(*of_solid)) : std::nullopt;
}

std::string sheet_term_of(const PairMetric& of_solid) {
  const auto [first, second] = of_solid.of();
  const std::string name = of_solid.name();
  const std::size_t at = std::min(name.find('@'), name.size());
  return component_of(first) + "*" + component_of(second) + name.substr(at);
}

std::array<std::string, 2> strains_of_sheet_pair(std::string_view component) {
  const auto of_solid = pair_of_solid(component);
  PLIANT_ASSERT(of_solid, "a term of two strains");
  const auto [first, second] = of_solid->of();
  return {component_of(first), component_of(second)};
}

bool is_sheet_pair(std::string_view component) { return pair_of_solid(component).has_value(); }

}  // namespace pliant
