// Solids under loads: a column against its closed form, a clamped cantilever, Cook's membrane and a
// twisted block against themselves on finer meshes, and what an equilibrium costs.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/math/root.h"
#include "pliant/solver/static_path.h"

#include "support/evaluate_system.h"
#include "support/solid_bodies.h"

namespace pliant {
namespace {

using test::Cells;

std::string name_of(Cells cells) { return cells == Cells::tetrahedra ? "tetrahedra" : "hexahedra"; }

/// The order at which three values on meshes of half the edges each go to their limit.
double order_of(const std::vector<double>& values) {
  return std::log2((values[0] - values[1]) / (values[1] - values[2]));
}

/// Where such values go at that order.
double limit_of(const std::vector<double>& values) {
  const double ratio = (values[1] - values[2]) / (values[0] - values[1]);
  return values[2] - (values[1] - values[2]) * ratio / (1 - ratio);
}

/// A column that hangs from its top, Poisson's ratio 0: below a point of rest height Z hangs the
/// weight g rho Z an area, and E (s^3 - s) / 2 carries it (StVK), s being the stretch.
class HangingColumn {
 public:
  static constexpr double kHeight = 0.5, kYoung = 5e4, kDensity = 1000, kGravity = 9.81;

  /// How long it is: the integral of s dZ, dZ = E (3 s^2 - 1) / (2 g rho) ds.
  static double length() {
    return kYoung / (kGravity * kDensity) * (antiderivative(stretch_at_top()) - antiderivative(1));
  }

 private:
  static double antiderivative(double s) { return 3 * std::pow(s, 4) / 8 - s * s / 4; }
  static double stretch_at_top() {
    const double load = kGravity * kDensity * kHeight;
    const auto excess = [&](double s) { return kYoung * (s * s * s - s) / 2 - load; };
    return first_root(excess, 1, 0.01, 10).value();
  }
};

test::SolidSystem hanging_column(Cells cells, int layers) {
  const double height = HangingColumn::kHeight;
  test::SolidSystem solid = test::solid_system(
      test::block_of(cells, {height / 4, height / 4, height}, {layers / 4, layers / 4, layers}),
      test::stvk_law({HangingColumn::kYoung, 0}), HangingColumn::kDensity);
  solid.hold(nodes_at(solid.mesh, 2, height));
  const Eigen::Vector3d gravity(0, 0, -HangingColumn::kGravity);
  solid.load(gravity * solid.system->masses().transpose());
  solid.system->finish();
  return solid;
}

TEST(SlowHangingColumn, ConvergesToTheClosedFormWithOrderTwoAtLeast) {
  EXPECT_GT(HangingColumn::length(), 1.04 * HangingColumn::kHeight);  // it does stretch
  for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra}) {
    std::vector<double> errors;
    for (const int layers : {8, 16}) {
      const test::SolidSystem solid = hanging_column(cells, layers);
      State state = solid.system->initial_state();
      EXPECT_TRUE(test::settle(*solid.system, state, 1e-7).converged);
      const std::vector<int> bottom = nodes_at(solid.mesh, 2, 0);
      const double length =
          HangingColumn::kHeight - state.configuration.positions(Eigen::all, bottom).row(2).mean();
      errors.push_back(std::abs(length - HangingColumn::length()));
    }
    const double order = std::log2(errors[0] / errors[1]);
    EXPECT_GT(order, 1.7) << name_of(cells) << " " << errors[0] << " to " << errors[1];
  }
}

TEST(HangingColumn, PullsAtItsTopWithItsWeight) {
  for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra}) {
    const test::SolidSystem solid = hanging_column(cells, 8);
    State state = solid.system->initial_state();
    EXPECT_TRUE(test::settle(*solid.system, state, 1e-9).converged);
    const Eigen::Matrix3Xd forces = test::gradient_of(*solid.system, state.configuration, state);
    const double height = HangingColumn::kHeight;
    const double weight = HangingColumn::kDensity * height * height * height / 16 * 9.81;
    EXPECT_NEAR(solid.system->masses().sum() * 9.81, weight, 1e-12 * weight);
    EXPECT_NEAR(forces.row(2).sum(), weight, 1e-7);  // the tolerance at each of 200 nodes
  }
}

