#include "pliant/math/spline_line.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pliant {
namespace {

TEST(SplineLine, IsExactForACubic) {
  // y = x^3: one span is that cubic when the shares are those of x.
  std::vector<Eigen::Vector2d> points;
  std::vector<double> shares;
  for (int i = 0; i <= 10; ++i) {
    shares.push_back(i / 10.0);
    points.emplace_back(shares.back(), std::pow(shares.back(), 3));
  }
  const SplineLine line(points, shares, 1);
  for (const double u : {0.0, 0.33, 1.0}) {
    EXPECT_NEAR(line.position(u).y(), u * u * u, 1e-13);
    EXPECT_NEAR(line.direction(u).y(), 3 * u * u, 1e-12);
    EXPECT_NEAR(line.curvature(u), 6 * u / std::pow(1 + 9 * std::pow(u, 4), 1.5), 1e-11);
  }
}

// Of an arc of 4 rad and radius 2, worst away from its ends.
double worst_error_of_curvature(int spans) {
  constexpr int kPoints = 240;
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= kPoints; ++i) {
    const double angle = 4.0 * i / kPoints;
    points.emplace_back(2 * std::sin(angle), 2 - 2 * std::cos(angle));
  }
  const SplineLine line(points, length_shares(points), spans);
  double worst = 0;
  for (double share = 0.2; share < 0.8; share += 0.005) {
    worst = std::max(worst, std::abs(line.curvature(share) - 0.5));
  }
  return worst;
}

TEST(SplineLine, KnowsTheCurvatureOfACircleToSecondOrderInItsSpans) {
  const double coarse = worst_error_of_curvature(12), fine = worst_error_of_curvature(24);
  EXPECT_LT(coarse, 0.01);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.2);
}

TEST(LengthShares, RunFromZeroToOne) {
  EXPECT_EQ(length_shares({{0, 0}, {3, 4}, {3, 9}}), (std::vector<double>{0, 0.5, 1}));
}

}  // namespace
}  // namespace pliant
