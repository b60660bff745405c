// Strips of felt that the shell has bent, as measurements for a fit, which knows the elastica only.

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/estimation/study_fit.h"

#include "experiments_3d/shell_strip.h"
#include "support/published_bending.h"
#include "support/virtual_lab.h"

namespace pliant {
namespace {

constexpr double kLength = 0.1;  // m, of rolled strips

test::PublishedBending felt() { return test::published_bending()[0]; }

/// The profile of a strip as rows of a table: the clamp, then every fourth row of vertices.
/// @param setting  radius or overhang (m)
std::string profile_rows(double setting, double length, double curvature) {
  constexpr double kCell = 0.001;  // m
  constexpr size_t kEvery = 4;
  constexpr int kSteps = 16;
  const int rows = static_cast<int>(std::lround(length / kCell));
  const test::StripGrid grid{length, 0.002, rows, 2};
  test::ShellStrip shell(grid, test::bending_along_warp(felt().law(), felt().density), curvature);
  const std::vector<Eigen::Vector2d> points = shell.released(kSteps);
  std::string table = fmt::format("{},1,0,0,0\n", 1e3 * setting);
  int number = 0;
  for (size_t i = (points.size() - 1) % kEvery; i < points.size(); i += kEvery) {
    table += fmt::format("{},1,{},{},{}\n", 1e3 * setting, ++number, 1e3 * points[i].x(),
                         1e3 * points[i].y());
  }
  return table;
}

std::string rolled_table(const std::vector<double>& radii) {
  std::string table = "radius_mm,repeat,point,x_mm,y_mm\n";
  for (const double radius : radii) table += profile_rows(radius, kLength, 1 / radius);
  return table;
}

std::string hung_table(const std::vector<double>& overhangs) {
  std::string table = "overhang_mm,repeat,point,x_mm,y_mm\n";
  for (const double overhang : overhangs) table += profile_rows(overhang, overhang, 0);
  return table;
}

constexpr const char* kStudy = R"(pliant: study/1
name: felt of shells
density: 0.208 kg/m^2
experiments:
  - {name: rolls, type: rolled-strip, direction: warp, length: 100 mm, width: 25 mm, data: rolls.csv}
  - {name: overhangs, type: cantilever, direction: warp, width: 25 mm, data: overhangs.csv}
model: {stiffness: affine, friction: dahl}
)";

// Cells of 1 mm put profiles within 0.05 % of the length from the elastica's
// (elastica_shell_test.cpp), and parameters move by a few times that share. Cells of 2 mm: four
// times as far.
TEST(SlowShellProfiles, GiveTheLawOfTheShellBack) {
  constexpr double kTolerance = 5e-3;
  const test::LabFolder folder({{"study.yaml", kStudy},
                                {"rolls.csv", rolled_table({0.004, 0.006, 0.008, 0.012})},
                                {"overhangs.csv", hung_table({0.06, 0.1})}});
  const StudyResult result = fit_study(folder.study(), {}, {});
  EXPECT_TRUE(result.converged);
  EXPECT_TRUE(result.undetermined.empty());
  const Eigen::VectorXd truth = felt().law().parameters();
  ASSERT_EQ(std::ssize(result.parameters), truth.size());
  for (Eigen::Index i = 0; i < truth.size(); ++i) {
    const ParameterEstimate& found = result.parameters[static_cast<size_t>(i)];
    const double error = found.value / truth(i) - 1;
    std::cout << fmt::format("{}: {:+.2f} %\n", found.name, 100 * error);
    EXPECT_LT(std::abs(error), kTolerance) << found.name;
  }
}

}  // namespace
}  // namespace pliant
