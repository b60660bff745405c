// Materials fitted to full-field sessions that were made with known ones.

#include <string>

#include <gtest/gtest.h>

#include "pliant/estimation/study_fit.h"
#include "pliant/experiment/study.h"

#include "support/five_sheet_tests.h"

namespace pliant {
namespace {

using FiveTests = test::FiveSheetTests;

double value_of(const StudyResult& result, const std::string& component, double strain) {
  return result.material.components.at(component).stiffness->value(strain);
}

RunContext two_threads() {
  RunContext context;
  context.threads = 2;
  return context;
}

TEST(SheetRecovery, FindsTheStiffnessesOfNoiseFreeSessionsOnTheirOwnMesh) {
  const Material truth = test::sheet_cloth(false);
  const FiveTests tests(truth, ", variant: linear-orthotropic");
  const StudyResult result = fit_study(tests.study(), {}, two_threads());
  EXPECT_TRUE(result.converged);
  ASSERT_EQ(result.parameters.size(), 6u);
  for (const ParameterEstimate& p : result.parameters) {
    const double expected = truth.components.at(p.owner).stiffness->value(0);
    EXPECT_NEAR(p.value, expected, 1e-3 * expected) << p.name;
    EXPECT_TRUE(p.identified) << p.name;
    EXPECT_EQ(result.material.components.at(p.owner).status, ComponentStatus::measured);
  }
  for (const ExperimentResult& e : result.experiments) {
    EXPECT_LT(e.rms, e.quantity.kind == "force" ? 1e-3 : 1e-5) << e.name;
  }
}

TEST(SheetRecovery, FindsCurvesThatRiseWithStrain) {
  const Material truth = test::sheet_cloth(true);
  const FiveTests tests(truth);
  const StudyResult result = fit_study(tests.study(), {}, two_threads());
  for (const auto& [name, component] : truth.components) {
    const auto range = result.material.components.at(name).range;
    ASSERT_TRUE(range.has_value()) << name;
    // Few elements strain as far as the last control points, where the curves of stretch, shear and
    // bending lean on each other.
    for (const double share : {0.25, 0.5, 0.75}) {
      const double strain = share * range->second;
      const double expected = component.stiffness->value(strain);
      EXPECT_NEAR(value_of(result, name, strain), expected, 0.05 * expected) << name << strain;
    }
  }
}

TEST(SheetRecovery, TakesWarpToBendLikeWeftWhereWeftAloneIsMeasured) {
  const FiveTests tests(test::sheet_cloth(true), "", 9, 4);
  Study study = tests.study();
  std::erase_if(study.experiments, [](const ExperimentSpec& e) { return e.name != "bend-weft"; });
  const StudyResult result = fit_study(study, {}, two_threads());
  const auto& components = result.material.components;
  EXPECT_EQ(components.at("bend.warp").status, ComponentStatus::assumed);
  // It goes along while weft is fitted alone; weft and diagonal together follow.
  const double weft = value_of(result, "bend.weft", 0), warp = value_of(result, "bend.warp", 0);
  EXPECT_NEAR(warp, weft, 0.05 * weft);
  EXPECT_LT(result.experiments.front().rms, 1e-4);
}

}  // namespace
}  // namespace pliant