/// Deflection of the tip of a cantilever of 2 x 1 x 1 m by a shear of its end face.
double tip_deflection(Cells cells, int across, const SolidLaw& law) {
  test::SolidSystem solid =
      test::solid_system(test::block_of(cells, {2, 1, 1}, {2 * across, across, across}), law);
  solid.hold(nodes_at(solid.mesh, 0, 0));
  const std::vector<int> tip = nodes_at(solid.mesh, 0, 2);
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(solid.mesh.node_count());
  const Eigen::Matrix3Xi surface = boundary_surface(solid.mesh).triangles;
  std::vector<int> end;
  for (int t = 0; t < surface.cols(); ++t) {
    const auto is_there = [&](int node) { return solid.mesh.positions(0, node) == 2; };
    if (is_there(surface(0, t)) && is_there(surface(1, t)) && is_there(surface(2, t))) {
      end.push_back(t);
    }
  }
  solid.load(traction_forces(solid.mesh.positions, surface(Eigen::all, end), {0, 0, -0.01}));
  solid.system->finish();
  State state = solid.system->initial_state();
  EXPECT_TRUE(test::settle(*solid.system, state, 1e-10).converged);
  const Eigen::Matrix3Xd change = state.configuration.positions - solid.mesh.positions;
  return -change(Eigen::all, tip).row(2).mean();
}

TEST(SlowCantilever, ConvergesAtSecondOrderToTheBeam) {
  for (const double poisson : {0.0, 0.499}) {
    // Where a solid that keeps its volume is clamped, its corners are singular: the order falls,
    // and the clamp, which holds the section's shape, makes a short bar stiffer than a beam.
    const bool keeps_volume = poisson > 0;
    const double least_order = keeps_volume ? 1.1 : 1.5, near_beam = keeps_volume ? 0.1 : 0.05,
                 near_other = keeps_volume ? 0.015 : 0.01;
    const SolidLaw law =
        keeps_volume ? test::rubber_law({1000, poisson}) : test::pointwise_rubber_law({1000, 0});
    // F L^3 / (3 E I) + F L / (5/6 G A) (Timoshenko).
    const double beam =
        0.01 * 8 / (3 * 1000 / 12.0) + 0.01 * 2 / (5.0 / 6 * 1000 / (2 * (1 + poisson)));
    std::vector<double> limits;
    for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra}) {
      std::vector<double> deflections;
      for (const int across : {3, 6, 12}) deflections.push_back(tip_deflection(cells, across, law));
      fmt::print("{:<11} {:5.3f} order {:.2f} limit {:.4g} m, of the beam {:.4g}\n", name_of(cells),
                 poisson, order_of(deflections), limit_of(deflections), beam);
      EXPECT_GT(order_of(deflections), least_order) << name_of(cells) << ", " << poisson;
      EXPECT_LT(order_of(deflections), 2.3) << name_of(cells) << ", " << poisson;
      limits.push_back(limit_of(deflections));
      // A bar no longer than two of its widths is no beam to better than that.
      EXPECT_NEAR(limits.back(), beam, near_beam * beam) << name_of(cells) << ", " << poisson;
    }
    EXPECT_NEAR(limits[0], limits[1], near_other * limits[1]) << poisson;
  }
}

/// Cook's membrane (48 x 44 to 60 mm, clamped on the left, sheared on the right by 1/16 N/mm^2 in
/// all), of one layer in plane strain; as much rubber as makes it bend far.
double cook_tip(Cells cells, int along, const SolidLaw& law) {
  VolumeMesh mesh = test::block_of(cells, {48, 1, 1}, {along, along, 1});
  for (auto p : mesh.positions.colwise()) {
    const double low = 44 * p.x() / 48, high = 44 + 16 * p.x() / 48;
    p.y() = low + (high - low) * p.y();
  }
  test::SolidSystem solid = test::solid_system(mesh, law);
  solid.hold(nodes_at(mesh, 0, 0));
  for (int i = 0; i < mesh.node_count(); ++i) {
    if (mesh.positions(0, i) > 0) solid.system->coordinates().prescribe_axis(i, 2);
  }
  const Eigen::Matrix3Xi surface = boundary_surface(mesh).triangles;
  std::vector<int> right;
  for (int t = 0; t < surface.cols(); ++t) {
    if (mesh.positions(Eigen::all, surface.col(t)).row(0).minCoeff() == 48) right.push_back(t);
  }
  solid.load(traction_forces(mesh.positions, surface(Eigen::all, right), {0, 1.0 / 16, 0}));
  solid.system->finish();
  State state = solid.system->initial_state();
  EXPECT_TRUE(test::settle(*solid.system, state, 1e-8).converged);
  Eigen::Index corner = 0;
  (mesh.positions.row(0) + mesh.positions.row(1)).maxCoeff(&corner);
  return state.configuration.positions(1, corner) - mesh.positions(1, corner);
}

