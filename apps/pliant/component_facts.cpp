#include "apps/pliant/component_facts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "pliant/base/assert.h"
#include "pliant/material/component_law.h"
#include "pliant/math/root.h"

namespace pliant {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A cubic stiffness makes the tangent a cubic too: this many samples a span separate its roots.
constexpr int kSamplesPerSpan = 64;
constexpr double kStepsPerTau = 20;        // of the search for the persistent strain
constexpr double kReachWithoutRange = 50;  // in units of the strain over which friction acts

double elastic_tangent(const ScalarCurve& stiffness, double strain) {
  return stiffness.value(strain) + stiffness.slope(strain) * strain;
}

/// |strain| at which a Hermite curve is looked at: zero, samples of its spans on one side, its last
/// knot.
std::vector<double> hermite_samples(const ScalarCurve& stiffness, int side) {
  std::vector<double> ends{0};
  for (const double knot : stiffness.knots()) {
    if (side * knot > 0) ends.push_back(side * knot);
  }
  std::sort(ends.begin(), ends.end());
  std::vector<double> samples{0};
  for (std::size_t i = 1; i < ends.size(); ++i) {
    for (int k = 1; k <= kSamplesPerSpan; ++k) {
      samples.push_back(ends[i - 1] + (ends[i] - ends[i - 1]) * k / kSamplesPerSpan);
    }
  }
  return samples;
}

/// Intervals in which `f` is negative, sampled; beyond the last sample it keeps the sign it has
/// there.
std::vector<StrainInterval> negative_intervals(const std::function<double(double)>& f,
                                               const std::vector<double>& samples) {
  std::vector<StrainInterval> intervals;
  bool inside = f(samples.front()) < 0;
  if (inside) intervals.push_back({samples.front(), kInfinity});
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const bool negative = f(samples[i]) < 0;
    if (negative == inside) continue;
    const double crossing = root_in_bracket(f, samples[i - 1], samples[i]);
    if (negative) {
      intervals.push_back({crossing, kInfinity});
    } else {
      intervals.back().to = crossing;
    }
    inside = negative;
  }
  return intervals;
}

/// Where the tangent k1 + 2 k2 |strain| falls below b.
std::vector<StrainInterval> affine_snapping(double k1, double k2, double b) {
  const bool at_zero = k1 < b;
  if (k2 == 0)
    return at_zero ? std::vector<StrainInterval>{{0, kInfinity}} : std::vector<StrainInterval>{};
  const double crossing = (b - k1) / (2 * k2);
  if (k2 > 0)
    return at_zero ? std::vector<StrainInterval>{{0, crossing}} : std::vector<StrainInterval>{};
  return {{at_zero ? 0 : crossing, kInfinity}};
}

StiffnessAt stiffness_at(const ComponentLaw& law, double strain) {
  StiffnessAt at;
  at.strain = strain;
  at.secant = law.stiffness.value(strain);
  at.tangent = law.elastic_tangent(strain);
  at.loading = at.secant;
  if (strain != 0) {
    const double friction = law.friction_stress(strain, {}).stress;
    at.loading += friction / strain;
  }
  return at;
}

/// End of the strains that a component is meant for; none where it does not say.
std::optional<double> end_of_range(const MaterialComponent& component) {
  if (component.range) return component.range->second;
  if (component.stiffness->kind() == CurveKind::hermite) return component.stiffness->knots().back();
  return std::nullopt;
}

/// The strain at which saturated unloading comes to rest without load: from large strains down, the
/// first at which the elastic stress no longer exceeds the friction a + b strain + b tau ([T]
/// Eq. 5.2, saturated).
std::optional<double> persistent_strain(const ScalarCurve& stiffness, const DahlParameters& dahl,
                                        int side, double reach) {
  const auto stress = [&](double strain) {
    return stiffness.value(side * strain) * strain - dahl.a - dahl.b * (strain + dahl.tau);
  };
  if (stress(reach) <= 0) return std::nullopt;
  const double step = std::max(dahl.tau / kStepsPerTau, reach / 1e5);
  return first_root(stress, reach, -step, 0);
}

FrictionFacts friction_facts(const ScalarCurve& stiffness, const DahlParameters& dahl, int side,
                             std::optional<double> end) {
  FrictionFacts facts;
  facts.dahl = dahl;
  const double at_zero = stiffness.value(0);
  if (at_zero > 0) facts.appearance = appearance_of({dahl.a, dahl.tau}, at_zero);
  const double scale = facts.appearance ? facts.appearance->saturation : dahl.tau;
  const double reach = end && *end > 0 ? *end : kReachWithoutRange * scale;
  facts.persistent_strain = persistent_strain(stiffness, dahl, side, reach);
  facts.snapping = snapping_strains(stiffness, dahl.b, side);
  return facts;
}

}  // namespace

std::vector<StrainInterval> snapping_strains(const ScalarCurve& stiffness, double b, int side) {
  const std::vector<double>& values = stiffness.values();
  switch (stiffness.kind()) {
    case CurveKind::constant:
      return affine_snapping(values[0], 0, b);
    case CurveKind::affine:
      return affine_snapping(values[0], values[1], b);
    case CurveKind::hermite:
      break;
  }
  return negative_intervals(
      [&](double strain) { return elastic_tangent(stiffness, side * strain) - b; },
      hermite_samples(stiffness, stiffness.even() ? 1 : side));
}

ComponentFacts facts_of(const MaterialComponent& component) {
  PLIANT_ASSERT(component.stiffness.has_value(), "a component with numbers");
  const ScalarCurve& stiffness = *component.stiffness;
  ComponentLaw law;
  law.stiffness = stiffness;
  if (component.friction) {
    const DahlParameters& dahl = component.friction->positive;
    law.friction_law = FrictionLaw::dahl;
    law.friction = {dahl.a, dahl.b, dahl.tau};
  }
  const std::optional<double> end = end_of_range(component);
  ComponentFacts facts;
  facts.at_zero = stiffness_at(law, 0);
  if (end) facts.at_end = stiffness_at(law, *end);
  if (!component.friction) return facts;
  facts.friction = friction_facts(stiffness, component.friction->positive, 1, end);
  if (component.friction->negative) {
    facts.negative_friction = friction_facts(stiffness, *component.friction->negative, -1, {});
  }
  return facts;
}

}  // namespace pliant
