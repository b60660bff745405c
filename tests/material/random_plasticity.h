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
inline bool is_amid_a_branch(const Density& law, double strain, const Eigen::VectorXd& history) {
  const double plastic_strain = history(0);
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

/// Whether differences leave a law on its branch whose history is how far strain has reached, above
/// zero and, where that counts, below.
inline bool is_clear_of_history(const Density&, double strain, const Eigen::VectorXd& history) {
  constexpr double kGap = 0.12;
  const bool is_reached = history(0) >= kGap && (history.size() == 1 || history(1) <= -kGap);
  return is_reached && ((history.array() - std::abs(strain)).abs() > kGap).all() &&
         ((history.array() - strain).abs() > kGap).all();
}

}  // namespace pliant::test
