// What every mesh of solids must hold exactly: a uniform deformation of its surface is one of all
// of it, whatever the elements' shapes.

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

#include "support/evaluate_system.h"
#include "support/solid_bodies.h"

namespace pliant {
namespace {

using test::Cells;

constexpr test::ElasticModuli kModuli{1, 0.3};

const std::vector<std::pair<std::string, SolidLaw>>& laws() {
  static const std::vector<std::pair<std::string, SolidLaw>> all{
      {"stvk", test::stvk_law(kModuli)},
      {"rubber with a volume at every point", test::pointwise_rubber_law(kModuli)},
      {"rubber with one volume an element", test::rubber_law(kModuli)}};
  return all;
}

Eigen::Matrix3d some_deformation() {
  Eigen::Matrix3d f;
  f << 1.2, 0.1, -0.05, 0.15, 0.9, 0.1, -0.1, 0.2, 1.1;
  return f;
}

class Patch : public ::testing::TestWithParam<Cells> {};

TEST_P(Patch, DeformsUniformlyUnderAUniformDeformationOfItsSurface) {
  const Eigen::Matrix3d f = some_deformation();
  RandomStream random(1);
  for (const double share : {0.0, 0.2}) {
    const VolumeMesh mesh =
        shaken_inside(test::block_of(GetParam(), {1, 1, 1}, {4, 3, 3}), share, 2);
    const Eigen::Matrix3Xd expected = f * mesh.positions;
    for (const auto& [name, law] : laws()) {
      Eigen::Matrix3Xd start = expected;
      const std::vector<int> held = test::surface_nodes(mesh);
      EXPECT_LT(std::ssize(held), mesh.node_count());
      for (double& x : start.reshaped()) x += 0.01 * random.normal();
      start(Eigen::all, held) = expected(Eigen::all, held);
      test::SolidSystem solid = test::solid_system(mesh, law, 0, start);
      solid.hold(held);
      solid.system->finish();
      State state = solid.system->initial_state();
      // Forces are near 1 N: rounding; Newton's last step takes the rest to its square.
      const NewtonSummary found = test::settle(*solid.system, state, 1e-13);
      EXPECT_TRUE(found.converged) << name;
      EXPECT_LT((state.configuration.positions - expected).cwiseAbs().maxCoeff(), 1e-12) << name;
    }
  }
}

TEST_P(Patch, HasOneStrainEverywhere) {
  const Eigen::Matrix3d f = some_deformation();
  const VolumeMesh mesh = shaken_inside(test::block_of(GetParam(), {1, 1, 1}, {3, 3, 3}), 0.2, 3);
  const test::SolidSystem solid =
      test::solid_system(mesh, test::rubber_law(kModuli), 0, f * mesh.positions);
  solid.system->finish();
  const State state = solid.system->initial_state();
  const Eigen::Matrix3d e = (f.transpose() * f - Eigen::Matrix3d::Identity()) / 2;
  Eigen::Vector<double, 6> expected;
  expected << e(0, 0), e(1, 1), e(2, 2), 2 * e(1, 2), 2 * e(0, 2), 2 * e(0, 1);
  ASSERT_EQ(solid.solid.shown.size(), 2U);
  const auto values = [&](size_t part) {
    const ShownPotential& shown = solid.solid.shown[part];
    return shown.fields->field_values(solid.system->history_of(*shown.potential, state));
  };
  EXPECT_LT((values(0).colwise() - expected).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LT((values(1).array() - (f.determinant() - 1)).abs().maxCoeff(), 1e-13);
}

TEST(SolidLaw, HasTheStiffnessOfElasticityAtRest) {
  const double lambda = kModuli.lambda(), mu = kModuli.shear();
  Eigen::Matrix<double, 6, 6> expected = Eigen::Matrix<double, 6, 6>::Zero();
  expected.topLeftCorner<3, 3>().setConstant(lambda);
  expected.diagonal() << lambda + 2 * mu, lambda + 2 * mu, lambda + 2 * mu, mu, mu, mu;
  for (const auto& [name, law] : laws()) {
    EXPECT_TRUE(stiffness_at_rest(law).isApprox(expected, 1e-13)) << name;
  }
}

// The work of a deformation is its density times the volume, one volume an element or not.
TEST_P(Patch, StoresTheEnergyOfTheLaw) {
  const Eigen::Matrix3d f = some_deformation();
  const VolumeMesh mesh = shaken_inside(test::block_of(GetParam(), {1, 2, 1}, {2, 3, 2}), 0.2, 4);
  const auto energy = [&](const SolidLaw& law) {
    const test::SolidSystem solid = test::solid_system(mesh, law, 0, f * mesh.positions);
    solid.system->finish();
    const State state = solid.system->initial_state();
    return test::energy_of(*solid.system, state.configuration, state).stored;
  };
  const double volume = element_volumes(mesh).sum();
  EXPECT_NEAR(volume, 2, 1e-13);
  const double j = f.determinant(), trace = f.squaredNorm();
  const double expected =
      kModuli.shear() / 2 * (trace / std::cbrt(j * j) - 3) + kModuli.bulk() / 2 * (j - 1) * (j - 1);
  EXPECT_NEAR(energy(test::rubber_law(kModuli)), expected * volume, 1e-13);
  EXPECT_NEAR(energy(test::pointwise_rubber_law(kModuli)), expected * volume, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Solids, Patch, ::testing::Values(Cells::tetrahedra, Cells::hexahedra),
                         [](const auto& one) {
                           return one.param == Cells::tetrahedra ? "Tetrahedra" : "Hexahedra";
                         });

}  // namespace
}  // namespace pliant
