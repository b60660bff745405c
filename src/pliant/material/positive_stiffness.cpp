#include "pliant/material/positive_stiffness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "pliant/base/number_text.h"
#include "pliant/material/fill.h"
#include "pliant/material/material_samples.h"

namespace pliant {
namespace {

/// Between control points a Hermite curve may fall below both: this many samples a span show it.
constexpr int kSamplesPerSpan = 64;

bool falls(const ScalarCurve& curve) {
  return curve.kind() == CurveKind::affine && curve.values()[1] < 0;
}

/// The largest |strain| of a component's range.
std::optional<double> reach_of(const MaterialComponent& component) {
  if (!component.range) return std::nullopt;
  return std::max(std::abs(component.range->first), std::abs(component.range->second));
}

/// Strains at which a curve is looked at; those of a falling one are judged by `turning_strain`.
std::vector<double> samples_of(const ScalarCurve& curve) {
  if (curve.kind() != CurveKind::hermite) return {0};
  const std::vector<double>& knots = curve.knots();
  std::vector<double> samples{knots.front()};
  for (std::size_t i = 1; i < knots.size(); ++i) {
    for (int k = 1; k <= kSamplesPerSpan; ++k) {
      samples.push_back(knots[i - 1] + (knots[i] - knots[i - 1]) * k / kSamplesPerSpan);
    }
  }
  return samples;
}

/// A strain where the stiffness, with that of addends, is not positive, whatever the range. Beside
/// an elastic range there need be none.
std::optional<double> soft_strain(const ComponentLaw& law) {
  const std::vector<double> strains = samples_of(law.stiffness);
  const bool has_range = law.range_stiffness() > 0;
  const auto soft = std::find_if(strains.begin(), strains.end(), [&](double strain) {
    const double secant = law.elastic_secant(strain);
    return secant < 0 || (secant == 0 && !has_range);
  });
  return soft == strains.end() ? std::nullopt : std::optional(*soft);
}

/// The |strain| beyond which a falling stiffness is negative, where its range does not end before.
std::optional<double> turning_strain(const MaterialComponent& component) {
  const ScalarCurve& curve = *component.stiffness;
  if (!falls(curve)) return std::nullopt;
  const double zero = -curve.values()[0] / curve.values()[1];
  const std::optional<double> reach = reach_of(component);
  return reach && *reach < zero ? std::nullopt : std::optional(zero);
}

void hold_beyond_range(std::map<std::string, MaterialComponent>& components) {
  for (auto& [name, component] : components) {
    if (!component.stiffness || !falls(*component.stiffness)) continue;
    const std::optional<double> reach = reach_of(component);
    if (!reach || *reach == 0) continue;
    const ScalarCurve& curve = *component.stiffness;
    // Through two control points a Hermite curve is the straight line between them, unless one is
    // at rest, where a mirrored curve is level.
    constexpr double kBesideRest = std::numeric_limits<double>::min();
    component.stiffness =
        ScalarCurve::hermite({kBesideRest, *reach}, {curve.value(0), curve.value(*reach)}, true);
  }
}

}  // namespace

void require_positive_stiffness(const Material& material, std::span<const std::string> names,
                                const Location& where) {
  for (std::size_t k = 0; k < material.samples.at.size(); ++k) {
    require_positive_stiffness(material_at(material, k), names, where);
  }
  for (const std::string& name : names) {
    if (!is_known(material, name)) continue;
    const MaterialComponent& component = material.components.at(name);
    const std::string subject =
        fmt::format("the stiffness {} of the material {}", name, quoted_value(material.name));
    const ComponentLaw law = law_of(component);
    if (const auto strain = soft_strain(law)) {
      throw InputError(
          where,
          fmt::format("{} is {} at strain {}", subject,
                      format_number(law.elastic_secant(*strain), 4), format_number(*strain, 4)),
          "a stiffness above 0");
    }
    if (const auto strain = turning_strain(component)) {
      throw InputError(
          where,
          fmt::format("{} turns negative at strain {}{}", subject, format_number(*strain, 4),
                      component.range ? ", within its range" : ", and has no range"),
          "a `range` of the component that ends before: the stiffness is constant "
          "beyond it");
    }
  }
}

Material held_beyond_range(const Material& material) {
  Material held = material;
  hold_beyond_range(held.components);
  for (SampledComponents& sample : held.samples.at) hold_beyond_range(sample.components);
  return held;
}

}  // namespace pliant
