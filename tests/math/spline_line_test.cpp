#include "pliant/math/spline_line.h"

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

TEST(SplineLine, KnowsTheCurvatureOfACircle) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= 60; ++i) {
    points.emplace_back(2 * std::sin(i / 30.0), 2 - 2 * std::cos(i / 30.0));
  }
  const SplineLine line(points, length_shares(points), 12);
  for (const double u : {0.1, 0.5, 0.9}) {
    EXPECT_NEAR(line.curvature(u), 0.5, 1e-4);  // falls with the square of a span, a radian of 1/6
  }
}

TEST(LengthShares, RunFromZeroToOne) {
  EXPECT_EQ(length_shares({{0, 0}, {3, 4}, {3, 9}}), (std::vector<double>{0, 0.5, 1}));
}

}  // namespace
}  // namespace pliant
