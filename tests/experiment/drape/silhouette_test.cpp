#include "pliant/experiment/drape/silhouette.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kOfLines = 1e-5;  // relative: 1500 lines sum an area

/// A fan of triangles about the origin with an outline r(angle).
template <class Radius>
std::pair<Eigen::Matrix3Xd, Eigen::Matrix3Xi> fan(Radius radius, int parts) {
  Eigen::Matrix3Xd positions = Eigen::Matrix3Xd::Zero(3, parts + 1);
  Eigen::Matrix3Xi triangles(3, parts);
  for (int i = 0; i < parts; ++i) {
    const double angle = 2 * kPi * i / parts;
    positions.col(i + 1) << radius(angle) * std::cos(angle), radius(angle) * std::sin(angle), 0;
    triangles.col(i) << 0, i + 1, (i + 1) % parts + 1;
  }
  return {positions, triangles};
}

TEST(Silhouette, IsTheDiscWhereNothingHangsBeyondIt) {
  const auto [positions, triangles] = fan([](double) { return 0.05; }, 100);
  const Silhouette silhouette = silhouette_of(positions, triangles, 0.09);
  EXPECT_NEAR(silhouette.area, kPi * 0.09 * 0.09, kOfLines * silhouette.area);
  for (const double radius : silhouette.radii) EXPECT_EQ(radius, 0.09);
}

TEST(Silhouette, HasTheAreaAndTheRadiiOfItsOutline) {
  const auto radius = [](double angle) { return 0.12 + 0.02 * std::cos(5 * angle); };
  const auto [positions, triangles] = fan(radius, 7200);
  const Silhouette silhouette = silhouette_of(positions, triangles, 0.05);
  const double area = kPi * (0.12 * 0.12 + 0.02 * 0.02 / 2);
  EXPECT_NEAR(silhouette.area, area, kOfLines * area);
  ASSERT_EQ(std::ssize(silhouette.radii), kSilhouetteAngles);
  for (int i = 0; i < kSilhouetteAngles; ++i) {
    const double expected = radius(2 * kPi * i / kSilhouetteAngles);
    EXPECT_NEAR(silhouette.radii[static_cast<std::size_t>(i)], expected, 1e-7);  // chords
  }
}

TEST(Silhouette, CountsWhatLiesOverEachOtherOnce) {
  auto [positions, triangles] = fan([](double) { return 0.1; }, 360);
  const double once = silhouette_of(positions, triangles, 0.05).area;
  Eigen::Matrix3Xd twice(3, 2 * positions.cols());
  twice << positions, positions;
  twice.rightCols(positions.cols()).row(2).array() -= 0.01;
  Eigen::Matrix3Xi both(3, 2 * triangles.cols());
  both << triangles, triangles.array() + static_cast<int>(positions.cols());
  EXPECT_EQ(silhouette_of(twice, both, 0.05).area, once);
}

}  // namespace
}  // namespace pliant
