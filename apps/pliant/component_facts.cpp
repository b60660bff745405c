#include "apps/pliant/component_facts.h"

#include <algorithm>
#include <cmath>

#include "pliant/material/law_path.h"
#include "pliant/math/root.h"

namespace pliant {
namespace {

constexpr double kStepsPerTau = 20;        // of the search for the persistent strain
constexpr double kReachWithoutRange = 50;  // in units of the strain over which friction acts

StiffnessAt stiffness_at(const ComponentLaw& law, double strain) {
  StiffnessAt at;
  at.strain = strain;
  if (strain == 0) {
    at.secant = at.tangent = at.loading = law.stiffness_at_rest();
    return at;
  }
  at.secant = law.elastic_secant(strain);
  at.tangent = law.elastic_tangent(strain);
  at.loading = LawPath(law, {0, 0, {}, {}}).stress_at(strain) / strain;
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
std::optional<double> persistent_strain(const ComponentLaw& law, const DahlParameters& dahl,
                                        int side, double reach) {
  const auto stress = [&](double strain) {
    return side * law.elastic_stress(side * strain) - dahl.a - dahl.b * (strain + dahl.tau);
  };
  if (stress(reach) <= 0) return std::nullopt;
  const double step = std::max(dahl.tau / kStepsPerTau, reach / 1e5);
  return first_root(stress, reach, -step, 0);
}

/// The same where more than one branch remembers, which no closed form tells: after loading from
/// rest to the end of the range.
std::optional<double> strain_left(const ComponentLaw& law, int side, double reach) {
  LawPath path(law, {});
  path.turn_at(side * reach, {});
  const auto stress = [&](double strain) { return side * path.stress_at(side * strain); };
  if (stress(reach) <= 0) return std::nullopt;
  return first_root(stress, reach, -reach / 1e4, 0);
}

FrictionFacts friction_facts(const ComponentLaw& law, const DahlParameters& dahl, int side,
                             std::optional<double> end) {
  FrictionFacts facts;
  facts.dahl = dahl;
  const double at_zero = law.elastic_tangent(0);
  if (at_zero > 0) facts.appearance = appearance_of({dahl.a, dahl.tau}, at_zero);
  const double scale = facts.appearance ? facts.appearance->saturation : dahl.tau;
  const double reach = end && *end > 0 ? *end : kReachWithoutRange * scale;
  ComponentLaw own = law;
  own.friction = {dahl.a, dahl.b, dahl.tau};
  facts.persistent_strain = law.addends_remember() ? strain_left(own, side, reach)
                                                   : persistent_strain(law, dahl, side, reach);
  facts.snapping = snapping_strains(own, side, reach);
  return facts;
}

}  // namespace

ComponentFacts facts_of(const MaterialComponent& component) {
  const ComponentLaw law = law_of(component);
  const std::optional<double> end = end_of_range(component);
  ComponentFacts facts;
  facts.at_zero = stiffness_at(law, 0);
  if (end) facts.at_end = stiffness_at(law, *end);
  if (!component.friction) return facts;
  facts.friction = friction_facts(law, component.friction->positive, 1, end);
  if (component.friction->negative) {
    facts.negative_friction = friction_facts(law, *component.friction->negative, -1, {});
  }
  return facts;
}

}  // namespace pliant
