#pragma once

#include "pliant/material/solid/solid_density.h"
#include "pliant/material/solid/standard_solids.h"
#include "pliant/mechanics/solid_potentials.h"

namespace pliant::test {

/// Stiffness in tension and Poisson's ratio as other pairs of numbers.
struct ElasticModuli {
  double young = 0, poisson = 0;
  double shear() const { return young / (2 * (1 + poisson)); }
  double lambda() const { return young * poisson / ((1 + poisson) * (1 - 2 * poisson)); }
  double bulk() const { return young / (3 * (1 - 2 * poisson)); }
};

inline SolidLaw stvk_law(const ElasticModuli& m) {
  return solid_law(stvk_solid(m.lambda(), m.shear()));
}

/// Neo-Hookean, with one volume an element, or a node of tetrahedra.
inline SolidLaw rubber_law(const ElasticModuli& m) {
  return solid_law(neo_hookean_solid(m.shear() / 2, m.bulk()));
}

/// The same with a volume at every point.
inline SolidLaw pointwise_rubber_law(const ElasticModuli& m) {
  SolidLaw law;
  law.of_points = solid_density(neo_hookean_solid(m.shear() / 2, m.bulk())).law;
  return law;
}

}  // namespace pliant::test
