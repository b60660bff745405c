#include "pliant/contact/surface_contact.h"

#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "pliant/geometry/crossings.h"
#include "pliant/mechanics/system.h"

#include "contact/touching_sheets.h"

namespace pliant {
namespace {

using test::random_ways;
using test::Sheets;
using test::stacked_sheets;
using test::TouchingSheets;

TouchingSheets wavy_sheets(double friction) {
  Sheets sheets = stacked_sheets(2, 4, 1.2e-3);
  RandomStream random(1);
  sheets.positions += random_ways(random, sheets.positions.cols(), 2e-4);
  return {sheets, friction};
}

TEST(SurfaceContact, HasTheForcesOfItsEnergy) {
  const TouchingSheets sheets = wavy_sheets(0.5);
  RandomStream random(2);
  // Slips within the elastic part and beyond it.
  for (const double slip : {1e-6, 1e-4}) {
    const Eigen::Matrix3Xd at =
        sheets.sheets.positions + random_ways(random, sheets.sheets.positions.cols(), slip);
    Eigen::Matrix3Xd gradient;
    EXPECT_GT(sheets.evaluate(at, &gradient), 0);
    const double step = 1e-3 * slip;
    for (int i = 0; i < 20; ++i) {
      const Eigen::Matrix3Xd way = random_ways(random, at.cols(), 1);
      const double change = sheets.evaluate(at + step * way) - sheets.evaluate(at - step * way);
      EXPECT_NEAR(change / (2 * step), gradient.cwiseProduct(way).sum(), 1e-5 * gradient.norm());
    }
  }
}

TEST(SurfaceContact, PushesAsMuchAsItIsPushed) {
  const TouchingSheets sheets = wavy_sheets(0.5);
  RandomStream random(3);
  const Eigen::Matrix3Xd at =
      sheets.sheets.positions + random_ways(random, sheets.sheets.positions.cols(), 1e-4);
  Eigen::Matrix3Xd force;
  sheets.evaluate(at, &force);
  EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.norm());
  // The barrier turns nothing; friction acts where the step began.
  const TouchingSheets smooth = wavy_sheets(0);
  smooth.evaluate(at, &force);
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < at.cols(); ++i) {
    torque += Eigen::Vector3d(at.col(i)).cross(Eigen::Vector3d(force.col(i)));
  }
  EXPECT_LT(torque.norm(), 1e-11 * force.norm());
}

// The stand-in for its second derivatives is positive semidefinite and bounds the barrier's growth
// along the normals.
TEST(SurfaceContact, HasAConvexStiffness) {
  const TouchingSheets sheets = wavy_sheets(0.5);
  Hessian hessian = sheets.system->make_hessian();
  Derivatives derivatives{{}, nullptr, &hessian};
  sheets.system->evaluate(sheets.state.configuration, {.from = sheets.state}, Curvature::convex,
                          derivatives);
  ASSERT_GT(hessian.matrix.outer_products(), 0);
  RandomStream random(4);
  for (int i = 0; i < 50; ++i) {
    const Eigen::VectorXd x = random_ways(random, sheets.sheets.positions.cols(), 1).reshaped();
    EXPECT_GE(x.dot(hessian.matrix * x), 0);
  }
}

TEST(SurfaceContact, RubsWithNoMoreThanItsFriction) {
  constexpr double kFriction = 0.3;
  // A sheet over a larger one, so that nothing is caught at an edge.
  const TouchingSheets sheets(stacked_sheets(2, 4, 1.5e-3), kFriction);
  const TouchingSheets smooth(stacked_sheets(2, 4, 1.5e-3), 0);
  Eigen::Matrix3Xd at = sheets.sheets.positions, with, without;
  const Eigen::Index upper = at.cols() / 2;
  at.rightCols(upper).row(0).array() += 1e-4;
  sheets.evaluate(at, &with);
  smooth.evaluate(at, &without);
  const Eigen::Vector3d rubbed = (with - without).rightCols(upper).rowwise().sum();
  // The normal forces are those at which the step began.
  smooth.evaluate(smooth.sheets.positions, &without);
  const double pressed = -without.rightCols(upper).row(2).sum();
  EXPECT_NEAR(rubbed.x(), kFriction * pressed, 0.02 * kFriction * pressed);
  EXPECT_NEAR(rubbed.z(), 0, 1e-9 * pressed);
}

// Each layer that would be met goes on with the one that meets it.
TEST(SurfaceContact, MakesWayLayerByLayer) {
  const TouchingSheets sheets(stacked_sheets(4, 4, 3e-3), 0);
  Eigen::Matrix3Xd positions = sheets.sheets.positions;
  const Eigen::Index layer = positions.cols() / 4;
  positions.leftCols(layer).row(2).array() += 5e-3;
  const Evaluation at{.configuration = sheets.state.configuration,
                      .history = sheets.state.history.data()};
  ASSERT_TRUE(sheets.contact->make_way(at, positions));
  EXPECT_EQ(positions.leftCols(layer).row(2).maxCoeff(), 5e-3);
  EXPECT_GT(positions.middleCols(layer, layer).row(2).minCoeff(), 5e-3);
  EXPECT_TRUE(crossing_triangles(positions, sheets.sheets.faces)
                  .value_or(std::vector<std::array<int, 2>>{})
                  .empty());
}

}  // namespace
}  // namespace pliant
