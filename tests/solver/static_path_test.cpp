#include "pliant/solver/static_path.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/material/addend/addend_registry.h"
#include "pliant/mechanics/cord.h"

#include "support/cloth_sheet.h"

namespace pliant {
namespace {

using test::ClothSheet;

NewtonOptions tight() {
  NewtonOptions options;
  options.tolerance = 1e-12;  // N; forces are of the order of 0.1 N
  return options;
}

/// A horizontal sheet, held at its upper edge, with a free clip at its lower one that a cord lifts
/// and a load pulls; every strain component takes part. The load is `loads[i]` at time i + 1,
/// piecewise linear from 0 at time 0.
struct LoadedSheet : ClothSheet {
  static constexpr double kHeight = 0.08;
  std::vector<int> held = row_at(kHeight), clip = row_at(0);
  std::vector<double> loads{1, 2.5, 1.2, 0.4, 1.5};

  explicit LoadedSheet(const Material& material,
                       const TriangleMesh& sheet = regular_grid(0.06, kHeight, 4, 5))
      : ClothSheet(sheet, material) {
    prescribe(held);
    system.coordinates().add_clip(clip, false);
    Eigen::VectorXd pulled = Eigen::VectorXd::Zero(system.points());
    pulled(clip).setOnes();
    system.add(std::make_shared<PointForces>(0, pulled));
    system.add(std::make_shared<Cord>(clip.back(), 5, 0.02, Eigen::Vector3d(0.08, -0.02, 0.01)));
    add_gravity();
    system.finish();
  }

  Controls controls(double time) const {
    Controls controls;
    controls.vectors = load(time) * Eigen::Vector3d(0.03, -0.1, -0.02);
    controls.places = places(held);
    for (Controls::Place& place : controls.places) {
      place.position.y() = kHeight + 0.002 * load(time);
    }
    return controls;
  }
  StaticPathOptions options() const {
    StaticPathOptions options;
    options.newton = tight();
    options.schedule = [this](double time) { return controls(time); };
    return options;
  }

