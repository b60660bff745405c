#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "pliant/experiment/press/press_path.h"
#include "pliant/geometry/block_mesh.h"
#include "pliant/material/solid/standard_solids.h"

#include "solids/solid_labs.h"

namespace pliant {
namespace {

/// A block of 10 x 10 x 6 mm that is held below, and a sphere above its middle.
PressSetup block_under_sphere(int cells, double radius = 8e-3) {
  PressSetup setup;
  setup.mesh = block_of_hexahedra({0.01, 0.01, 0.006}, {cells, cells, cells / 2});
  setup.held = nodes_at(setup.mesh, 2, 0);
  setup.radius = radius;
  setup.through = {0.0051, 0.0048, 0};
  return setup;
}

Material soft_solid() { return neo_hookean_solid(10e3, 200e3); }

Eigen::VectorXd numbers_of(const PressedBody& body) {
  const ParameterList& list = body.system().parameters();
  return Eigen::Map<const Eigen::VectorXd>(list.values.data(), std::ssize(list.values));
}

TEST(TouchingArea, HasTheDerivativesOfItsValue) {
  const PressSetup setup = block_under_sphere(4);
  const Eigen::Matrix3Xi triangles = boundary_surface(setup.mesh).triangles;
  const ObstacleShape sphere = Sphere{{0.0051, 0.0048, 0.006 + 8e-3}, 8e-3};
  const auto area = [&](const Eigen::Matrix3Xd& positions, double travel) {
    return touching_area(positions, triangles, sphere,
                         {Eigen::Quaterniond::Identity(), travel * setup.direction},
                         setup.direction, 1e-5, 4e-4);
  };
  const double travel = 3e-4, step = 1e-8;
  const SmoothedArea at = area(setup.mesh.positions, travel);
  ASSERT_GT(at.value, 0);
  const double by_travel = (area(setup.mesh.positions, travel + step).value -
                            area(setup.mesh.positions, travel - step).value) /
                           (2 * step);
  EXPECT_NEAR(at.by_travel, by_travel, 1e-5 * std::abs(by_travel));
  RandomStream random(3);
  Eigen::Matrix3Xd way(3, setup.mesh.node_count());
  for (double& number : way.reshaped()) number = random.normal();
  const double along = (area(setup.mesh.positions + step * way, travel).value -
                        area(setup.mesh.positions - step * way, travel).value) /
                       (2 * step);
  EXPECT_NEAR(at.by_position.cwiseProduct(way).sum(), along, 1e-4 * std::abs(along));
}

/// Forces at two places of a path, and their derivatives against differences of other paths.
void expect_derivatives(const PressSetup& setup, const Material& material, bool at_areas,
                        const std::vector<double>& set, double share = 2e-4) {
  const PressedBody body(setup, solid_law(material), 10e3);
  const auto walk = [&](const Eigen::VectorXd& values, const std::vector<int>& by) {
    PressPath path(body, {body.system().with(values), by, {}});
    std::vector<PressPoint> points;
    for (const double to : set) {
      auto point = at_areas ? path.go_to_area(to) : path.go_to_travel(to);
      EXPECT_TRUE(point) << to;
      points.push_back(point.value_or(PressPoint{}));
    }
    return points;
  };
  const Eigen::VectorXd values = numbers_of(body);
  const auto points = walk(values, body.system().all_parameters());
  for (Eigen::Index p = 0; p < values.size(); ++p) {
    Eigen::VectorXd more = values, less = values;
    const double step = 1e-4 * values(p);
    more(p) += step;
    less(p) -= step;
    const auto above = walk(more, {}), below = walk(less, {});
    for (std::size_t i = 0; i < set.size(); ++i) {
      const double by = (above[i].force - below[i].force) / (2 * step);
      EXPECT_NEAR(points[i].force_by(p), by,
                  share * std::abs(by) + 1e-6 * points[i].force / values(p))
          << body.system().parameters().names[static_cast<std::size_t>(p)] << " at " << set[i];
    }
  }
}

TEST(PressPath, HasTheDerivativesOfForcesAtDepths) {
  expect_derivatives(block_under_sphere(4), soft_solid(), false, {4e-4, 8e-4});
}

TEST(PressPath, HasTheDerivativesOfForcesAtAreas) {
  expect_derivatives(block_under_sphere(4), soft_solid(), true, {6e-6, 1e-5});
}

TEST(PressPath, HasTheDerivativesOfForcesOnTetrahedra) {
  PressSetup setup = block_under_sphere(4);
  setup.mesh = block_of_tetrahedra({0.01, 0.01, 0.006}, {4, 4, 2});
  setup.held = nodes_at(setup.mesh, 2, 0);
  expect_derivatives(setup, soft_solid(), true, {6e-6, 1e-5});
}

TEST(SlowPressPath, HasTheDerivativesOfForcesThatRemember) {
  Material material = soft_solid();
  material.components["green.xz"].friction = ComponentFriction{{600, 3000, 0.05}, {}};
  material.components["green.xz"].stiffness = ScalarCurve::none();
  // Differences of paths that turn around are less exact than the derivatives.
  constexpr double kShare = 1e-3;
  expect_derivatives(block_under_sphere(4), material, true, {6e-6, 1.2e-5, 8e-6}, kShare);
}

// Poisson's ratio 0: the column does not get wider, and the closed form of its compression holds.
TEST(PressPath, CompressesAColumnAsItsClosedFormSays) {
  PressSetup setup;
  setup.mesh = block_of_hexahedra({0.01, 0.01, 0.02}, {2, 2, 4});
  setup.held = nodes_at(setup.mesh, 2, 0);
  const double young = 50e3;
  const Material material = stvk_solid(0, young / 2);
  const PressedBody body(setup, solid_law(material), young);
  PressPath path(body, {});
  const auto point = path.go_to_travel(2e-3);
  ASSERT_TRUE(point);
  const double stretch = 0.9;
  const double force = 1e-4 * young * stretch * (1 - stretch * stretch) / 2;
  EXPECT_NEAR(point->force, force, 5e-3 * force);
  EXPECT_NEAR(point->area, 1e-4, 1e-8);
}

// [Hertz1881]: F = 4/3 E / (1 - nu^2) R^(1/2) d^(3/2), contact area pi R d, of a half-space. What
// is left is the size of the block and of its elements.
TEST(SlowPressPath, IsThatOfHertzForAFlatContact) {
  PressSetup setup;
  setup.mesh = block_of_hexahedra({0.02, 0.02, 0.016}, {16, 16, 12});
  setup.held = nodes_at(setup.mesh, 2, 0);
  setup.radius = 0.02;
  setup.through = {0.01, 0.01, 0};
  const double mu = 20e3, lambda = 30e3, nu = lambda / (2 * (lambda + mu));
  const PressedBody body(setup, solid_law(stvk_solid(lambda, mu)), 10e3);
  PressPath path(body, {});
  const double depth = 4e-4;
  const auto point = path.go_to_travel(depth);
  ASSERT_TRUE(point);
  const double force = 4.0 / 3 * 2 * mu / (1 - nu) * std::sqrt(*setup.radius * depth) * depth;
  std::cout << point->force / force << " of Hertz' force, "
            << point->area / (std::numbers::pi * *setup.radius * depth) << " of his area\n";
  EXPECT_NEAR(point->force, force, 0.06 * force);
}

}  // namespace
}  // namespace pliant
