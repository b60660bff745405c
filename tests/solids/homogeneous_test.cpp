// Homogeneous deformations of solids against closed forms, and their derivatives.

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/experiment/homogeneous/homogeneous_predictor.h"
#include "pliant/material/solid/standard_solids.h"
#include "pliant/math/check_derivatives.h"

#include "solids/solid_labs.h"

namespace pliant {
namespace {

using test::component_of;
using test::solid_of;

std::vector<double> stresses(const Material& material, const std::vector<HomogeneousRow>& rows,
                             bool incompressible = true) {
  const auto found =
      homogeneous_stresses(*solid_density(material).law, rows, {0}, incompressible, false);
  std::vector<double> values;
  for (const HomogeneousStress& stress : found.value()) values.push_back(stress.value);
  return values;
}

TEST(Homogeneous, NeoHookeanStressesAreTheirClosedForms) {
  constexpr double kC = 0.4e6;
  const Material material = solid_of({{"I1-bar", component_of({test::linear(kC)})}});
  const auto stress = [&](HomogeneousMode mode, double stretch, double second = 1) {
    return stresses(material, {{mode, stretch, second}}).front();
  };
  for (const double s : {0.5, 0.9, 1.0, 1.3, 4.0, 7.0}) {
    const double tolerance = 1e-12 * kC * (s + std::pow(s, -5));  // of the sum of both terms
    EXPECT_NEAR(stress(HomogeneousMode::uniaxial, s), 2 * kC * (s - std::pow(s, -2)), tolerance);
    EXPECT_NEAR(stress(HomogeneousMode::equibiaxial, s), 2 * kC * (s - std::pow(s, -5)), tolerance);
    EXPECT_NEAR(stress(HomogeneousMode::planar, s), 2 * kC * (s - std::pow(s, -3)), tolerance);
    EXPECT_NEAR(stress(HomogeneousMode::biaxial, s, 1.7),
                2 * kC * (s - std::pow(s, -3) * std::pow(1.7, -2)), tolerance);
  }
}

TEST(Homogeneous, StVKPulledBetweenFreeSidesHasYoungsModulusAndPoissonsRatio) {
  // In Green strains StVK is linear: along 1 the second Piola-Kirchhoff stress is Young's modulus
  // times the strain, across the strain is -nu times it.
  constexpr double kLambda = 3e6, kMu = 1e6;
  constexpr double kYoung = kMu * (3 * kLambda + 2 * kMu) / (kLambda + kMu);
  constexpr double kPoisson = kLambda / (2 * (kLambda + kMu));
  const auto law = solid_density(stvk_solid(kLambda, kMu)).law;
  for (const double s : {0.8, 1.05, 1.3}) {
    const double green = (s * s - 1) / 2;
    const auto at =
        homogeneous_stresses(*law, {{HomogeneousMode::uniaxial, s, 1}}, {0}, false, false);
    ASSERT_TRUE(at.has_value());
    EXPECT_NEAR(at->front().value, s * kYoung * green, 1e-9 * kYoung);
    const double across = std::sqrt(1 - 2 * kPoisson * green);
    EXPECT_NEAR(at->front().stretches(1), across, 1e-10);
    EXPECT_NEAR(at->front().stretches(2), across, 1e-10);
  }
}

/// Loads and unloads a solid with friction and a fibre, so that no two axes are alike.
Material solid_with_friction() {
  Material material = solid_of({{"I1-bar", component_of({test::linear(0.4)})},
                                {"I2-bar", component_of({test::linear(0.1)})},
                                {"fibre.y", component_of(ScalarCurve::constant(0.7))},
                                {"green.xx", component_of(ScalarCurve::constant(0.2))},
                                {"J", component_of(ScalarCurve::constant(6))}});
  material.components["green.xx"].friction = ComponentFriction{{0.2, 0.1, 0.3}, {}};
  material.components["green.yy"] = component_of(ScalarCurve::constant(0.1));
  material.components["green.yy"].friction = ComponentFriction{{0.1, 0.05, 0.2}, {}};
  return material;
}

TEST(Homogeneous, DerivativesAlongAPathWithFrictionAreThoseOfFiniteDifferences) {
  const auto law = solid_density(solid_with_friction()).law;
  for (const bool incompressible : {true, false}) {
    for (const HomogeneousMode mode : {HomogeneousMode::uniaxial, HomogeneousMode::equibiaxial,
                                       HomogeneousMode::planar, HomogeneousMode::biaxial}) {
      const std::vector<HomogeneousRow> rows{{mode, 1.2, 1.1},
                                             {mode, 1.6, 1.3},
                                             {mode, 1.5, 1.2},
                                             {mode, 1.1, 1.05},
                                             {mode, 1.4, 1.1}};
      const VectorFunction value = [&](const Eigen::VectorXd& numbers) {
        const auto at =
            homogeneous_stresses(*law->with_parameters(numbers), rows, {0}, incompressible, false);
        Eigen::VectorXd stress(std::ssize(rows));
        for (Eigen::Index i = 0; i < stress.size(); ++i) {
          stress(i) = at.value()[static_cast<std::size_t>(i)].value;
        }
        return stress;
      };
      const Eigen::VectorXd numbers = law->parameters();
      const auto at = homogeneous_stresses(*law, rows, {0}, incompressible, true);
      Eigen::MatrixXd stated(std::ssize(rows), numbers.size());
      for (Eigen::Index i = 0; i < stated.rows(); ++i) {
        stated.row(i) = at.value()[static_cast<std::size_t>(i)].by;
      }
      const DerivativeCheck check =
          check_derivatives(value, stated, numbers, numbers.cwiseAbs() / 2);
      // Differences are good to 1e-10 or so, equilibria to 1e-13; a wrong term shows at 1e-3.
      EXPECT_LT(check.error, 1e-8) << name_of(mode) << ": " << check.describe();
    }
  }
}

TEST(Homogeneous, FrictionMakesALoopAndElasticityNone) {
  std::vector<HomogeneousRow> rows;
  for (int i = 0; i <= 40; ++i) {
    rows.push_back({HomogeneousMode::uniaxial, 1 + 0.5 * (i <= 20 ? i : 40 - i) / 20, 1});
  }
  const auto loss = [&](const Material& material) {
    const std::vector<double> stress = stresses(material, rows);
    double work = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      work += (stress[i] + stress[i - 1]) / 2 * (rows[i].stretch - rows[i - 1].stretch);
    }
    return work;
  };
  Material material = solid_of({{"I1-bar", component_of({test::linear(0.4)})}});
  EXPECT_NEAR(loss(material), 0, 1e-14);
  material.components["green.xx"] = component_of(ScalarCurve::constant(0));
  material.components["green.xx"].friction = ComponentFriction{{0.05, 0, 0.05}, {}};
  EXPECT_GT(loss(material), 0.01);
}

}  // namespace
}  // namespace pliant
