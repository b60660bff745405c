#include "apps/pliant/convexity_info.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/add_once.h"
#include "pliant/base/number_text.h"
#include "pliant/estimation/solid/convexity.h"
#include "pliant/material/solid/pair_metric.h"

namespace pliant {
namespace {

constexpr int kSamples = 400;  // of a range

/// Strains between which an energy is not convex; nothing where it is.
std::optional<std::pair<double, double>> concave_strains(const MaterialComponent& component) {
  const ComponentLaw law = law_of(component);
  const auto [low, high] = component.range.value_or(std::pair(0.0, 0.0));
  const double steepest = std::abs(law.elastic_tangent(0)) + std::abs(law.elastic_tangent(high));
  std::optional<std::pair<double, double>> found;
  for (int i = 0; i <= kSamples; ++i) {
    const double strain = low + (high - low) * i / kSamples;
    if (law.elastic_tangent(strain) >= -1e-12 * steepest) continue;
    if (!found) found = std::pair(strain, strain);
    found->second = strain;
  }
  return found;
}

/// Whether the energy is convex in the two strains of a term, with all that the material has in
/// them.
Json pair_convexity(const Material& solid, const std::string& pair,
                    const std::array<std::string, 2>& of, FileInfo& info) {
  const auto domain = stated_domain(solid, pair);
  if (!domain) {
    info.lines.push_back(
        labelled("convex", "not looked at: no range of both strains is stated", 1));
    return nullptr;
  }
  const double least = least_convexity(solid, *domain);
  constexpr double kRounding = 1e-5;
  const bool convex = least > -kRounding;
  info.lines.push_back(labelled(
      "convex",
      convex ? "the energy of all Green strains in these two" : "not in these two strains", 1));
  const std::string warning = fmt::format(
      "the energy is not convex in {}: its least second derivative is {} of the largest",
      fmt::join(of, " and "), format_number(least, kInfoDigits));
  if (!convex) add_once(warning, info.warnings);
  return convex;
}

}  // namespace

void add_convexity(const Material& material, const std::string& component, FileInfo& info,
                   Json& json) {
  if (material.kind == MaterialKind::solid && find_pair_metric(component)) {
    json["convex"] = pair_convexity(material, component, find_pair_metric(component)->of(), info);
    return;
  }
  if (material.kind == MaterialKind::cloth && is_sheet_pair(component)) {
    json["convex"] = pair_convexity(of_constant_thickness(material), *solid_metric_of(component),
                                    strains_of_sheet_pair(component), info);
    return;
  }
  const MaterialComponent& own = material.components.at(component);
  const auto concave = concave_strains(own);
  json["convex"] = !concave.has_value();
  std::string convex = own.range ? "over its range" : "at rest; no range is stated";
  if (concave) {
    json["concave"] = {concave->first, concave->second};
    convex = concave->first == concave->second
                 ? "not at a strain of " + format_number(concave->first, kInfoDigits)
                 : fmt::format("not between strains of {} and {}",
                               format_number(concave->first, kInfoDigits),
                               format_number(concave->second, kInfoDigits));
    info.warnings.push_back(
        fmt::format("the energy of {} is not convex in its strain: {}", component, convex));
  }
  info.lines.push_back(labelled("convex", convex, 1));
}

}  // namespace pliant
