// Components of cloth on metrics of their triangles ([T] 4.2.1): the energies that their names say,
// whichever way the sheet is turned, and those of a solid that keeps its thickness.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "pliant/geometry/block_mesh.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/material/fill.h"
#include "pliant/material/sheet_metric.h"
#include "pliant/mechanics/cloth_potentials.h"
#include "pliant/mechanics/solid_potentials.h"

#include "support/evaluate_system.h"

namespace pliant {
namespace {

constexpr double kStiffness = 50, kWidth = 0.1, kHeight = 0.2;

struct NamedStrain {
  std::string component;
  /// Values whose squares add up, of the sheet's deformation gradient.
  std::function<std::vector<double>(const Eigen::Matrix2d& f)> values;
};

Eigen::Vector2d stretches(const Eigen::Matrix2d& f) {
  return Eigen::JacobiSVD<Eigen::Matrix2d>(f).singularValues();
}

Eigen::Matrix2d green(const Eigen::Matrix2d& f) {
  return (f.transpose() * f - Eigen::Matrix2d::Identity()) / 2;
}

const std::vector<NamedStrain>& named_strains() {
  using F = Eigen::Matrix2d;
  static const std::vector<NamedStrain> strains{
      {"coupling", [](const F& f) { return std::vector{green(f).trace()}; }},
      {"cross-modal", [](const F& f) { return std::vector{green(f).squaredNorm()}; }},
      {"area", [](const F& f) { return std::vector{f.determinant() - 1}; }},
      {"log-area", [](const F& f) { return std::vector{std::log(f.determinant())}; }},
      {"invariant.1", [](const F& f) { return std::vector{f.squaredNorm() - 2}; }},
      {"invariant.2",
       [](const F& f) {
         return std::vector{f.squaredNorm() + f.determinant() * f.determinant() - 3};
       }},
      {"thread.weft", [](const F& f) { return std::vector{f.col(0).norm() - 1}; }},
      {"thread.warp", [](const F& f) { return std::vector{f.col(1).norm() - 1}; }},
      {"principal.stretch",
       [](const F& f) {
         return std::vector{stretches(f)(0) - 1, stretches(f)(1) - 1};
       }},
      {"principal.log-stretch",
       [](const F& f) {
         return std::vector{std::log(stretches(f)(0)), std::log(stretches(f)(1))};
       }},
      {"stretch.weft*stretch.warp",
       [](const F& f) { return std::vector{green(f)(0, 0) * green(f)(1, 1)}; }},
      {"stretch.warp*shear",
       [](const F& f) { return std::vector{green(f)(1, 1) * 2 * green(f)(0, 1)}; }},
  };
  return strains;
}

Material with_metric(const std::string& component) {
  Material material;
  material.name = "cloth";
  for (const std::string& name : sheet_component_names()) {
    material.components[name].stiffness = ScalarCurve::constant(is_bending(name) ? 1e-6 : 20);
  }
  if (!component.empty()) {
    material.components[component].stiffness = ScalarCurve::constant(kStiffness);
  }
  return material;
}

double energy_of_sheet(const Material& material, const Eigen::Matrix2d& f) {
  const TriangleMesh mesh = regular_grid(kWidth, kHeight, 3, 4);
  System system(mesh.positions, Eigen::VectorXd::Zero(mesh.vertex_count()));
  add_cloth(system, mesh, material, {});
  system.finish();
  Configuration at = system.initial_state().configuration;
  at.positions.topRows<2>() = f * mesh.positions.topRows<2>();
  const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1, 2, -0.5).normalized());
  at.positions = turn.toRotationMatrix() * at.positions;
  return test::energy_of(system, at, system.initial_state()).stored;
}

std::vector<Eigen::Matrix2d> deformations() {
  std::vector<Eigen::Matrix2d> all(4);
  all[0] << 1.2, 0.1, 0.05, 0.9;
  all[1] << 0.95, -0.3, 0.1, 1.3;
  all[2] << 1.1, 0, 0, 1.1;  // both principal stretches alike
  all[3] << 1.0, 0.2, 0, 1.0;
  return all;
}

TEST(SheetMetrics, StoreTheEnergyOfWhatTheirNamesSay) {
  for (const NamedStrain& strain : named_strains()) {
    for (const Eigen::Matrix2d& f : deformations()) {
      double expected = 0;
      for (const double value : strain.values(f)) expected += kStiffness * value * value / 2;
      const double added =
          energy_of_sheet(with_metric(strain.component), f) - energy_of_sheet(with_metric(""), f);
      EXPECT_NEAR(added / (kWidth * kHeight), expected, 1e-9 * (1 + expected)) << strain.component;
    }
  }
}

TEST(SheetMetrics, AreAllTested) {
  for (const SheetMetric& metric : sheet_metrics()) {
    const bool tested = std::ranges::any_of(named_strains(), [&](const NamedStrain& strain) {
      return strain.component == metric.name;
    });
    EXPECT_TRUE(tested) << metric.name;
  }
}

// One tree of densities on triangles and on solids: per area of the one what it is per volume of
// the other.
TEST(SheetMetrics, AreThoseOfASolidThatKeepsItsThickness) {
  const VolumeMesh block = block_of_hexahedra({1, 1, 1}, {1, 1, 1});
  for (const NamedStrain& strain : named_strains()) {
    Material solid;
    solid.kind = MaterialKind::solid;
    solid.components[*solid_metric_of(strain.component)].stiffness =
        ScalarCurve::constant(kStiffness);
    for (const Eigen::Matrix2d& f : deformations()) {
      System system(block.positions, Eigen::VectorXd::Zero(block.positions.cols()));
      add_solid(system, block, solid_law(solid));
      system.finish();
      Configuration at = system.initial_state().configuration;
      at.positions.topRows<2>() = f * block.positions.topRows<2>();
      const double per_volume = test::energy_of(system, at, system.initial_state()).stored;
      const double per_area = (energy_of_sheet(with_metric(strain.component), f) -
                               energy_of_sheet(with_metric(""), f)) /
                              (kWidth * kHeight);
      EXPECT_NEAR(per_area, per_volume, 1e-9 * (1 + per_volume)) << strain.component;
    }
  }
}

TEST(SheetMetrics, WriteTermsOfTwoStrainsInOneWay) {
  EXPECT_EQ(*solid_metric_of("stretch.weft*shear@0.1/0.2~0.05/0.1"),
            "green.xx*green.xy@0.1/0.2~0.05/0.1");
  EXPECT_EQ(*sheet_pair_name("stretch.weft*shear@0.10/0.2~0.05/0.1"),
            "stretch.weft*shear@0.1/0.2~0.05/0.1");
  for (const char* other : {"shear*stretch.weft", "stretch.weft*bend.weft", "stretch.weft", "*",
                            "green.xx*green.yy", "stretch.weft@0.1*shear"}) {
    EXPECT_FALSE(sheet_pair_name(other)) << other;
  }
}

}  // namespace
}  // namespace pliant
