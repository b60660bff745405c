#include "pliant/material/density/dahl.h"

#include <cmath>

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

// The stretch `second` continues `first` from a fixed strain (zero).
FrictionStress chain(const FrictionStress& first, FrictionStress second) {
  for (int i = 0; i < 3; ++i) second.parameters[i] += second.from_stress * first.parameters[i];
  second.from_strain = second.from_stress * first.from_strain;
  second.from_stress *= first.from_stress;
  return second;
}

}  // namespace

double max_friction_stress(const DahlParameters& dahl, double strain) {
  return dahl.a + dahl.b * std::abs(strain);
}

FrictionStress friction_stress(const DahlParameters& dahl, double strain,
                               const FrictionState& from) {
  const double s = strain < from.strain ? -1 : 1;
  const bool crosses_zero = (strain > 0 && from.strain < 0) || (strain < 0 && from.strain > 0);
  if (!crosses_zero) {
    return on_one_side(dahl, strain, from, s, strain + from.strain < 0 ? -1 : 1);
  }
  const FrictionStress to_zero = on_one_side(dahl, 0, from, s, from.strain < 0 ? -1 : 1);
  const FrictionState at_zero{0, to_zero.stress};
  return chain(to_zero, on_one_side(dahl, strain, at_zero, s, strain < 0 ? -1 : 1));
}

}  // namespace pliant
