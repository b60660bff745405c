#include "pliant/experiment/shear/shear_cycles.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/math/check_derivatives.h"

#include "support/random_laws.h"
#include "support/study_folder.h"

namespace pliant {
namespace {

using test::parameter_scales;
using test::random_law;
using test::StudyFolder;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180;

std::string entry(const std::string& more = "") {
  return "{name: shear, type: shear-cycles, data: s.csv" + more + "}";
}

/// 0, +8, -8, 0 degrees in steps of two, with forces that matter to no prediction.
const std::vector<double> kAngles{0, 2, 4, 6, 8, 6, 4, 2, 0, -2, -4, -6, -8, -6, -4, -2, 0};

std::string csv() {
  std::string text = "angle_deg,force_N_per_m\n";
  for (const double angle : kAngles) text += fmt::format("{},{}\n", angle, angle / 4);
  return text;
}

ComponentLaw even_law() {
  ComponentLaw law;
  law.stiffness = ScalarCurve::hermite({0, 0.05, 0.2}, {30, 40, 45}, true);
  law.friction_law = FrictionLaw::dahl;
  law.friction = {0.8, 1.5, 0.02};
  return law;
}

// Stress along the angles for a given friction at the first row.
std::vector<double> stresses(const ComponentLaw& law, double initial_friction) {
  std::vector<double> stress;
  FrictionState state{0, initial_friction};
  for (const double angle : kAngles) {
    const double strain = std::sin(angle * kDegree);
    state = {strain, law.friction_stress(strain, state).stress};
    stress.push_back(law.elastic_stress(strain) + state.stress);
  }
  return stress;
}

TEST(ShearCycles, ReadsTheDocumentedColumns) {
  const StudyFolder folder;
  folder.write("s.csv", csv());
  const auto experiment = folder.experiment(entry());
  EXPECT_EQ(experiment->rows(), 17);
  EXPECT_EQ(experiment->info().component, "shear");
  EXPECT_EQ(experiment->info().quantity.name, "force_N_per_m");
  EXPECT_EQ(experiment->measured()(4), 2);
  EXPECT_NEAR(experiment->path().strain[4], std::sin(8 * kDegree), 1e-16);
  EXPECT_THAT(experiment->path().direction,
              ElementsAre(1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, -1, 1, 1, 1, 1));
}

TEST(ShearCycles, TakesTheUnitsOfTheInstrument) {
  const StudyFolder folder;
  folder.write("s.csv", "angle_rad;force_gf_per_cm\n0;0\n0,1;2,5\n0;-1\n");
  const auto experiment = folder.experiment(entry());
  EXPECT_NEAR(experiment->path().strain[1], std::sin(0.1), 1e-16);
  EXPECT_NEAR(experiment->measured()(1), 2.5 * 0.00980665 / 0.01, 1e-13);
}

TEST(ShearCycles, PredictsStressPlusTransverseTensionPlusOffset) {
  const StudyFolder folder;
  folder.write("s.csv", csv());
  const auto experiment =
      folder.experiment(entry(", transverse_tension: 9.8 N/m, initial_friction: rest"));
  const ComponentLaw law = even_law();
  ASSERT_EQ(experiment->nuisance().size(), 1U);
  EXPECT_EQ(experiment->nuisance()[0].name, "shear.force_offset");
  const auto prediction = experiment->predict(law, Eigen::VectorXd::Constant(1, 0.25), false);
  ASSERT_TRUE(prediction);
  const std::vector<double> stress = stresses(law, 0);
  for (size_t i = 0; i < kAngles.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    EXPECT_NEAR(prediction->value(row), stress[i] + 9.8 * std::tan(kAngles[i] * kDegree) + 0.25,
                1e-13);  // rounding
    EXPECT_NEAR(prediction->strain(row), std::sin(kAngles[i] * kDegree), 1e-16);
  }
  EXPECT_NEAR(experiment->path().force[4], 2 - 9.8 * std::tan(8 * kDegree), 1e-13);
}

TEST(ShearCycles, TheFrictionAtTheFirstRowIsUnknownUnlessStated) {
  const StudyFolder folder;
  folder.write("s.csv", csv());
  const auto experiment = folder.experiment(entry());
  ASSERT_EQ(experiment->nuisance().size(), 2U);
  EXPECT_EQ(experiment->nuisance()[1].name, "shear.initial_friction");
  const ComponentLaw law = even_law();
  const auto prediction = experiment->predict(law, Eigen::Vector2d(0, -0.5), false);
  const std::vector<double> stress = stresses(law, -0.4);
  for (size_t i = 0; i < kAngles.size(); ++i) {
    EXPECT_NEAR(prediction->value(static_cast<Eigen::Index>(i)), stress[i], 1e-13);
  }
}

TEST(ShearCycles, DerivativesAreThoseOfDifferences) {
  const StudyFolder folder;
  std::string text = "specimen,angle_deg,force_N_per_m\n";
  for (const char* specimen : {"A", "B"}) {
    for (const double angle : kAngles) {
      text += fmt::format("{},{},{}\n", specimen, angle + 0.3, angle / 4);
    }
  }
  folder.write("s.csv", text);
  const auto experiment = folder.experiment(entry(", transverse_tension: 9.8 N/m"));
  ASSERT_EQ(experiment->nuisance().size(), 4U);
  for (const FrictionLaw friction :
       {FrictionLaw::none, FrictionLaw::dahl, FrictionLaw::constant_slope}) {
    RandomStream random(61);
    const ComponentLaw law = random_law(random, CurveKind::affine, friction);
    const int count = law.parameter_count();
    Eigen::VectorXd at(count + 4), scale(count + 4);
    at << law.parameters(), 0.1, -0.4, -0.2, 0.6;
    scale << parameter_scales(law), 0.1, 0.1, 0.1, 0.1;
    const auto prediction = experiment->predict(law, at.tail(4), true);
    ASSERT_TRUE(prediction);
    const VectorFunction forces = [&](const Eigen::VectorXd& x) {
      return experiment->predict(law.with_parameters(x), x.tail(4), false)->value;
    };
    const DerivativeCheck check = check_derivatives(forces, prediction->jacobian, at, scale);
    EXPECT_LT(check.error, 1e-8) << check.describe();  // accuracy of the differences
  }
}

TEST(ShearCycles, SaysWhatWasAssumedOfTheInstrument) {
  const StudyFolder folder;
  folder.write("s.csv", csv());
  EXPECT_THAT(folder.experiment(entry())->info().handled,
              Contains(HasSubstr("no transverse tension is stated")));
  EXPECT_THAT(folder.experiment(entry(", transverse_tension: 9.8 N/m"))->info().handled,
              Contains(HasSubstr("9.8 N/m")));
}

}  // namespace
}  // namespace pliant