TEST(SlowCooksMembrane, ConvergesWithoutLocking) {
  for (const double poisson : {0.3, 0.499}) {
    std::vector<double> limits;
    for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra}) {
      std::vector<double> tips;
      for (const int along : {6, 12, 24}) {
        tips.push_back(cook_tip(cells, along, test::rubber_law({2, poisson})));
      }
      limits.push_back(limit_of(tips));
      // The corner on the left is singular: first order and a half or so is what it allows.
      EXPECT_GT(order_of(tips), 0.9) << name_of(cells) << ", " << poisson;
      EXPECT_LT(order_of(tips), 2.3) << name_of(cells) << ", " << poisson;
      RecordProperty(name_of(cells) + std::to_string(poisson), std::to_string(tips[2]));
    }
    EXPECT_NEAR(limits[0], limits[1], 0.02 * limits[1]) << poisson;
  }
}

TEST(CooksMembrane, LocksWhereEveryPointHasAVolumeOfItsOwn) {
  const test::ElasticModuli moduli{2, 0.4999};
  for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra}) {
    const double pointwise = cook_tip(cells, 8, test::pointwise_rubber_law(moduli));
    const double mean = cook_tip(cells, 8, test::rubber_law(moduli));
    // Cells cut into six around their diagonals lock less than whole ones.
    EXPECT_LT(pointwise, (cells == Cells::hexahedra ? 0.7 : 0.9) * mean) << name_of(cells);
  }
}

/// Energy of a block of 1 x 1 x 2 m whose ends are turned against each other by a quarter.
double twist_energy(Cells cells, int across, double poisson) {
  test::SolidSystem solid =
      test::solid_system(test::block_of(cells, {1, 1, 2}, {across, across, 2 * across}),
                         test::rubber_law({1, poisson}));
  const std::vector<int> top = nodes_at(solid.mesh, 2, 2);
  solid.hold(nodes_at(solid.mesh, 2, 0));
  solid.hold(top);
  solid.system->finish();
  StaticPathOptions options;
  options.newton.tolerance = 1e-9;
  options.schedule = [&](double time) {
    Controls controls;
    const Eigen::AngleAxisd turn(time * std::numbers::pi / 2, Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d axis(0.5, 0.5, 0);
    for (const int node : top) {
      const Eigen::Vector3d place = solid.mesh.positions.col(node);
      controls.places.push_back({node, turn * (place - axis) + axis});
    }
    return controls;
  };
  StaticPath path(*solid.system, options);
  PathEquilibrium last;
  for (const double time : {0.25, 0.5, 0.75, 1.0}) last = path.step(time);
  return last.newton.energy.stored;
}

TEST(SlowTwistedBlock, ConvergesFromAbove) {
  for (const double poisson : {0.3, 0.499}) {
    std::vector<double> limits;
    for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra}) {
      std::vector<double> energies;
      for (const int across : {2, 4, 8}) energies.push_back(twist_energy(cells, across, poisson));
      EXPECT_GT(order_of(energies), 1.2) << name_of(cells) << ", " << poisson;
      EXPECT_LT(order_of(energies), 2.3) << name_of(cells) << ", " << poisson;
      limits.push_back(limit_of(energies));
    }
    EXPECT_NEAR(limits[0], limits[1], 0.02 * limits[1]) << poisson;
  }
}

