#include "pliant/material/grid_bending.h"

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr double kRounding = 1e-14;

GridPattern squares(Diagonals diagonals) { return {0.01, 0.01, diagonals}; }

Eigen::Vector4d stiffness(const GridPattern& pattern, const BendingVector& hinges) {
  return grid_rigidity(pattern, hinges) * hinges;
}

// M / (width curvature), which is 3 times the stiffness.
TEST(GridBending, OfAlternatingDiagonalsIsSofterAlongWeftAndWarpThanItsHinges) {
  for (const double k : {1.0, 2.5}) {
    for (const double r : {0.01, 0.5, 1.0, 4.0}) {
      const Eigen::Vector4d shown = stiffness(squares(Diagonals::alternating), {k, k, r * k});
      EXPECT_NEAR(3 * shown(kAlongWeft), k * (3 - 1.5 / (1 + 2 * r)), kRounding);
      EXPECT_NEAR(3 * shown(kAlongWarp), k * (3 - 1.5 / (1 + 2 * r)), kRounding);
    }
  }
}

TEST(GridBending, OfEqualHingesIs2_5AlongWeftAnd4At45DegreesWithAlternatingDiagonals) {
  const Eigen::Vector4d shown = stiffness(squares(Diagonals::alternating), {1, 1, 1});
  EXPECT_TRUE((3 * shown).isApprox(Eigen::Vector4d(2.5, 2.5, 4, 4), kRounding)) << shown;
}

TEST(GridBending, OfEqualHingesIs9Or3At45DegreesWithOneDiagonalDirection) {
  const Eigen::Vector4d rising = stiffness(squares(Diagonals::rising), {1, 1, 1});
  const Eigen::Vector4d falling = stiffness(squares(Diagonals::falling), {1, 1, 1});
  EXPECT_TRUE((3 * rising).isApprox(Eigen::Vector4d(3, 3, 9, 3), kRounding)) << rising;
  EXPECT_TRUE((3 * falling).isApprox(Eigen::Vector4d(3, 3, 3, 9), kRounding)) << falling;
}

TEST(GridBending, OfStiffDiagonalsIsThatOfTheHingesAlongWeft) {
  // Nothing relaxes: 3 k, as on an imposed cylinder.
  const Eigen::Vector4d shown = stiffness(squares(Diagonals::alternating), {1, 2, 1e9});
  EXPECT_NEAR(shown(kAlongWeft), 1, 1e-8);
  EXPECT_NEAR(shown(kAlongWarp), 2, 1e-8);
}

// The shares are the derivative of what the sheet shows: relaxed heights have no first-order
// effect.
TEST(GridBending, HasItsSharesAsDerivative) {
  const GridPattern pattern{0.01, 0.013, Diagonals::alternating};
  const BendingVector hinges(1, 2, 0.7);
  const RigidityShares shares = grid_rigidity(pattern, hinges);
  constexpr double kStep = 1e-5;  // central differences: 1e-10 of the third derivative
  for (int j = 0; j < 3; ++j) {
    const BendingVector step = kStep * BendingVector::Unit(j);
    const Eigen::Vector4d slope =
        (stiffness(pattern, hinges + step) - stiffness(pattern, hinges - step)) / (2 * kStep);
    EXPECT_LT((slope - shares.col(j)).norm(), 1e-8);
  }
}

TEST(GridBending, TurnsWithTheGrid) {
  const Eigen::Vector4d flat = stiffness({0.02, 0.01, Diagonals::alternating}, {1, 2, 3});
  const Eigen::Vector4d upright = stiffness({0.01, 0.02, Diagonals::alternating}, {2, 1, 3});
  EXPECT_TRUE(Eigen::Vector4d(flat(1), flat(0), flat(2), flat(3)).isApprox(upright, kRounding));
}

}  // namespace
}  // namespace pliant
