#pragma once

#include <memory>
#include <utility>

#include "pliant/material/density/scalar_density.h"

namespace pliant {

/// The component of a cloth that stiffens it whichever way it is strained, and with that what it
/// resists one strain with where it has another one: a law of the sum of squares of both principal
/// strains ([T] 4.4). A sheet is whole without it.
inline constexpr const char* kCrossModal = "cross-modal";

/// e_1^2 + e_2^2 of a sheet's principal strains e: E_weft^2 + E_warp^2 + shear^2 / 2, shear being
/// w_u . w_v, twice the strain.
struct PrincipalSquares {
  struct Jet {
    Lane value;
    LaneStrains gradient;
    LaneTangents hessian;
  };
  Jet jet(const LaneView& strain) const {
    Jet jet{strain.col(0).square() + strain.col(1).square() + strain.col(2).square() / 2,
            LaneStrains::Zero(kLanes, 3), LaneTangents::Zero(kLanes, 9)};
    jet.gradient.col(0) = 2 * strain.col(0);
    jet.gradient.col(1) = 2 * strain.col(1);
    jet.gradient.col(2) = strain.col(2);
    jet.hessian.col(0) = jet.hessian.col(4) = 2;
    jet.hessian.col(8) = 1;
    return jet;
  }
};

/// A law of one strain on the sum of squares of both principal strains. Of a constant stiffness k
/// its energy is k / 2 (e_1^2 + e_2^2)^2, which is convex and nothing at small strains.
class CrossModalStrain : public ScalarDensity<PrincipalSquares> {
 public:
  explicit CrossModalStrain(std::shared_ptr<const ParametricDensity> law)
      : ScalarDensity({}, std::move(law)) {}
};

}  // namespace pliant