// 5,000 tetrahedra that hang by a side and bend far.
TEST(SlowSolidEquilibrium, OfFiveThousandTetrahedraTakesTwentyIterationsAtMost) {
  for (const auto& law : {test::pointwise_rubber_law({2e4, 0.45}), test::rubber_law({2e4, 0.49})}) {
    test::SolidSystem solid =
        test::solid_system(block_of_tetrahedra({0.4, 0.1, 0.1}, {26, 6, 6}), law, 1000);
    EXPECT_GT(solid.mesh.element_count(), 5000);
    solid.hold(nodes_at(solid.mesh, 0, 0));
    solid.load(Eigen::Vector3d(0, 0, -9.81) * solid.system->masses().transpose());
    solid.system->finish();
    State state = solid.system->initial_state();
    const NewtonSummary found = test::settle(*solid.system, state, 1e-5);
    EXPECT_TRUE(found.converged);
    EXPECT_LE(found.iterations, 20);
    EXPECT_LT(state.configuration.positions.row(2).minCoeff(), -0.1);
  }
}

/// A bar held at one end and pulled at the other.
test::SolidSystem pulled_bar(test::Cells cells, const SolidLaw& law) {
  test::SolidSystem solid =
      test::solid_system(test::block_of(cells, {0.3, 0.1, 0.1}, {6, 2, 2}), law);
  solid.hold(nodes_at(solid.mesh, 0, 0));
  Eigen::Matrix3Xd load = Eigen::Matrix3Xd::Zero(3, solid.mesh.node_count());
  for (const int node : nodes_at(solid.mesh, 0, 0.3)) load.col(node) = Eigen::Vector3d(6, 2, 1);
  solid.load(load);
  solid.system->finish();
  return solid;
}

TEST(HeterogeneousBar, OfLikeSamplesIsTheHomogeneousBody) {
  for (const test::Cells cells : {test::Cells::tetrahedra, test::Cells::hexahedra}) {
    const test::SolidSystem one = pulled_bar(cells, solid_law(neo_hookean_solid(2e4, 1e5)));
    const test::SolidSystem many = pulled_bar(cells, solid_law(test::rubber_along_x({2, 2, 2})));
    State a = one.system->initial_state(), b = many.system->initial_state();
    EXPECT_TRUE(test::settle(*one.system, a, 1e-10).converged);
    EXPECT_TRUE(test::settle(*many.system, b, 1e-10).converged);
    EXPECT_LT((a.configuration.positions - b.configuration.positions).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(HeterogeneousBar, PositionsChangeWithTheNumbersOfEachSampleAsFiniteDifferencesSay) {
  for (const test::Cells cells : {test::Cells::tetrahedra, test::Cells::hexahedra}) {
    const std::vector<double> factors{1, 0.5, 2};
    const test::SolidSystem solid = pulled_bar(cells, solid_law(test::rubber_along_x(factors)));
    const System& system = *solid.system;
    ASSERT_EQ(system.parameters().names.size(), 6u);
    EXPECT_EQ(system.parameters().names[1], "samples[1].I1-bar.linear.c");
    EXPECT_EQ(system.parameters().names[5], "samples[2].J.k");
    StaticPath path(system, {.newton = {.tolerance = 1e-9}, .by = system.all_parameters()});
    const Eigen::MatrixXd by = path.step(1).by_parameter.positions;
    const Eigen::VectorXd values = Eigen::Map<const Eigen::VectorXd>(
        system.parameters().values.data(), std::ssize(system.parameters().values));
    for (Eigen::Index p = 0; p < values.size(); ++p) {
      const double step = 1e-4 * values(p);
      Eigen::VectorXd change = Eigen::VectorXd::Zero(by.rows());
      for (const double sign : {-1.0, 1.0}) {
        const Parameters other = system.with(values + sign * step * Eigen::VectorXd::Unit(6, p));
        StaticPath moved(system, {.newton = {.tolerance = 1e-10}, .parameters = other});
        moved.step(1);
        change += sign * moved.state().configuration.positions.reshaped() / (2 * step);
      }
      EXPECT_LT((change - by.col(p)).norm(), 1e-5 * by.col(p).norm()) << p;
    }
  }
}

}  // namespace
}  // namespace pliant
