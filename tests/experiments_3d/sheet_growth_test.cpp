// How far curves of sheets grow, and what is kept where a stage fails.

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/estimation/sheet/sheet_fit.h"
#include "pliant/estimation/sheet/stage_search.h"
#include "pliant/estimation/statistics/model_growth.h"
#include "pliant/study/sheet_predictions.h"

#include "support/virtual_sheets.h"

namespace pliant {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const Session& stretch() {
  static const Session session = test::virtual_stretch(test::sheet_cloth(true), 0, 9, 8);
  return session;
}

SheetTest stating(SheetNoise noise) {
  Session session = stretch();
  session.noise = noise;
  return {"stretch", std::move(session), SheetObjective::clip_forces};
}

SheetFit fit_of(const std::vector<const SheetTest*>& tests) {
  const Study study;
  return fit_sheets(study, sheet_plan(study, tests), {});
}

int points_of(const SheetFit& fit, const char* component) {
  return fit.material.components.at(component).stiffness->size();
}

TEST(SheetGrowth, IsAsAccurateAsWhatIsMeasuredOrStated) {
  const SheetTest silent = stating({}), fine = stating({1e-4, 2e-3}), coarse = stating({1e-3, 0.1});
  const auto accuracy = [](const std::vector<const SheetTest*>& tests) {
    return accuracy_of({{{"stretch.weft"}}, tests});
  };
  EXPECT_DOUBLE_EQ(accuracy({&silent}), 1e-4 * silent.reference());
  EXPECT_EQ(accuracy({&coarse}), 0.1);
  EXPECT_EQ(accuracy({&silent, &coarse, &fine}), 2e-3);
  const SheetTest shape("shape", fine.session(), SheetObjective::positions);
  EXPECT_EQ(accuracy({&shape, &fine}), 1e-4);
  Session weak = stretch();
  for (SessionFrame& frame : weak.frames) {
    for (auto& cords : frame.cords) cords.front().force *= 1e-3;
  }
  const SheetTest faint("stretch", weak, SheetObjective::clip_forces);
  EXPECT_NEAR(accuracy({&faint}), 1e-3 * accuracy({&silent}), 1e-12);
}

TEST(SheetGrowth, EndsAtTheNoiseThatASessionStates) {
  const SheetTest silent = stating({}), rough = stating({{}, 0.5});
  const SheetFit grown = fit_of({&silent}), ended = fit_of({&rough});
  EXPECT_GT(points_of(grown, "stretch.weft"), 1);
  EXPECT_EQ(points_of(ended, "stretch.weft"), 1);
  EXPECT_EQ(ended.stages.back().ended, name_of(GrowthEnd::accurate));
}

// A fit that leaves more than the noise says so.
TEST(SheetGrowth, IsComparedWithTheStatedNoise) {
  const auto warnings = [](double noise) {
    StudyResult result;
    const std::vector<SheetExperiment> experiments{
        {stating({{}, noise}), ExperimentRole::fit, "", "", {}}};
    ExperimentResult prediction;
    prediction.role = ExperimentRole::fit;
    prediction.rms = 0.05;
    warn_of_misfit(experiments, {prediction}, result);
    return result.warnings;
  };
  EXPECT_THAT(warnings(0.02), ElementsAre());
  EXPECT_THAT(warnings(0.005), ElementsAre(HasSubstr("misses 5.8 times the noise")));
}

TEST(SheetGrowth, KeepsWhatWasFoundWhereAStageHasNoEquilibria) {
  const SheetTest pulled = stating({});
  Session lost = test::virtual_shear(test::sheet_cloth(true), 9, 6);
  for (SessionFrame& frame : lost.frames) {
    for (Pose& pose : frame.poses) {
      pose.translation.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }
  const SheetTest sheared("sheared", std::move(lost), SheetObjective::parallel_clip_forces);
  const SheetFit fit = fit_of({&pulled, &sheared});
  EXPECT_THAT(fit.groups, ElementsAre(ComponentGroup{"stretch.weft"}));
  EXPECT_FALSE(fit.converged);
  EXPECT_THAT(fit.warnings, ElementsAre(HasSubstr("shear is not fitted to sheared: ")));
  EXPECT_NEAR(fit.material.components.at("stretch.weft").stiffness->value(0), 80, 2);
}

}  // namespace
}  // namespace pliant
