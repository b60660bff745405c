#include "pliant/experiment/bending/pure_bending.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/math/check_derivatives.h"

#include "support/published_bending.h"
#include "support/study_folder.h"

namespace pliant {
namespace {

using test::StudyFolder;
using ::testing::ElementsAre;

std::string entry(const std::string& more = "") {
  return "{name: kes, type: pure-bending, direction: warp, data: b.csv" + more + "}";
}

/// 0, +250, -250, 0 1/m in steps of 50, with moments that matter to no prediction.
const std::vector<double> kCurvatures{0,   50,   100,  150,  200,  250,  200,  150,  100, 50, 0,
                                      -50, -100, -150, -200, -250, -200, -150, -100, -50, 0};

std::string csv() {
  std::string text = "curvature_1_per_m,moment_N\n";
  for (const double curvature : kCurvatures) {
    text += fmt::format("{},{}\n", curvature, curvature * 1e-5);
  }
  return text;
}

ComponentLaw doublecloth() { return test::published_bending()[1].law(); }

// Moments along the curvatures for a given friction at the first row.
std::vector<double> moments(const ComponentLaw& law, double initial_friction) {
  std::vector<double> result;
  FrictionState state{0, initial_friction};
  for (const double curvature : kCurvatures) {
    const double strain = 3 * curvature;
    state = {strain, law.friction_stress(strain, state).stress};
    result.push_back(law.elastic_stress(strain) + state.stress);
  }
  return result;
}

TEST(PureBending, ReadsTheDocumentedColumns) {
  const StudyFolder folder;
  folder.write("b.csv", csv());
  const auto experiment = folder.experiment(entry());
  EXPECT_EQ(experiment->rows(), 21);
  EXPECT_EQ(experiment->info().component, "bend.warp");
  EXPECT_EQ(experiment->info().quantity.name, "moment_N");
  EXPECT_DOUBLE_EQ(experiment->measured()(5), 250e-5);
  EXPECT_EQ(experiment->path().strain[5], 750);
  EXPECT_EQ(experiment->path().factor[5], 1);
}

TEST(PureBending, OfTheBiasDeterminesDiagonalBending) {
  const StudyFolder folder;
  folder.write("b.csv", csv());
  const auto experiment =
      folder.experiment("{name: kes, type: pure-bending, direction: bias, data: b.csv}");
  EXPECT_EQ(experiment->info().component, "bend.diagonal");
}

TEST(PureBending, TakesTheUnitsOfTheInstrument) {
  for (const char* header :
       {"curvature_1_per_cm,moment_gf_cm_per_cm", "curvature (1/cm),moment (gf cm/cm)",
        "curvature [cm^-1],moment [gf.cm/cm]", "curvature (1/cm),moment (gf·cm/cm)"}) {
    const StudyFolder folder;
    folder.write("b.csv", std::string(header) + "\n0,0\n2.5,0.3\n0,-0.1\n");
    const auto experiment = folder.experiment(entry());
    EXPECT_NEAR(experiment->path().strain[1], 750, 1e-12) << header;
    EXPECT_NEAR(experiment->measured()(1), 0.3 * 9.80665e-3, 1e-17) << header;
  }
}

TEST(PureBending, TakesTheNamesOfTheInstrument) {
  const StudyFolder folder;
  folder.write("b.csv", "K [1/cm];M [gf.cm/cm]\n0;0\n2,5;0,3\n0;-0,1\n");
  const auto experiment = folder.experiment(
      "{name: kes, type: pure-bending, direction: warp, data: {file: b.csv, columns: {curvature: "
      "\"K [1/cm]\", moment: \"M [gf.cm/cm]\"}}}");
  EXPECT_NEAR(experiment->measured()(1), 0.3 * 9.80665e-3, 1e-17);
}

TEST(PureBending, PredictsTheStressOfThreeTimesTheCurvaturePlusOffset) {
  const StudyFolder folder;
  folder.write("b.csv", csv());
  const auto experiment = folder.experiment(entry(", initial_friction: rest"));
  ASSERT_EQ(experiment->nuisance().size(), 1U);
  EXPECT_EQ(experiment->nuisance()[0].name, "kes.moment_offset");
  const auto prediction =
      experiment->predict(doublecloth(), Eigen::VectorXd::Constant(1, 1e-4), false);
  ASSERT_TRUE(prediction);
  const std::vector<double> expected = moments(doublecloth(), 0);
  for (size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(prediction->value(static_cast<Eigen::Index>(i)), expected[i] + 1e-4, 1e-16);
  }
}

TEST(PureBending, DerivativesAreThoseOfDifferences) {
  const StudyFolder folder;
  folder.write("b.csv", csv());
  const auto experiment = folder.experiment(entry());
  ASSERT_EQ(experiment->nuisance().size(), 2U);
  const ComponentLaw law = doublecloth();
  Eigen::VectorXd at(7);
  at << law.parameters(), 1e-4, -0.4;
  Eigen::VectorXd scale = law.parameters().cwiseAbs();
  scale.conservativeResize(7);
  scale.tail(2) << 1e-3, 0.5;
  const VectorFunction predicted = [&](const Eigen::VectorXd& x) {
    return experiment->predict(law.with_parameters(x), x.tail(2), false)->value;
  };
  const auto prediction = experiment->predict(law, at.tail(2), true);
  ASSERT_TRUE(prediction);
  const DerivativeCheck check = check_derivatives(predicted, prediction->jacobian, at, scale);
  EXPECT_LT(check.error, 1e-8) << check.describe();  // accuracy of the differences
}

TEST(PureBending, ItsLoopIsOverCurvature) {
  const StudyFolder folder;
  folder.write("b.csv", csv());
  const auto experiment = folder.experiment(entry());
  const LoopSeries loop = *experiment->loop(experiment->measured());
  EXPECT_DOUBLE_EQ(loop.abscissa(5), 250);
  EXPECT_EQ(loop.ordinate, experiment->measured());
}

TEST(PureBending, ReversalsBetweenSamplesAreFoundInTheCurvature) {
  const StudyFolder folder;
  folder.write("b.csv", csv());
  EXPECT_THAT(folder.experiment(entry())->path().direction,
              ElementsAre(1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 1, 1, 1, 1, 1));
}

}  // namespace
}  // namespace pliant
