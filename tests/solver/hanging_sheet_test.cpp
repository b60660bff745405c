#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"
#include "pliant/math/root.h"
#include "pliant/solver/static_solver.h"

#include "support/cloth_sheet.h"

namespace pliant {
namespace {

constexpr double kLength = 0.4, kStiffness = 4, kDensity = 0.4;

/// A sheet that hangs from its upper edge, in one direction only: below rest position Y hangs the
/// weight g rho (L - Y) per width, and k (stretch^3 - stretch) / 2 carries it (linear StVK), so
/// that dY = -k (3 stretch^2 - 1) / (2 g rho) dstretch.
class HangingSheet {
 public:
  HangingSheet() : upper_(stretch(0)) {}

  /// How far below the upper edge the point of rest distance Y hangs: the integral of stretch dY.
  double depth(double rest) const {
    return kStiffness / kWeight * (antiderivative(upper_) - antiderivative(stretch(rest)));
  }

 private:
  static constexpr double kWeight = 9.81 * kDensity;

  static double antiderivative(double s) { return 3 * std::pow(s, 4) / 8 - s * s / 4; }
  static double stretch(double rest) {
    const double load = kWeight * (kLength - rest);
    if (load <= 0) return 1;
    const auto excess = [&](double s) { return kStiffness * (s * s * s - s) / 2 - load; };
    return first_root(excess, 1, 0.01, 10).value();
  }

  double upper_;
};

/// Root mean square distance of a hanging sheet's vertices from the closed form.
double hanging_error(int rows) {
  Material material = test::linear_cloth(kStiffness, 1, 1e-5);
  material.density = kDensity;
  test::ClothSheet sheet(regular_grid(kLength / 2, kLength, rows / 2 + 1, rows), material);
  sheet.prescribe(sheet.row_at(kLength));
  sheet.add_gravity(-Eigen::Vector3d::UnitY());
  sheet.system.finish();
  State state = sheet.system.initial_state();
  NewtonOptions options;
  options.tolerance = 1e-10;
  EXPECT_TRUE(StaticSolver(sheet.system, options).find_equilibrium(state).converged);

  const HangingSheet exact;
  const Eigen::Matrix3Xd &rest = sheet.mesh.positions, &x = state.configuration.positions;
  double sum = 0;
  for (int i = 0; i < rest.cols(); ++i) {
    const Eigen::Vector3d hung(rest(0, i), kLength - exact.depth(kLength - rest(1, i)), 0);
    sum += (x.col(i) - hung).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(rest.cols()));
}

TEST(HangingSheet, ConvergesToTheClosedFormWithOrderTwo) {
  EXPECT_GT(HangingSheet().depth(kLength), 1.1 * kLength);  // it does stretch
  std::vector<double> errors;
  for (const int rows : {5, 9, 17, 33}) errors.push_back(hanging_error(rows));
  for (size_t i = 1; i < errors.size(); ++i) {
    const double order = std::log2(errors[i - 1] / errors[i]);
    EXPECT_GT(order, 1.8) << errors[i - 1] << " to " << errors[i];
    EXPECT_LT(order, 2.3) << errors[i - 1] << " to " << errors[i];
  }
}

}  // namespace
}  // namespace pliant
