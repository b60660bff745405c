// A cloth as its material: patch tests on irregular meshes and on springs, parameters, regions.

#include "pliant/mechanics/cloth_potentials.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/geometry/regular_grid.h"

#include "support/cloth_systems.h"
#include "support/evaluate_system.h"

namespace pliant {
namespace {

using ::testing::ElementsAre;

constexpr double kSize = 0.1;  // m, of the patches
constexpr int kNodes = 6;

Material measured_by(MembraneMeasure measure) {
  Material material = test::uneven_cotton();
  material.membrane = measure;
  return material;
}

/// Stretch, shear, and both: d position / d rest coordinates.
std::vector<Eigen::Matrix<double, 3, 2>> affine_maps() {
  std::vector<Eigen::Matrix<double, 3, 2>> maps(4);
  maps[0] << 1.12, 0, 0, 1, 0, 0;
  maps[1] << 1, 0, 0, 0.94, 0, 0;
  maps[2] << 1, 0.2, 0, 1, 0, 0;
  maps[3] << 1.05, -0.1, 0.03, 1.2, 0, 0;
  const size_t flat = maps.size();
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  for (size_t k = 0; k < flat; ++k) maps.push_back(turn * maps[k]);
  return maps;
}

Configuration mapped(const Configuration& rest, const Eigen::Matrix<double, 3, 2>& map) {
  return {map * rest.positions.topRows<2>(), {}};
}

bool is_inside(int vertex) {
  const int i = vertex % kNodes, j = vertex / kNodes;
  return i > 0 && i + 1 < kNodes && j > 0 && j + 1 < kNodes;
}

/// Stress of a component of the material that was strained once, from rest.
double stress_of(const Material& material, const std::string& component, double strain) {
  const MaterialComponent& law = material.components.at(component);
  const double elastic = law.stiffness->value(strain) * strain;
  return elastic + friction_stress(law.friction->positive, strain, {}).stress;
}

/// Force per rest length (N/m) across lines at right angles to weft (column 0) and warp.
Eigen::Matrix<double, 3, 2> traction(const Material& material,
                                     const Eigen::Matrix<double, 3, 2>& map) {
  const Eigen::Vector3d u = map.col(0), v = map.col(1);
  const bool stvk = material.membrane == MembraneMeasure::stvk;
  const double strain_u = stvk ? (u.squaredNorm() - 1) / 2 : u.norm() - 1;
  const double strain_v = stvk ? (v.squaredNorm() - 1) / 2 : v.norm() - 1;
  const double y_u = stress_of(material, "stretch.weft", strain_u);
  const double y_v = stress_of(material, "stretch.warp", strain_v);
  const double y_s = stress_of(material, "shear", u.dot(v));
  Eigen::Matrix<double, 3, 2> result;
  result << y_u * (stvk ? u : u.normalized()) + y_s * v,
      y_v * (stvk ? v : v.normalized()) + y_s * u;
  return result;
}

class ClothPatch : public ::testing::TestWithParam<MembraneMeasure> {};

TEST_P(ClothPatch, IsInBalanceInsideUnderUniformDeformation) {
  const Material material = measured_by(GetParam());
  const auto cloth =
      test::cloth_system(test::jittered_grid(kSize, kSize, kNodes, kNodes, 1), material);
  cloth.system->finish();
  const State state = cloth.system->initial_state();
  for (const auto& map : affine_maps()) {
    const Eigen::Matrix3Xd force =
        test::gradient_of(*cloth.system, mapped(state.configuration, map), state);
    double scale = 0;
    for (int i = 0; i < force.cols(); ++i) scale = std::max(scale, force.col(i).norm());
    EXPECT_GT(scale, 1e-3);
    for (int i = 0; i < force.cols(); ++i) {
      if (is_inside(i)) {
        EXPECT_LT(force.col(i).norm(), 1e-12 * scale) << i;
      }
    }
  }
}

TEST_P(ClothPatch, PullsAtItsEdgesWithTheStressOfTheMaterial) {
  const Material material = measured_by(GetParam());
  const auto cloth =
      test::cloth_system(test::jittered_grid(kSize, 1.5 * kSize, kNodes, kNodes, 1), material);
  cloth.system->finish();
  const State state = cloth.system->initial_state();
  for (const auto& map : affine_maps()) {
    const Eigen::Matrix3Xd gradient =
        test::gradient_of(*cloth.system, mapped(state.configuration, map), state);
    // Virtual work of the edges against a stretch of the whole: every edge node counts with its
    // place, the same as the sum over the opposite edges.
    const Eigen::Matrix<double, 3, 2> moment =
        gradient * state.configuration.positions.topRows<2>().transpose();
    const Eigen::Matrix<double, 3, 2> expected = kSize * 1.5 * kSize * traction(material, map);
    EXPECT_LT((moment - expected).norm(), 1e-12 * expected.norm());
  }
}

TEST_P(ClothPatch, HasTheEnergyOfItsStressAndItsFriction) {
  const Material material = measured_by(GetParam());
  const auto cloth =
      test::cloth_system(test::jittered_grid(kSize, kSize, kNodes, kNodes, 1), material);
  cloth.system->finish();
  const State state = cloth.system->initial_state();
  for (const auto& map : affine_maps()) {
    const Eigen::Vector3d u = map.col(0), v = map.col(1);
    const bool stvk = material.membrane == MembraneMeasure::stvk;
    const double strains[] = {stvk ? (u.squaredNorm() - 1) / 2 : u.norm() - 1,
                              stvk ? (v.squaredNorm() - 1) / 2 : v.norm() - 1, u.dot(v)};
    const char* const names[] = {"stretch.weft", "stretch.warp", "shear"};
    double stored = 0, work = 0;
    for (int c = 0; c < 3; ++c) {
      const MaterialComponent& law = material.components.at(names[c]);
      const DahlParameters& dahl = law.friction->positive;
      stored += law.stiffness->first_moment(strains[c]);
      work += friction_work({dahl, dahl}, strains[c], {});
    }
    const Configuration at = mapped(state.configuration, map);
    const Energy energy = test::energy_of(*cloth.system, at, state);
    EXPECT_NEAR(energy.stored, kSize * kSize * stored, 1e-12 * kSize * kSize * (stored + work));
    EXPECT_NEAR(energy.work, kSize * kSize * work, 1e-12 * kSize * kSize * (stored + work));
    State after = state;
    EXPECT_NEAR(test::accept(*cloth.system, after, at), energy.work, 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(Measures, ClothPatch,
                         ::testing::Values(MembraneMeasure::stvk, MembraneMeasure::soft_constraint),
                         [](const auto& instance) {
                           return instance.param == MembraneMeasure::stvk ? "Stvk"
                                                                          : "SoftConstraint";
                         });

TEST(Cloth, GivesEachVertexAThirdOfItsTriangles) {
  const TriangleMesh grid = regular_grid(0.3, 0.2, 4, 3, Diagonals::rising);
  const Eigen::VectorXd areas = vertex_areas(grid);
  const double cell = 0.01;  // m^2
  EXPECT_NEAR(areas.sum(), 0.06, 1e-15);
  EXPECT_NEAR(areas(5), cell, 1e-15);      // inside: six halves of cells, a third each
  EXPECT_NEAR(areas(0), cell / 3, 1e-15);  // lower left: two triangles
  EXPECT_NEAR(areas(3), cell / 6, 1e-15);  // lower right: one
  EXPECT_NEAR(areas(1), cell / 2, 1e-15);  // along the edge: three
  EXPECT_NEAR(vertex_areas(test::jittered_grid(0.3, 0.2, 7, 5, 3)).sum(), 0.06, 1e-15);
}

TEST(Cloth, NamesItsParametersInTheOrderOfTheSystem) {
  Material material = test::frictional_cotton();
  material.components["shear"] = test::component_of(ScalarCurve::constant(20));
  material.components["bend.warp"].friction->negative = DahlParameters{1e-5, 0, 10};
  material.bending_of = "hinges";
  const auto cloth = test::cloth_system(regular_grid(kSize, kSize, 4, 4), material);
  const ParameterList& parameters = cloth.system->parameters();
  EXPECT_THAT(
      parameters.names,
      ElementsAre("stretch.weft.k1", "stretch.weft.k2", "stretch.weft.friction.a",
                  "stretch.weft.friction.b", "stretch.weft.friction.tau", "stretch.warp.k1",
                  "stretch.warp.k2", "stretch.warp.friction.a", "stretch.warp.friction.b",
                  "stretch.warp.friction.tau", "shear.k", "bend.weft.k", "bend.weft.friction.a",
                  "bend.weft.friction.b", "bend.weft.friction.tau", "bend.warp.k",
                  "bend.warp.friction.positive.a", "bend.warp.friction.positive.b",
                  "bend.warp.friction.positive.tau", "bend.warp.friction.negative.a",
                  "bend.warp.friction.negative.b", "bend.warp.friction.negative.tau",
                  "bend.diagonal.k", "bend.diagonal.friction.a", "bend.diagonal.friction.b",
                  "bend.diagonal.friction.tau"));
  ASSERT_EQ(parameters.values.size(), parameters.names.size());
  EXPECT_EQ(parameters.values[0], 135.6);
  EXPECT_EQ(parameters.values[10], 20);
  EXPECT_EQ(parameters.values[21], 10);
}

TEST(Cloth, HasNoFrictionWhereNoneIsAskedFor) {
  const TriangleMesh mesh = test::jittered_grid(kSize, kSize, 4, 4, 1);
  const auto cloth = test::cloth_system(mesh, test::uneven_cotton(), {.friction = false});
  cloth.system->finish();
  const State state = cloth.system->initial_state();
  RandomStream random(1);
  const Configuration at{test::shaken(mesh.positions, random, 0.003), {}};
  EXPECT_EQ(test::energy_of(*cloth.system, at, state).work, 0);
  EXPECT_GT(test::energy_of(*cloth.system, at, state).stored, 0);
  for (const std::string& name : cloth.system->parameters().names) {
    EXPECT_EQ(name.find("friction"), std::string::npos) << name;
  }
}

TEST(Cloth, DampsWithAFractionOfItsStiffnessAtUnitStrain) {
  Material material = test::uneven_cotton();
  material.components["stretch.weft"] = test::component_of(ScalarCurve::affine(135.6, 64.03));
  const auto cloth = test::cloth_system(regular_grid(kSize, kSize, 3, 3), material,
                                        {.friction = false, .damping_fraction = 0.05});
  cloth.system->finish();
  const State state = cloth.system->initial_state();
  const double stretch = 1.001, strain = (stretch * stretch - 1) / 2, h = 0.01;
  Configuration at = state.configuration;
  at.positions.row(0) *= stretch;
  const double coefficient = 0.05 * (135.6 + 64.03);
  EXPECT_NEAR(test::energy_of(*cloth.system, at, state, {1 / h, 1, 0}).work,
              kSize * kSize * coefficient * strain * strain / (2 * h), 1e-15);
}

TEST(Cloth, RefusesAComponentWithoutStiffness) {
  for (const char* name : {"stretch.warp", "shear", "bend.diagonal"}) {
    Material unmeasured = test::frictional_cotton(), absent = test::frictional_cotton();
    unmeasured.components[name].stiffness.reset();
    unmeasured.components[name].status = ComponentStatus::unmeasured;
    absent.components.erase(name);
    const TriangleMesh mesh = regular_grid(kSize, kSize, 4, 4);
    EXPECT_THROW(test::cloth_system(mesh, unmeasured), AssertionError) << name;
    EXPECT_THROW(test::cloth_system(mesh, absent), AssertionError) << name;
  }
}

TEST(Cloth, OfASingleTriangleDoesNotBend) {
  Eigen::Matrix2Xd vertices(2, 3);
  vertices << 0, 0.1, 0, 0, 0, 0.1;
  const auto cloth =
      test::cloth_system(flat_mesh(vertices, Eigen::Vector3i(0, 1, 2)), test::frictional_cotton());
  cloth.system->finish();
  EXPECT_EQ(cloth.system->make_hessian().matrix.pattern().block_count(), 6);
}

// Two materials on the halves of a mesh: the energy under uniform stretch is that of each half, and
// the second one's points may begin anywhere among the system's.
TEST(Cloth, MayHaveSeveralMaterials) {
  const TriangleMesh mesh = regular_grid(kSize, kSize, 5, 5);
  Material soft = test::frictional_cotton();
  soft.components["stretch.weft"] = test::component_of(ScalarCurve::constant(10));
  std::vector<int> left, right;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const double middle = mesh.rest_triangle(t).row(0).mean();
    (middle < kSize / 2 ? left : right).push_back(t);
  }
  const int first = 3;
  Eigen::Matrix3Xd positions = Eigen::Matrix3Xd::Zero(3, first + mesh.vertex_count());
  positions.rightCols(mesh.vertex_count()) = mesh.positions;
  System system(positions, Eigen::VectorXd::Ones(positions.cols()));
  const DensityOptions smooth{.friction = false};
  add_cloth(system, mesh, first, test::frictional_cotton(), left, smooth);
  const size_t of_first = system.parameters().names.size();
  add_cloth(system, mesh, first, soft, right, smooth);
  system.finish();
  const ParameterList& parameters = system.parameters();
  ASSERT_EQ(parameters.values.size(), parameters.names.size());
  EXPECT_EQ(parameters.names[of_first], "stretch.weft.k");

  const State state = system.initial_state();
  Configuration at = state.configuration;
  at.positions.row(0) *= 1.1;
  const double strain = (1.21 - 1) / 2, half = kSize * kSize / 2;
  const double expected = half * (135.6 / 2 * strain * strain + 64.03 / 3 * std::pow(strain, 3) +
                                  10.0 / 2 * strain * strain);
  EXPECT_NEAR(test::energy_of(system, at, state).stored, expected, 1e-13);

  // The second material's parameters reach the second half alone.
  Eigen::VectorXd values =
      Eigen::Map<const Eigen::VectorXd>(parameters.values.data(), std::ssize(parameters.values));
  values(static_cast<Eigen::Index>(of_first)) = 30;
  EXPECT_NEAR(test::energy_of(system, at, state, {}, system.with(values)).stored - expected,
              half * 20.0 / 2 * strain * strain, 1e-13);
}

// Two regions of one material are the cloth of that material: every hinge between them belongs to
// one of them, and their bending is converted as that of the whole.
TEST(Cloth, IsTheSameInOnePartAndInTwo) {
  const TriangleMesh mesh = regular_grid(kSize, kSize, 7, 7);
  for (const char* bending_of : {"hinges", "sheet"}) {
    Material material = test::uneven_cotton();
    material.bending_of = bending_of;
    std::vector<int> parts[2];
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      const Eigen::Vector2d middle = mesh.rest_triangle(t).rowwise().mean();
      parts[middle(0) + 0.4 * middle(1) < 0.6 * kSize ? 0 : 1].push_back(t);
    }
    System system(mesh.positions, Eigen::VectorXd::Ones(mesh.vertex_count()));
    for (const auto& part : parts) add_cloth(system, mesh, 0, material, part, {});
    system.finish();
    const auto whole = test::cloth_system(mesh, material);
    whole.system->finish();
    RandomStream random(1);
    const Configuration at{test::shaken(mesh.positions, random, 0.002), {}};
    const Eigen::Matrix3Xd expected =
        test::gradient_of(*whole.system, at, whole.system->initial_state());
    EXPECT_LT((test::gradient_of(system, at, system.initial_state()) - expected).norm(),
              1e-12 * expected.norm())
        << bending_of;
  }
}

// Springs.

Material sprung() {
  Material material = test::uneven_cotton();
  material.membrane = MembraneMeasure::spring;
  material.bending = "spring";
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    material.components[name] = test::component_of(ScalarCurve::constant(0.05));  // N
  }
  return material;
}

/// Energy per length or area of a component, with the work of its friction, at once from rest.
double density_of(const Material& material, const char* component, double strain) {
  const MaterialComponent& law = material.components.at(component);
  double energy = law.stiffness->first_moment(strain);
  if (law.friction) {
    energy += friction_work({law.friction->positive, law.friction->positive}, strain, {});
  }
  return energy;
}

TEST(ClothOfSprings, IsInBalanceInsideUnderUniformDeformation) {
  const auto cloth = test::cloth_system(regular_grid(kSize, 1.2 * kSize, 8, 8), sprung());
  cloth.system->finish();
  const State state = cloth.system->initial_state();
  for (const auto& map : affine_maps()) {
    const Eigen::Matrix3Xd force =
        test::gradient_of(*cloth.system, mapped(state.configuration, map), state);
    const double scale = force.colwise().norm().maxCoeff();
    for (int i = 0; i < force.cols(); ++i) {
      const int u = i % 8, v = i / 8;
      if (std::min(u, v) < 2 || std::max(u, v) > 5) continue;  // within two rings of the edge
      EXPECT_LT(force.col(i).norm(), 1e-12 * scale) << i;
    }
  }
}

TEST(ClothOfSprings, HasTheEnergyOfEachDirection) {
  const Material material = sprung();
  constexpr int kCells = 7;
  const auto cloth =
      test::cloth_system(regular_grid(kSize, kSize, kCells + 1, kCells + 1), material);
  cloth.system->finish();
  const State state = cloth.system->initial_state();
  const double edge = kSize / kCells;
  for (const auto& map : affine_maps()) {
    const double strain_u = map.col(0).norm() - 1, strain_v = map.col(1).norm() - 1;
    const double rising = (map.col(0) + map.col(1)).norm() / std::sqrt(2) - 1;
    const double falling = (map.col(0) - map.col(1)).norm() / std::sqrt(2) - 1;
    const double membrane =
        kSize * kSize *
        (density_of(material, "stretch.weft", strain_u) +
         density_of(material, "stretch.warp", strain_v) +
         (density_of(material, "shear", rising) + density_of(material, "shear", falling)) / 2);
    // Springs over two edges: in each row all but two nodes are the middle of one.
    const int straight = (kCells + 1) * (kCells - 1), across = (kCells - 1) * (kCells - 1);
    const double bending = 2 * edge *
                           (straight * (density_of(material, "bend.weft", strain_u) +
                                        density_of(material, "bend.warp", strain_v)) +
                            std::sqrt(2) * across *
                                (density_of(material, "bend.diagonal", rising) +
                                 density_of(material, "bend.diagonal", falling)));
    EXPECT_NEAR(test::energy_of(*cloth.system, mapped(state.configuration, map), state).total(),
                membrane + bending, 1e-12 * (membrane + bending));
  }
}

TEST(ClothOfSprings, NeedsAGrid) {
  EXPECT_TRUE(needs_grid(sprung()));
  EXPECT_FALSE(needs_grid(test::frictional_cotton()));
  EXPECT_THROW(test::cloth_system(test::jittered_grid(kSize, kSize, 5, 5, 1), sprung()),
               AssertionError);
}

}  // namespace
}  // namespace pliant
