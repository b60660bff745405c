#pragma once

#include <array>
#include <string>

#include "pliant/material/component_law.h"

namespace pliant::test {

/// A fabric of the table in [P] 4.3, warp direction.
struct PublishedBending {
  std::string name;
  double density = 0;  ///< kg/m^2
  double k1 = 0;       ///< N m
  double k2 = 0;       ///< N m per unit strain (m)
  double a = 0;        ///< N
  double b = 0;        ///< N m
  double tau = 0;      ///< 1/m

  double weight() const { return 9.80665 * density; }
  ComponentLaw law() const {
    ComponentLaw law;
    law.stiffness = ScalarCurve::affine(k1, k2);
    law.friction_law = FrictionLaw::dahl;
    law.friction = {a, b, tau};
    return law;
  }
};

/// Felt, doublecloth, paper. The columns are in units of 1e-7 and 1e-4.
inline std::array<PublishedBending, 3> published_bending() {
  return {PublishedBending{"felt", 0.208, 145.3e-7, 0.15e-7, 5.12e-4, 0.15e-4, 29.9},
          PublishedBending{"doublecloth", 0.255, 62.19e-7, 0.07e-7, 12.84e-4, 0.05e-4, 7.67},
          PublishedBending{"paper", 0.075, 479.7e-7, 0.47e-7, 0.04e-4, 0.64e-4, 10.2}};
}

}  // namespace pliant::test
