#pragma once

#include <cmath>
#include <vector>

#include "pliant/base/random.h"
#include "pliant/material/component_law.h"
#include "pliant/material/density/dahl.h"

namespace pliant::test {

inline double log_uniform(RandomStream& random, double low, double high) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

/// Friction of the size of [T] Table 5.1's fabrics.
inline DahlParameters random_dahl(RandomStream& random) {
  return {random.uniform(0.2, 3), random.uniform(0, 6), log_uniform(random, 0.005, 0.1)};
}

/// Turning values of a strain path between `low` and `high`, the first of them zero.
inline std::vector<double> random_strains(RandomStream& random, int count, double low,
                                          double high) {
  std::vector<double> strains{0};
  while (static_cast<int>(strains.size()) < count) strains.push_back(random.uniform(low, high));
  return strains;
}

/// A stiffness everywhere above random_dahl's b, so that the law is convex in strain.
inline ScalarCurve random_stiffness(RandomStream& random, CurveKind kind) {
  const double k = random.uniform(20, 80);
  if (kind == CurveKind::constant) return ScalarCurve::constant(k);
  if (kind == CurveKind::affine) return ScalarCurve::affine(k, random.uniform(0, 100));
  return ScalarCurve::hermite(
      {0, 0.05, 0.15, 0.4},
      {k, k * random.uniform(1, 1.5), k * random.uniform(1.5, 2), k * random.uniform(2, 3)});
}

inline ComponentLaw random_law(RandomStream& random, CurveKind kind,
                               FrictionLaw friction = FrictionLaw::dahl) {
  ComponentLaw law;
  law.stiffness = random_stiffness(random, kind);
  law.friction_law = friction;
  const DahlParameters dahl = random_dahl(random);
  law.friction = {dahl.a, dahl.b, dahl.tau};
  // Friction with the same rise at zero strain: alpha = a / tau.
  if (friction == FrictionLaw::constant_slope) law.friction[2] = dahl.a / dahl.tau;
  if (friction == FrictionLaw::none) law.friction = {};
  return law;
}

/// For each parameter of a law a change over which its stress changes noticeably.
inline Eigen::VectorXd parameter_scales(const ComponentLaw& law) {
  return law.parameters().cwiseAbs().cwiseMax(1e-2) * 0.1;
}

}  // namespace pliant::test
