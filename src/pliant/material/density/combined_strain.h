#pragma once

#include <utility>

#include "pliant/material/density/scalar_density.h"

namespace pliant {

/// A sum of the strains of a material point, each times its weight.
struct WeightedStrains {
  Eigen::VectorXd weights;  ///< one a strain of the point

  struct Jet {
    Lane value;
    LaneStrains gradient;
  };
  Jet jet(const LaneView& strain) const {
    return {(strain.matrix() * weights).array(), weights.transpose().replicate(kLanes, 1).array()};
  }
};

/// A law of one strain on a weighted sum of strains. On the sum of both stretches of a sheet a
/// quadratic energy k / 2 (E_weft + E_warp)^2 has the cross term k E_weft E_warp of [T] Eq. 4.3,
/// and is convex.
class CombinedStrain : public ScalarDensity<WeightedStrains> {
 public:
  CombinedStrain(Eigen::VectorXd weights, std::shared_ptr<const ParametricDensity> law)
      : ScalarDensity({std::move(weights)}, std::move(law)) {}
};

}  // namespace pliant
