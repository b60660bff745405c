#include "pliant/render/camera.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

constexpr ViewDirection kDirections[] = {
    ViewDirection::front,         ViewDirection::back,
    ViewDirection::left,          ViewDirection::right,
    ViewDirection::top,           ViewDirection::bottom,
    ViewDirection::three_quarter, ViewDirection::three_quarter_back};
// Of rounding, for coordinates of order 1 to 1000 in double precision.
constexpr double kRounding = 1e-9;

Eigen::Vector3d corner_of(const Eigen::AlignedBox3d& box, int k) {
  return box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k));
}

/// What the corners of a box cover of a picture.
Eigen::AlignedBox2d shown_box(const Camera& camera, double aspect, const Eigen::AlignedBox3d& box) {
  Eigen::AlignedBox2d shown;
  for (int k = 0; k < 8; ++k) shown.extend(project(camera, aspect, corner_of(box, k)));
  return shown;
}

TEST(Camera, ShowsItsTargetInTheMiddle) {
  const Camera camera{{3, -2, 5}, {1, 1, 1}};
  EXPECT_LT((project(camera, 1.5, camera.target) - Eigen::Vector2d(0.5, 0.5)).norm(), kRounding);
}

TEST(Camera, ShowsAPointAtHalfTheFieldOfViewAtTheUpperEdge) {
  Camera camera{{0, -2, 0}, {0, 0, 0}};
  camera.field_of_view = 1;
  const Eigen::Vector3d point(0, 0, 2 * std::tan(0.5));
  EXPECT_LT((project(camera, 1, point) - Eigen::Vector2d(0.5, 0)).norm(), kRounding);
}

TEST(View, FromTheFrontHasXToTheRightAndZUp) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
  const Eigen::Matrix3d axes = camera_axes(fit_camera(box, ViewDirection::front, 1));
  EXPECT_LT((axes.col(0) - Eigen::Vector3d::UnitX()).norm(), kRounding);
  EXPECT_LT((axes.col(1) - Eigen::Vector3d::UnitZ()).norm(), kRounding);
}

TEST(View, FromTheRightHasYToTheRightAndZUp) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
  const Eigen::Matrix3d axes = camera_axes(fit_camera(box, ViewDirection::right, 1));
  EXPECT_LT((axes.col(0) - Eigen::Vector3d::UnitY()).norm(), kRounding);
  EXPECT_LT((axes.col(1) - Eigen::Vector3d::UnitZ()).norm(), kRounding);
}

TEST(View, FromTheBackTheLeftAndBelowLooksTheOtherWay) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
  const auto forward = [&](ViewDirection view) -> Eigen::Vector3d {
    return camera_axes(fit_camera(box, view, 1)).col(2);
  };
  for (const auto& [one, other] : {std::pair(ViewDirection::front, ViewDirection::back),
                                   std::pair(ViewDirection::left, ViewDirection::right),
                                   std::pair(ViewDirection::top, ViewDirection::bottom)}) {
    EXPECT_LT((forward(one) + forward(other)).norm(), kRounding);
  }
}

TEST(View, KnowsHowWideAPictureIsAtADepth) {
  const Camera camera{{0, -2, 0}, {0, 0, 0}};
  const double width = width_at(camera, 1.5, {0.1, 1, 0.2});
  const double left = project(camera, 1.5, {0, 1, 0}).x();
  EXPECT_NEAR(project(camera, 1.5, {0.25 * width, 1, 0}).x() - left, 0.25, kRounding);
  EXPECT_LT(width_at(camera, 1.5, {0, -3, 0}), 0);
}

TEST(View, FromTheTopHasXToTheRightAndYUp) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
  const Eigen::Matrix3d axes = camera_axes(fit_camera(box, ViewDirection::top, 1));
  EXPECT_LT((axes.col(0) - Eigen::Vector3d::UnitX()).norm(), kRounding);
  EXPECT_LT((axes.col(1) - Eigen::Vector3d::UnitY()).norm(), kRounding);
}

TEST(View, ContainsTheBoxWithinItsMarginsAndTouchesOneOfThem) {
  RandomStream random(3);
  const Margins margins{0.05, 0.3, 0.1, 0.02};
  for (int trial = 0; trial < 200; ++trial) {
    Eigen::AlignedBox3d box;
    for (int k = 0; k < 3; ++k) {
      box.extend(
          Eigen::Vector3d(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)));
    }
    const double aspect = random.uniform(0.5, 2.5);
    const Camera camera = fit_camera(box, kDirections[trial % 4], aspect, margins);
    const Eigen::AlignedBox2d shown = shown_box(camera, aspect, box);
    const Eigen::Vector2d low = shown.min() - Eigen::Vector2d(margins.left, margins.top);
    const Eigen::Vector2d high =
        Eigen::Vector2d(1 - margins.right, 1 - margins.bottom) - shown.max();
    EXPECT_GT(std::min(low.minCoeff(), high.minCoeff()), -kRounding);
    EXPECT_LT(std::min(low.minCoeff(), high.minCoeff()), kRounding);
  }
}

TEST(View, OfAFlatBoxOrAPointIsFiniteAndContainsIt) {
  const Eigen::Vector3d corner(1, 2, 3);
  for (const Eigen::Vector3d& size : {Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(0, 2, 0),
                                      Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1e-5, 0, 0)}) {
    const Eigen::AlignedBox3d box(corner, corner + size);
    for (const ViewDirection direction : kDirections) {
      const Camera camera = fit_camera(box, direction, 4.0 / 3);
      ASSERT_TRUE(camera.position.allFinite() && camera.target.allFinite());
      EXPECT_TRUE(Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1))
                      .contains(shown_box(camera, 4.0 / 3, box)));
    }
  }
}

}  // namespace
}  // namespace pliant
