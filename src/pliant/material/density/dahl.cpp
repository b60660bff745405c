#include "pliant/material/density/dahl.h"

#include <cmath>
#include <utility>

namespace pliant {
namespace {

// The stretch lies on one side of zero strain; s is the sign of the strain rate, g the side.
FrictionStress on_one_side(const DahlParameters& dahl, double strain, const FrictionState& from,
                           double s, double g) {
  const double decay = std::exp(-s * (strain - from.strain) / dahl.tau);
  // The particular solution is s (a + g b strain) - g b tau: linear in a, b and b tau.
  const auto particular = [&](double at) {
    return s * (dahl.a + g * dahl.b * at) - g * dahl.b * dahl.tau;
  };
  const double excess = from.stress - particular(from.strain);

  FrictionStress result;
  result.stress = particular(strain) + excess * decay;
  result.slope = s * g * dahl.b - s / dahl.tau * excess * decay;
  result.from_strain = (s / dahl.tau * excess - s * g * dahl.b) * decay;
  result.from_stress = decay;
  result.parameters = {
      s * (1 - decay),
      (s * g * strain - g * dahl.tau) - (s * g * from.strain - g * dahl.tau) * decay,
      -g * dahl.b * (1 - decay) +
          excess * decay * s * (strain - from.strain) / (dahl.tau * dahl.tau),
  };
  return result;
}

// The integral of the same solution.
double work_on_one_side(const DahlParameters& dahl, double strain, const FrictionState& from,
                        double s, double g) {
  const double way = strain - from.strain;
  const double at_start = s * (dahl.a + g * dahl.b * from.strain) - g * dahl.b * dahl.tau;
  const double particular = at_start * way + s * g * dahl.b * way * way / 2;
  return particular - (from.stress - at_start) * s * dahl.tau * std::expm1(-s * way / dahl.tau);
}

bool crosses_zero(double strain, double from) {
  return (strain > 0 && from < 0) || (strain < 0 && from > 0);
}

double direction_of(double strain, double from) { return strain < from ? -1 : 1; }

double side_of(double strain) { return strain < 0 ? -1 : 1; }

}  // namespace

double max_friction_stress(const DahlParameters& dahl, double strain) {
  return dahl.a + dahl.b * std::abs(strain);
}

FrictionStressBySide friction_stress(const DahlBySide& dahl, double strain,
                                     const FrictionState& from) {
  const double s = direction_of(strain, from.strain);
  FrictionStressBySide result;
  if (!crosses_zero(strain, from.strain)) {
    const double side = side_of(strain + from.strain);
    result.friction = on_one_side(dahl.at(side), strain, from, s, side);
    if (side < 0) std::swap(result.friction.parameters, result.negative_parameters);
    return result;
  }
  const double side = side_of(strain);
  const FrictionStress to_zero = on_one_side(dahl.at(-side), 0, from, s, -side);
  FrictionStress& last = result.friction;
  last = on_one_side(dahl.at(side), strain, {0, to_zero.stress}, s, side);
  for (size_t i = 0; i < 3; ++i) {
    result.negative_parameters[i] = last.from_stress * to_zero.parameters[i];
  }
  last.from_strain = last.from_stress * to_zero.from_strain;
  last.from_stress *= to_zero.from_stress;
  if (side < 0) std::swap(last.parameters, result.negative_parameters);
  return result;
}

FrictionStress friction_stress(const DahlParameters& dahl, double strain,
                               const FrictionState& from) {
  FrictionStressBySide sides = friction_stress(DahlBySide{dahl, dahl}, strain, from);
  for (size_t i = 0; i < 3; ++i) sides.friction.parameters[i] += sides.negative_parameters[i];
  return sides.friction;
}

double friction_work(const DahlBySide& dahl, double strain, const FrictionState& from) {
  const double s = direction_of(strain, from.strain);
  if (!crosses_zero(strain, from.strain)) {
    const double side = side_of(strain + from.strain);
    return work_on_one_side(dahl.at(side), strain, from, s, side);
  }
  const double side = side_of(strain);
  const double at_zero = on_one_side(dahl.at(-side), 0, from, s, -side).stress;
  return work_on_one_side(dahl.at(-side), 0, from, s, -side) +
         work_on_one_side(dahl.at(side), strain, {0, at_zero}, s, side);
}

}  // namespace pliant