  double load(double time) const {
    const size_t i = std::min(static_cast<size_t>(time), loads.size() - 1);
    const double from = i == 0 ? 0 : loads[i - 1];
    return from + (time - static_cast<double>(i)) * (loads[i] - from);
  }
};

struct Walk {
  std::vector<Eigen::VectorXd> positions, forces;  // at each time of the schedule
  std::vector<PathEquilibrium> points;
};

Walk walk(const LoadedSheet& sheet, const Eigen::VectorXd& parameters, bool sensitivities) {
  StaticPathOptions options = sheet.options();
  options.parameters = sheet.system.with(parameters);
  if (sensitivities) options.by = sheet.system.all_parameters();
  StaticPath path(sheet.system, options);
  Walk walk;
  for (size_t i = 1; i <= sheet.loads.size(); ++i) {
    walk.points.push_back(path.step(static_cast<double>(i)));
    walk.positions.push_back(path.state().configuration.positions.reshaped());
    walk.forces.push_back(walk.points.back().forces.reshaped());
  }
  return walk;
}

// Cotton whose friction grows with strain in every component: no parameter is zero, and along the
// loads of these tests no element turns around a step earlier when a parameter changes a little.
Material growing_cotton() {
  Material material = test::cotton();
  for (auto& [name, component] : material.components) {
    DahlParameters& dahl = component.friction->positive;
    if (dahl.b == 0) dahl.b = 0.05 * component.stiffness->value(0);
  }
  return material;
}

// Cotton that yields in every component at strains that these loads come to.
Material yielding_cotton() {
  Material material = test::cotton();
  for (auto& [name, component] : material.components) {
    component.friction.reset();
    component.addends = {
        {*find_addend_kind("plastic"),
         Eigen::Vector2d(0.5 * component.stiffness->value(0), is_bending(name) ? 8 : 0.004)}};
  }
  return material;
}

Eigen::VectorXd values_of(const System& system) {
  const std::vector<double>& values = system.parameters().values;
  return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
}

void expect_derivatives(const LoadedSheet& sheet) {
  const Eigen::VectorXd parameters = values_of(sheet.system);
  const std::vector<std::string>& names = sheet.system.parameters().names;
  const Walk at = walk(sheet, parameters, true);
  for (Eigen::Index k = 0; k < parameters.size(); ++k) {
    // Truncation costs about 1e-7 of a derivative at this change.
    const double change = 2e-4 * parameters(k);
    Eigen::VectorXd more = parameters, less = parameters;
    more(k) += change;
    less(k) -= change;
    const Walk up = walk(sheet, more, false), down = walk(sheet, less, false);
    for (size_t i = 0; i < at.points.size(); ++i) {
      const Eigen::VectorXd x = (up.positions[i] - down.positions[i]) / (2 * change);
      const Eigen::VectorXd f = (up.forces[i] - down.forces[i]) / (2 * change);
      const double x_error = (at.points[i].by_parameter.positions.col(k) - x).norm();
      const double f_error = (at.points[i].by_parameter.forces.col(k) - f).norm();
      // What rounding leaves of the paths, over the change: the tolerance over the stiffness of
      // bending, and what that makes of the membrane's forces.
      EXPECT_LT(x_error, 1e-5 * x.norm() + 1e-12 / change) << names[k] << " " << i;
      EXPECT_LT(f_error, 1e-5 * f.norm() + 5e-12 / change) << names[k] << " " << i;
    }
  }
}

TEST(StaticPath, GoesTheSameWayFromGuessesNearIt) {
  LoadedSheet sheet(growing_cotton());
  const Walk plain = walk(sheet, values_of(sheet.system), false);
  StaticPath path(sheet.system, sheet.options());
  for (size_t i = 0; i < sheet.loads.size(); ++i) {
    Configuration guess = path.state().configuration;
    sheet.system.coordinates().apply(sheet.controls(static_cast<double>(i + 1)), guess);
    for (int p = 0; p < sheet.system.points(); ++p) {
      if (sheet.system.coordinates().is_free(p)) guess.positions(2, p) += 1e-5;
    }
    path.step(static_cast<double>(i + 1), guess);
    const Eigen::VectorXd found = path.state().configuration.positions.reshaped();
    // What the tolerance leaves, over the stiffness of bending.
    EXPECT_LT((found - plain.positions[i]).norm(), 1e-8) << i;
  }
}

TEST(StaticPath, SensitivitiesAreThoseOfWholePathsWithFriction) {
  LoadedSheet sheet(growing_cotton());
  expect_derivatives(sheet);
}

TEST(StaticPath, SensitivitiesAreThoseOfWholePathsWithoutFriction) {
  LoadedSheet sheet(test::linear_cloth(100, 30, 1e-4));
  expect_derivatives(sheet);
}

TEST(StaticPath, SensitivitiesAreThoseOfWholePathsWithYield) {
  expect_derivatives(LoadedSheet(yielding_cotton()));
}

TEST(StaticPath, SensitivitiesBeginWithThoseOfAStrainedStart) {
  // The friction stress that the initial shape has brought depends on the parameters.
  TriangleMesh mesh = regular_grid(0.06, LoadedSheet::kHeight, 4, 5);
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    const double u = mesh.positions(0, i), v = mesh.positions(1, i);
    mesh.positions.col(i) << 1.02 * u + 0.1 * v * (LoadedSheet::kHeight - v), v, 10 * u * u;
  }
  LoadedSheet sheet(growing_cotton(), mesh);
  sheet.loads = {1, 0.5};
  expect_derivatives(sheet);
}

TEST(StaticPath, SensitivitiesFollowSubsteps) {
  LoadedSheet sheet(test::cotton());
  StaticPathOptions options = sheet.options();
  options.by = sheet.system.all_parameters();
  StaticPath coarse(sheet.system, options);
  for (const double time : {0.5, 1.0, 1.5, 2.0}) coarse.step(time);
  options.substeps = 2;
  StaticPath fine(sheet.system, options);
  fine.step(1);
  const PathEquilibrium point = fine.step(2);
  EXPECT_EQ(point.equilibria, 2);
  EXPECT_EQ(fine.state().configuration.positions, coarse.state().configuration.positions);
  EXPECT_EQ(fine.history_by_parameter(), coarse.history_by_parameter());
}

void expect_another_way_back(const Material& material) {
  LoadedSheet sheet(material);
  sheet.loads = {1, 3, 1};
  StaticPath path(sheet.system, sheet.options());
  path.step(1);
  const Configuration loading = path.state().configuration;
  EXPECT_GT(path.step(2).work, 0);
  path.step(3);
  const Eigen::Matrix3Xd difference = path.state().configuration.positions - loading.positions;
  EXPECT_GT(difference.colwise().norm().maxCoeff(), 1e-4);
}

TEST(StaticPath, FrictionMakesLoadingAndUnloadingDiffer) {
  expect_another_way_back(test::cotton());
}

TEST(StaticPath, YieldMakesLoadingAndUnloadingDiffer) {
  expect_another_way_back(yielding_cotton());
}

TEST(StaticPath, AStepThatDoesNotConvergeIsHalved) {
  LoadedSheet sheet(test::linear_cloth(100, 30, 1e-4));
  StaticPathOptions options = sheet.options();
  StaticPath whole(sheet.system, options);
  whole.step(1);
  const State start = whole.state();
  const int iterations = whole.step(2).newton.iterations;
  ASSERT_GT(iterations, 3);

  options.newton.max_iterations = iterations - 1;
  StaticPath halved(sheet.system, options, start);
  const PathEquilibrium point = halved.step(2);
  EXPECT_TRUE(point.newton.converged);
  EXPECT_GT(point.equilibria, 1);
  EXPECT_EQ(point.time, 2);
  EXPECT_EQ(halved.state().time, 2);
  // Elastic: the same equilibrium, to the tolerance over the softest stiffness.
  EXPECT_LT((halved.state().configuration.positions - whole.state().configuration.positions)
                .colwise()
                .norm()
                .maxCoeff(),
            1e-7);
}

TEST(StaticPath, GivesUpWithTheTimeAndTheResidual) {
  LoadedSheet sheet(test::linear_cloth(100, 30, 1e-4));
  StaticPathOptions options = sheet.options();
  options.newton = {.max_iterations = 1};
  options.max_halvings = 2;
  StaticPath path(sheet.system, options);
  try {
    path.step(1);
    FAIL() << "no error";
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("at 0.25"), std::string::npos) << error.what();
    EXPECT_GT(error.best_residual(), options.newton.tolerance);
  }
  EXPECT_EQ(path.state().time, 0);
}

