// Numbers of the apparatus and the specimen that a fit estimates along.

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/study/study.h"
#include "pliant/study/study_evaluation.h"

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using test::estimate_named;
using test::lab_of;
using test::published_fabric;
using test::strip_cycles;
using test::truth_of;
using test::VirtualStudy;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr size_t kForce = 0;  // column of cycles.csv

VirtualStudy::Rows& from_row(VirtualStudy::Rows& rows, int first) {
  rows.erase(rows.begin(), rows.begin() + first);
  return rows;
}

void expect_law(const StudyResult& result, const Material& fabric, double tolerance) {
  for (const std::string& name : test::names_of(fabric, "stretch.warp")) {
    const double truth = truth_of(fabric, name);
    EXPECT_NEAR(estimate_named(result, name).value, truth, tolerance * truth) << name;
  }
}

// Without noise a nuisance parameter costs no accuracy: its own sensitivity is exact too.
constexpr double kRecovered = 1e-6;

TEST(ForceOffset, IsFoundAndKeptOutOfTheMaterial) {
  const Material fabric = published_fabric("polyester");
  VirtualStudy study(lab_of(fabric, strip_cycles({0.05, 0.1, 0.2})));
  study.set_model("stiffness: affine");
  study.edit_rows("cycles.csv", [](VirtualStudy::Rows& rows) {
    for (std::vector<double>& row : rows) row[kForce] += 0.03;
  });
  const StudyResult result = study.fit();
  EXPECT_NEAR(estimate_named(result, "cycles.force_offset").value, 0.03, 0.03 * kRecovered);
  expect_law(result, fabric, kRecovered);
}

TEST(InitialFriction, IsFoundWhereThePathBeginsInTheMiddleOfALoop) {
  const Material fabric = published_fabric("spandex");
  VirtualStudy study(lab_of(fabric, strip_cycles({0.1, 0.2, 0.3})));
  study.set_model("stiffness: affine");
  study.set_in_experiment("initial_friction", "unknown");
  // The first cycle's loading and the upper half of its unloading are lost: 100 rows reach 0.3.
  study.edit_rows("cycles.csv", [](VirtualStudy::Rows& rows) { from_row(rows, 50); });
  const StudyResult result = study.fit();
  // Half way down from 0.1, four tau away from the turn, friction pushes with almost all it has.
  const ParameterEstimate initial = estimate_named(result, "cycles.initial_friction");
  EXPECT_LT(initial.value, 0);
  EXPECT_TRUE(initial.identified);
  expect_law(result, fabric, kRecovered);
}

TEST(InitialFriction, BiasesTheMaterialWhereItIsTakenForRest) {
  const Material fabric = published_fabric("spandex");
  VirtualStudy study(lab_of(fabric, strip_cycles({0.1, 0.2, 0.3})));
  study.set_model("stiffness: affine");
  study.edit_rows("cycles.csv", [](VirtualStudy::Rows& rows) { from_row(rows, 50); });
  const StudyResult result = study.fit();
  const double truth = truth_of(fabric, "stretch.warp.friction.a");
  EXPECT_GT(std::abs(estimate_named(result, "stretch.warp.friction.a").value - truth),
            0.01 * truth);
}

TEST(RestLength, IsFoundWhereItIsUnknown) {
  const Material fabric = published_fabric("polyester");
  VirtualStudy study(lab_of(fabric, strip_cycles({0.05, 0.1, 0.2})));
  study.set_model("stiffness: affine");
  // The strip is 100 mm long; the study says 101 mm.
  study.set_in_experiment("length", "101 mm");
  study.add_to_experiment("rest_length: unknown");
  const StudyResult result = study.fit();
  EXPECT_NEAR(estimate_named(result, "cycles.rest_length_change").value, -1e-3, 1e-3 * kRecovered);
  expect_law(result, fabric, kRecovered);
}

TEST(RestLength, IsUnknownWhereAPretensionIsStated) {
  VirtualStudy study(lab_of(published_fabric("polyester"), strip_cycles({0.05, 0.1})));
  study.add_to_experiment("pretension: 0.05 N");
  const Study read = study.study();
  EXPECT_EQ(spec_of<TensileCyclesSpec>(read.experiments.front()).rest_length, RestLength::unknown);
  EXPECT_NEAR(estimate_named(study.fit(), "cycles.rest_length_change").value, 0, 0.1e-3);
}

TEST(InitialSlack, CarriesNoForceAndIsReported) {
  const Material fabric = published_fabric("polyester");
  auto experiment = strip_cycles({0.05, 0.1, 0.2});
  experiment.slack = 2e-3;
  VirtualStudy study(lab_of(fabric, experiment));
  study.set_model("stiffness: affine");
  const StudyResult result = study.fit();
  expect_law(result, fabric, kRecovered);
  EXPECT_THAT(result.experiments.front().handled, Contains(HasSubstr("the strip is slack there")));
}

// Else slack rows pile up on the vertical line of the strain at which the strip came to be slack.
TEST(SlackRows, AreShownAtTheStrainOfTheClamps) {
  const Material fabric = published_fabric("polyester");
  auto experiment = strip_cycles({0.05, 0.2});
  experiment.slack = 5e-3;
  VirtualStudy study(lab_of(fabric, experiment));
  const ExperimentResult result = evaluate_study(study.study(), fabric, {}).experiments.front();
  const Study ideal = study.study();
  EXPECT_EQ(result.strain, read_experiment(ideal.experiments.front(), ideal)->path().strain);
  EXPECT_LT(result.strain.front(), -0.01);
  EXPECT_GE(result.strain_range.first, 0) << "the material is never pushed";
}

TEST(InitialSlack, ShowsTheForceOffsetWithoutAnyFit) {
  const Material fabric = published_fabric("polyester");
  auto experiment = strip_cycles({0.1, 0.2});
  experiment.slack = 5e-3;
  VirtualStudy study(lab_of(fabric, experiment));
  study.edit_rows("cycles.csv", [](VirtualStudy::Rows& rows) {
    for (std::vector<double>& row : rows) row[kForce] -= 0.02;
  });
  const StudyResult result = evaluate_study(study.study(), fabric, {});
  // Nothing but the offset is amiss, and it is read off the slack rows.
  EXPECT_LT(result.experiments.front().rms, 1e-9);
}

TEST(ApparatusFriction, IsTakenOffWhereItIsStated) {
  const Material fabric = published_fabric("polyester");
  VirtualStudy study(lab_of(fabric, strip_cycles({0.05, 0.1, 0.2})));
  study.set_model("stiffness: affine");
  study.add_to_experiment("apparatus_friction: 0.1 N");
  const Study ideal = study.study();
  const auto experiment = read_experiment(ideal.experiments.front(), ideal);
  study.edit_rows("cycles.csv", [&](VirtualStudy::Rows& rows) {
    for (size_t i = 0; i < rows.size(); ++i) {
      rows[i][kForce] += 0.1 * experiment->path().direction[i];
    }
  });
  expect_law(study.fit(), fabric, kRecovered);
}

TEST(Preconditioning, CarriesTheStateOfCyclesThatAreNotFitted) {
  const Material fabric = published_fabric("polyester");
  VirtualStudy study(lab_of(fabric, strip_cycles({0.05, 0.1, 0.2})));
  study.set_model("stiffness: affine");
  study.add_to_experiment("precondition_cycles: 1");
  const StudyResult result = study.fit();
  EXPECT_GT(result.experiments.front().excluded, 0);
  expect_law(result, fabric, kRecovered);
}

}  // namespace
}  // namespace pliant
