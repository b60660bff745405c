#include "pliant/experiment/contraction/lateral_contraction.h"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/math/check_derivatives.h"

#include "io/input_error_of.h"
#include "support/random_laws.h"
#include "support/study_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::random_law;
using test::StudyFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string entry(const std::string& more = "") {
  return "{name: widths, type: lateral-contraction, direction: warp, data: w.csv, length: 40 mm, "
         "width: 30 mm" +
         more + "}";
}

constexpr const char* kTable =
    "length_mm,width_mm\n40,30\n42,29.6\n44,29\n46,28.2\n44,28.8\n42,29.5\n40,29.9\n";

TEST(LateralContraction, ReadsWidthsAsHowMuchLessTheyAre) {
  const StudyFolder folder;
  folder.write("w.csv", kTable);
  const auto experiment = folder.experiment(entry());
  EXPECT_EQ(experiment->info().component, "contraction.warp");
  EXPECT_NEAR(experiment->measured()(3), 1.8e-3, 1e-15);
  EXPECT_NEAR(experiment->path().strain[3], (std::pow(46.0 / 40, 2) - 1) / 2, 1e-15);
  EXPECT_THAT(experiment->path().direction, ElementsAre(1, 1, 1, 1, -1, -1, -1));
  ASSERT_EQ(experiment->nuisance().size(), 2U);
  EXPECT_EQ(experiment->nuisance()[0].name, "widths.width_change");
  EXPECT_EQ(experiment->nuisance()[0].unit, "m");
  EXPECT_THAT(experiment->info().questions, IsEmpty());
}

TEST(LateralContraction, TakesExtensionsAndStrains) {
  const StudyFolder folder;
  folder.write("w.csv", "extension_mm,width_mm\n0,30\n2,29.6\n4,29\n");
  const double strain = folder.experiment(entry())->path().strain[2];
  EXPECT_NEAR(strain, (std::pow(44.0 / 40, 2) - 1) / 2, 1e-15);
  folder.write("w.csv", "strain_percent,width_mm\n0,30\n5,29.6\n10,29\n");
  EXPECT_NEAR(folder.experiment(entry())->path().strain[2], strain, 1e-15);
}

TEST(LateralContraction, TakesStrainsAcross) {
  const StudyFolder folder;
  for (const char* header :
       {"strain_percent,lateral_strain_percent", "Tensile strain (%),Transverse strain (%)"}) {
    folder.write("w.csv", std::string(header) + "\n0,0\n5,-1\n10,-3\n");
    EXPECT_NEAR(folder.experiment(entry())->measured()(2), 0.03 * 0.03, 1e-15) << header;
  }
}

TEST(LateralContraction, IsTheLawsShareOfTheWidth) {
  const StudyFolder folder;
  folder.write("w.csv", kTable);
  const auto experiment = folder.experiment(entry(", initial_friction: rest"));
  ComponentLaw law;
  law.stiffness = ScalarCurve::affine(0.3, 0.5);
  const auto prediction = experiment->predict(law, Eigen::VectorXd::Constant(1, 1e-4), false);
  ASSERT_TRUE(prediction);
  const double strain = experiment->path().strain[3];
  EXPECT_NEAR(prediction->value(3), 0.03 * (0.3 + 0.5 * strain) * strain + 1e-4, 1e-15);
}

TEST(LateralContraction, DerivativesAreThoseOfDifferences) {
  const StudyFolder folder;
  folder.write("w.csv", kTable);
  const auto experiment = folder.experiment(entry());
  RandomStream random(4);
  const ComponentLaw law = random_law(random, CurveKind::affine);
  const int count = law.parameter_count();
  Eigen::VectorXd at(count + 2), scale(count + 2);
  at << law.parameters(), 1e-4, -0.3;
  scale << test::parameter_scales(law), 1e-3, 0.1;
  const auto prediction = experiment->predict(law, at.tail(2), true);
  ASSERT_TRUE(prediction);
  const VectorFunction widths = [&](const Eigen::VectorXd& x) {
    return experiment->predict(law.with_parameters(x), x.tail(2), false)->value;
  };
  const DerivativeCheck check = check_derivatives(widths, prediction->jacobian, at, scale);
  EXPECT_LT(check.error, 1e-8) << check.describe();  // accuracy of the differences
}

TEST(LateralContraction, RefusesWidthsWithoutLengths) {
  const StudyFolder folder;
  const auto refusal = [&](const char* table) {
    folder.write("w.csv", table);
    return input_error_of([&] { folder.experiment(entry()); });
  };
  const InputError missing = refusal("width_mm,force_N\n30,0\n29,1\n28,2\n");
  EXPECT_EQ(missing.where().field, "length");
  EXPECT_EQ(refusal("length_mm,force_N\n40,0\n41,1\n42,2\n").where().field, "width");
  EXPECT_THAT(refusal("length_mm,width_mm\n40,30\n41,30\n42,30\n").where().field, "width");
  EXPECT_THAT(refusal("length_mm,width_mm\n40,30\n41,-1\n42,28\n").problem(),
              HasSubstr("is not positive"));
}

TEST(LateralContraction, AsksWhetherMarksAndSizesBelongTogether) {
  const StudyFolder folder;
  const auto question = [&](const char* table) {
    folder.write("w.csv", table);
    const auto questions = folder.experiment(entry())->info().questions;
    return questions.empty() ? std::string() : questions.front();
  };
  EXPECT_THAT(question("length_mm,width_mm\n40,15\n42,14.8\n44,14.5\n"),
              HasSubstr("50 % of the stated `width`"));
  EXPECT_THAT(question("length_mm,width_mm\n100,30\n102,29\n104,28\n"),
              HasSubstr("250 % of the stated `length`"));
  EXPECT_THAT(question("length_mm,width_mm\n40,30\n42,31\n44,32\n"),
              HasSubstr("wider where it is longer"));
}

}  // namespace
}  // namespace pliant
