// A bar bent by a little is a solution of elasticity in closed form: errors against it fall at the
// order of the elements, for materials of nearly constant volume too where volumes are those of
// elements and nodes.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/solid_bodies.h"

namespace pliant {
namespace {

using test::Cells;

constexpr double kLength = 2, kWidth = 1;  // m
constexpr double kCurvature = 1e-5;        // 1/m: what is left of second order is as small

/// Bent in the plane of x and y about the line y = z = 0 with stress along x alone.
Eigen::Vector3d bent(const Eigen::Vector3d& p, double poisson) {
  const double x = p.x(), y = p.y(), z = p.z();
  return kCurvature *
         Eigen::Vector3d(-x * y, x * x / 2 + poisson * (y * y - z * z) / 2, poisson * y * z);
}

Eigen::Matrix3Xd all_bent(const VolumeMesh& mesh, double poisson) {
  Eigen::Matrix3Xd displacements(3, mesh.node_count());
  for (int i = 0; i < mesh.node_count(); ++i) {
    displacements.col(i) = bent(mesh.positions.col(i), poisson);
  }
  return displacements;
}

VolumeMesh bar(Cells cells, int across) {
  VolumeMesh mesh = test::block_of(cells, {kLength, kWidth, kWidth}, {2 * across, across, across});
  mesh.positions.row(1).array() -= kWidth / 2;
  mesh.positions.row(2).array() -= kWidth / 2;
  return mesh;
}

struct BentBar {
  double error = 0;   ///< of the nodes' displacements, root mean square over that of themselves
  double energy = 0;  ///< over that of the beam
};

/// The ends of the bar are led, its sides are free.
BentBar bent_bar(Cells cells, int across, const SolidLaw& law, double poisson) {
  const VolumeMesh mesh = bar(cells, across);
  const Eigen::Matrix3Xd exact = all_bent(mesh, poisson);
  Eigen::Matrix3Xd start = mesh.positions;
  std::vector<int> ends = nodes_at(mesh, 0, 0);
  for (const int node : nodes_at(mesh, 0, kLength)) ends.push_back(node);
  for (const int node : ends) start.col(node) += exact.col(node);
  test::SolidSystem solid = test::solid_system(mesh, law, 0, start);
  solid.hold(ends);
  solid.system->finish();
  State state = solid.system->initial_state();
  // A hundred thousandth of the forces between elements.
  const NewtonSummary found =
      test::settle(*solid.system, state, 1e-5 * kCurvature / (across * across));
  EXPECT_TRUE(found.converged);
  const Eigen::Matrix3Xd error = state.configuration.positions - mesh.positions - exact;
  const Eigen::VectorXd weights = node_volumes(mesh);
  const auto mean = [&](const Eigen::Matrix3Xd& values) {
    return std::sqrt(values.colwise().squaredNorm().dot(weights));
  };
  const double beam = kCurvature * kCurvature * std::pow(kWidth, 4) / 12 * kLength / 2;
  return {mean(error) / mean(exact), found.energy.stored / beam};
}

struct Case {
  const char* name;
  Cells cells;
  double poisson;
};

class Bending : public ::testing::TestWithParam<Case> {};

TEST_P(Bending, ConvergesAtSecondOrder) {
  const auto& [name, cells, poisson] = GetParam();
  const SolidLaw law = test::rubber_law({1, poisson});
  const double coarse = bent_bar(cells, 4, law, poisson).error;
  const double fine = bent_bar(cells, 8, law, poisson).error;
  const double order = std::log2(coarse / fine);
  RecordProperty("error", std::to_string(fine));
  RecordProperty("order", std::to_string(order));
  EXPECT_GT(order, 1.7);
  EXPECT_LT(order, 2.5);
  EXPECT_LT(fine, 5e-3);
}

INSTANTIATE_TEST_SUITE_P(Solids, Bending,
                         ::testing::Values(Case{"Tetrahedra30", Cells::tetrahedra, 0.3},
                                           Case{"Tetrahedra49", Cells::tetrahedra, 0.49},
                                           Case{"Tetrahedra499", Cells::tetrahedra, 0.499},
                                           Case{"Hexahedra30", Cells::hexahedra, 0.3},
                                           Case{"Hexahedra49", Cells::hexahedra, 0.49},
                                           Case{"Hexahedra499", Cells::hexahedra, 0.499}),
                         [](const auto& one) { return one.param.name; });

// With the volume at every point instead, elements lock.
TEST(BendingLocks, WhereEveryPointHasAVolumeOfItsOwn) {
  for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra}) {
    const test::ElasticModuli moduli{1, 0.499};
    const auto energy = [&](const SolidLaw& law) {
      return bent_bar(cells, 4, law, moduli.poisson).energy;
    };
    EXPECT_GT(energy(test::pointwise_rubber_law(moduli)), 1.4);
    EXPECT_LT(energy(test::rubber_law(moduli)), 1.25);
  }
}

}  // namespace
}  // namespace pliant