TEST(StaticPath, SensitivityOfAnUnstableEquilibriumIsRefused) {
  // A flat sheet without gravity, its ends pushed together: an equilibrium, but not a stable one.
  ClothSheet sheet(regular_grid(0.05, 0.1, 3, 9), test::linear_cloth(100, 30, 1e-6));
  const std::vector<int> low = sheet.row_at(0), high = sheet.row_at(0.1);
  sheet.prescribe(low);
  sheet.prescribe(high);
  sheet.system.finish();
  StaticPathOptions options;
  options.schedule = [&](double time) {
    Controls controls;
    controls.places = sheet.places(high);
    for (Controls::Place& place : controls.places) place.position.y() *= 1 - 0.1 * time;
    return controls;
  };
  Configuration shorter{sheet.mesh.positions, {}};
  shorter.positions.row(1) *= 0.9;
  StaticPath(sheet.system, options).step(1, shorter);
  options.by = sheet.system.all_parameters();
  StaticPath path(sheet.system, options);
  EXPECT_THROW(path.step(1, shorter), SolverError);
  EXPECT_EQ(path.state().time, 0);
}

TEST(StaticPath, AClipOnItsOwnLineOfPointsHasSensitivities) {
  // The clip may turn about its line of points, which no force resists.
  ClothSheet sheet(regular_grid(0.05, 0.1, 3, 5), test::linear_cloth(100, 30, 1e-5));
  const std::vector<int> low = sheet.row_at(0);
  sheet.prescribe(sheet.row_at(0.1));
  sheet.system.coordinates().add_clip(low, false);
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, sheet.system.points());
  for (const int i : low) forces(1, i) = -0.1;
  sheet.system.add(std::make_shared<PointForces>(forces));
  sheet.system.finish();
  StaticPathOptions options;
  options.newton = tight();
  options.by = sheet.system.all_parameters();
  StaticPath path(sheet.system, options);
  const PathEquilibrium point = path.step(1);

  // Uniform stretch: width k (s^3 - s) / 2 = force, so ds/dk = -(s^3 - s) / (k (3 s^2 - 1)).
  const double length = 0.1 - path.state().configuration.positions(1, low[0]);
  const double s = length / 0.1;
  const double by_stiffness = -0.1 * (s * s * s - s) / (100 * (3 * s * s - 1));
  EXPECT_GT(s, 1.02);
  const auto& names = sheet.system.parameters().names;
  const auto warp = std::find(names.begin(), names.end(), "stretch.warp.k") - names.begin();
  ASSERT_LT(warp, std::ssize(names));
  EXPECT_NEAR(point.by_parameter.positions(3 * low[0] + 1, warp), -by_stiffness,
              1e-7 * std::abs(by_stiffness));  // rounding over the stiffness of bending
}

}  // namespace
}  // namespace pliant
