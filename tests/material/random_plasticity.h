#pragma once

#include <cmath>

#include "pliant/base/random.h"
#include "pliant/material/density/plastic_density.h"

namespace pliant::test {

inline PlasticParameters random_plasticity(RandomStream& random) {
  return {random.uniform(5, 80), random.uniform(0.1, 0.2)};
}

/// Half of them are saturated at the larger strains.
inline PlasticParameters random_saturating_plasticity(RandomStream& random) {
  PlasticParameters plastic = random_plasticity(random);
  plastic.saturation = random.uniform() < 0.5 ? 0.05 : random.uniform(0.25, 0.6);
  return plastic;
}

/// Whether differences leave a step of plasticity on its branch: they move the plastic strain
/// before it by up to 0.1, strains and parameters by less.
inline bool is_amid_a_branch(const Density& law, double strain, double plastic_strain) {
  constexpr double kGap = 0.12, kSmallGap = 0.03;
  const Eigen::VectorXd values = dynamic_cast<const PlasticDensity&>(law).parameters();
  const double yield = values(1);
  if (values.size() > 2) {
    const double beyond = std::abs(strain) - yield - values(2);  // saturation
    if (beyond > kSmallGap) return true;
    if (beyond > -kSmallGap || std::abs(plastic_strain) > values(2) - kGap) return false;
  }
  return std::abs(std::abs(strain - plastic_strain) - yield) > kGap;
}

}  // namespace pliant::test
