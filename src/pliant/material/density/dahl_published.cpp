#include "pliant/material/density/dahl_published.h"

#include <cmath>

namespace pliant {
namespace {

FrictionStress on_one_side(const DahlParameters& dahl, double strain, const FrictionState& from,
                           double s) {
  const double g = strain + from.strain < 0 ? -1 : 1;
  const double decay = std::exp(-s * (strain - from.strain) / dahl.tau);
  const double excess = from.stress - s * (dahl.a + g * dahl.b * from.strain);

  FrictionStress result;
  result.stress = s * (dahl.a + g * dahl.b * strain) + excess * decay;
  result.slope = s * g * dahl.b - s / dahl.tau * excess * decay;
  result.from_strain = (s / dahl.tau * excess - s * g * dahl.b) * decay;
  result.from_stress = decay;
  result.parameters = {
      s * (1 - decay),
      s * g * (strain - from.strain * decay),
      excess * decay * s * (strain - from.strain) / (dahl.tau * dahl.tau),
  };
  return result;
}

// Joined at zero strain, as the exact solution is.
FrictionStress published(const DahlParameters& dahl, double strain, const FrictionState& from,
                         double s) {
  if (strain * from.strain >= 0) return on_one_side(dahl, strain, from, s);
  const FrictionStress to_zero = on_one_side(dahl, 0, from, s);
  FrictionStress result = on_one_side(dahl, strain, {0, to_zero.stress}, s);
  for (size_t i = 0; i < result.parameters.size(); ++i) {
    result.parameters[i] += result.from_stress * to_zero.parameters[i];
  }
  result.from_strain = result.from_stress * to_zero.from_strain;
  result.from_stress *= to_zero.from_stress;
  return result;
}

}  // namespace

FrictionStress published_friction_stress(const DahlParameters& dahl, double strain,
                                         const FrictionState& from) {
  return published(dahl, strain, from, strain < from.strain ? -1 : 1);
}

FrictionStress anchored_friction_stress(const DahlParameters& dahl, double strain, double anchor,
                                        int direction) {
  const double s = direction;
  const double g = (anchor != 0 ? anchor : strain) < 0 ? -1 : 1;
  FrictionStress result =
      published(dahl, strain, {anchor, -s * max_friction_stress(dahl, anchor)}, s);
  // The anchor's stress depends on a, b and the anchor's strain too.
  result.parameters[0] -= s * result.from_stress;
  result.parameters[1] -= s * g * anchor * result.from_stress;
  result.from_strain -= s * g * dahl.b * result.from_stress;
  result.from_stress = 0;
  return result;
}

}  // namespace pliant
