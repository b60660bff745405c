// Cloths that are rolled and placed before the simulation starts.

#include "pliant/scene/initial_shape.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"
#include "pliant/scene/cloth.h"

#include "io/input_error_of.h"

namespace pliant {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.02;

RolledShape shape_about(CylinderAxis axis, bool towards_back = false) {
  return {kRadius, axis, towards_back, 0, {}};
}

Vector3d rolled_point(const RolledShape& shape, const Vector3d& point) {
  return rolled(shape, point);
}

struct AxisCase {
  CylinderAxis axis;
  Vector3d direction;
};

const AxisCase kAxes[] = {{CylinderAxis::u, {1, 0, 0}},
                          {CylinderAxis::v, {0, 1, 0}},
                          {CylinderAxis::diagonal, Vector3d(1, 1, 0).normalized()}};

TEST(RolledShape, LiesOnTheCylinder) {
  const Eigen::Matrix3Xd flat = regular_grid(0.1, 0.06, 9, 7).positions;
  for (const auto& [axis, direction] : kAxes) {
    const Eigen::Matrix3Xd points = rolled(shape_about(axis), flat);
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const Vector3d from_axis = points.col(i) - Vector3d(0, 0, kRadius);
      EXPECT_NEAR(from_axis.cross(direction).norm(), kRadius, 1e-15);
      EXPECT_NEAR(points.col(i).dot(direction), flat.col(i).dot(direction), 1e-15);
    }
  }
}

TEST(RolledShape, StretchesNothing) {
  // Neighbouring points 1 um apart: the arc differs from the chord by a part of 1e-10.
  for (const auto& [axis, direction] : kAxes) {
    for (const Vector3d& step : {Vector3d(1e-6, 0, 0), Vector3d(0, 1e-6, 0)}) {
      const Vector3d point(0.03, 0.05, 0);
      const RolledShape shape = shape_about(axis);
      const double length = (rolled_point(shape, point + step) - rolled_point(shape, point)).norm();
      EXPECT_NEAR(length / 1e-6, 1, 1e-9);
    }
  }
}

TEST(RolledShape, CurvesTowardsTheSideAskedFor) {
  EXPECT_GT(rolled_point(shape_about(CylinderAxis::v), {0.01, 0, 0}).z(), 0);
  EXPECT_LT(rolled_point(shape_about(CylinderAxis::v, true), {0.01, 0, 0}).z(), 0);
}

RolledShape spiral(double pitch) {
  RolledShape shape = shape_about(CylinderAxis::v);
  shape.pitch = pitch;
  return shape;
}

TEST(RolledShape, WithAPitchStretchesNothing) {
  for (const double length : {0.0, 0.03, 0.2, 0.5}) {
    const Vector3d from(length, 0, 0), to(length + 1e-6, 0, 0);
    const double step = (rolled_point(spiral(2e-3), to) - rolled_point(spiral(2e-3), from)).norm();
    EXPECT_NEAR(step / 1e-6, 1, 1e-9) << length;
  }
}

// The involute of a circle: whole turns apart, points lie one pitch apart along the normal that
// they share.
TEST(RolledShape, WithAPitchHasTurnsThatFarApart) {
  constexpr double kPitch = 2e-3, kTurn = 2 * std::numbers::pi;
  for (const double angle : {0.0, 1.0, 4.0}) {
    const auto place = [&](double turned) {
      const double length = kRadius * turned + kPitch / kTurn * turned * turned / 2;
      return rolled_point(spiral(kPitch), {length, 0, 0});
    };
    const Vector3d outwards(std::sin(angle), 0, -std::cos(angle));
    EXPECT_LT((place(angle + kTurn) - place(angle) - kPitch * outwards).norm(), 1e-15) << angle;
  }
}

TEST(RolledShape, KeepsThePlaneOfTheLineThatStays) {
  EXPECT_EQ(rolled_point(shape_about(CylinderAxis::v), {0, 0.3, 0}), Vector3d(0, 0.3, 0));
}

TEST(RolledShape, KeepsHeightsOverTheCloth) {
  const RolledShape shape = shape_about(CylinderAxis::v);
  const double quarter = kRadius * std::numbers::pi / 2;
  EXPECT_LT(
      (rolled_point(shape, {quarter, 0, 0.005}) - Vector3d(kRadius - 0.005, 0, kRadius)).norm(),
      1e-15);
}

TEST(InitialPositions, AreShapedAndThenPlaced) {
  SceneCloth cloth;
  cloth.shape = shape_about(CylinderAxis::v);
  cloth.place.rotation = Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX());
  cloth.place.translation = {0, 0, 1};
  const double quarter = kRadius * std::numbers::pi / 2;
  const Eigen::Matrix3Xd points = initial_positions(cloth, Vector3d(quarter, 0.3, 0));
  EXPECT_LT((points.col(0) - Vector3d(kRadius, -kRadius, 1.3)).norm(), 1e-15);
  EXPECT_EQ(initial_position(cloth, {quarter, 0.3, 0}), Vector3d(points.col(0)));
}

TEST(InitialPositions, AreRefusedWhereASpiralDoesNotReachFurtherInwards) {
  SceneCloth cloth;
  cloth.shape = spiral(2e-3);
  const double innermost = -kRadius * kRadius * std::numbers::pi / 2e-3;
  EXPECT_NO_THROW(initial_positions(cloth, Vector3d(0.99 * innermost, 0, 0)));
  EXPECT_EQ(test::input_error_of([&] {
              initial_positions(cloth, Vector3d(1.01 * innermost, 0, 0));
            }).problem(),
            "the cloth reaches further inwards than its spiral");
}

TEST(InitialPositions, AreMovedByTheirNoiseWhichItsSeedDecides) {
  constexpr double kAmplitude = 1e-6;
  const Eigen::Matrix3Xd flat = regular_grid(0.1, 0.1, 41, 41).positions;
  const auto moves = [&](int seed) {
    SceneCloth cloth;
    cloth.noise = {kAmplitude, seed};
    return Eigen::Matrix3Xd(initial_positions(cloth, flat) - flat);
  };
  // Of 5043 normal numbers: the standard deviation of the mean is 1.4 %, that of their own 1 %.
  EXPECT_NEAR(moves(1).mean() / kAmplitude, 0, 0.05);
  EXPECT_NEAR(std::sqrt(moves(1).cwiseAbs2().mean()) / kAmplitude, 1, 0.04);
  EXPECT_EQ(moves(1), moves(1));
  EXPECT_GT((moves(1) - moves(2)).cwiseAbs().maxCoeff(), kAmplitude);
}

TEST(InitialPositions, OfARolledClothAreRefusedWhereItsMeshIsNotFlat) {
  SceneCloth cloth;
  cloth.shape = shape_about(CylinderAxis::v);
  cloth.shape->where = {"scene.yaml", 7, "cloth[0].shape.cylinder"};
  const InputError error = test::input_error_of(
      [&] { initial_positions(cloth, (Eigen::Matrix3Xd(3, 2) << 0, 1, 0, 0, 0, 0.1).finished()); });
  EXPECT_EQ(error.where().line, 7);
  EXPECT_EQ(error.problem(), "the mesh is not flat");
}

}  // namespace
}  // namespace pliant
