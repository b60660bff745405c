#include "pliant/estimation/sheet/sheet_plan.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/input_error_of.h"
#include "support/session_sheets.h"

namespace pliant {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::SizeIs;

/// Of the thesis ([T] 3.4.2), with no eye to the order in which they are fitted.
const std::vector<std::string> kFiveTests = {"bend-warp", "shear", "stretch-warp", "bend-weft",
                                             "stretch-weft"};

/// Sessions of some tests, whose clips only go on, or return as well.
class Tests {
 public:
  explicit Tests(const std::vector<std::string>& names, bool return_to_rest = false) {
    for (const std::string& name : names) {
      const bool bends = name.starts_with("bend");
      Session session = bends ? test::bend_session() : test::stretch_session();
      session.test = name;
      if (return_to_rest && !bends) session.frames.push_back(session.frames.front());
      tests_.emplace_back(name, std::move(session),
                          bends ? SheetObjective::positions : SheetObjective::clip_forces);
    }
  }

  /// Its stages point to these tests.
  std::vector<SheetStage> plan(const FitSettings& study = {}) const {
    std::vector<const SheetTest*> tests;
    for (const SheetTest& test : tests_) tests.push_back(&test);
    return sheet_plan(study, tests);
  }

 private:
  std::vector<SheetTest> tests_;
};

/// `bend.weft: bend-weft`, what is fitted to which tests.
std::vector<std::string> in_words(const std::vector<SheetStage>& plan) {
  std::vector<std::string> words;
  for (const SheetStage& stage : plan) {
    std::vector<std::string> groups, tests;
    for (const ComponentGroup& group : stage.groups) {
      groups.push_back(fmt::format("{}", fmt::join(group, "=")));
    }
    for (const SheetTest* test : stage.tests) tests.push_back(test->name());
    words.push_back(fmt::format("{}: {}", fmt::join(groups, " "), fmt::join(tests, " ")));
  }
  return words;
}

std::vector<StageKind> kinds_of(const std::vector<SheetStage>& plan) {
  std::vector<StageKind> kinds;
  for (const SheetStage& stage : plan) kinds.push_back(stage.kind);
  return kinds;
}

const std::string kAllBending = "bend.weft bend.warp bend.diagonal: bend-warp bend-weft";

TEST(SheetPlan, GoesFromStretchOverShearToBendingWithItsDiagonalLast) {
  EXPECT_THAT(in_words(Tests(kFiveTests).plan()),
              ElementsAre("stretch.weft: stretch-weft", "stretch.warp: stretch-warp",
                          "shear: shear", "bend.weft: bend-weft", "bend.warp: bend-warp",
                          "bend.diagonal: bend-warp bend-weft", kAllBending,
                          // Then their curves grow, and all that influences each other twice more.
                          "bend.weft: bend-weft", "bend.warp: bend-warp",
                          "bend.diagonal: bend-warp bend-weft", kAllBending, "shear: shear",
                          kAllBending, "shear: shear"));
}

TEST(SheetPlan, LetsCurvesOfBendingGrowOnlyFromConstantsOfAllDirections) {
  using enum StageKind;
  EXPECT_THAT(kinds_of(Tests(kFiveTests).plan()),
              ElementsAre(grow, grow, grow, constant, constant, constant, again, grow, grow, grow,
                          again, again, again, again));
}

TEST(SheetPlan, EndsWithFrictionOfWhatClipsPullThereAndBack) {
  const Tests there(kFiveTests), and_back(kFiveTests, /*return_to_rest=*/true);
  const std::vector<SheetStage> without = there.plan(), with = and_back.plan();
  ASSERT_THAT(with, SizeIs(without.size() + 3));
  const auto friction = with.end() - 3;
  EXPECT_THAT(in_words({with.begin(), friction}), ElementsAreArray(in_words(without)));
  EXPECT_THAT(
      in_words({friction, with.end()}),
      ElementsAre("stretch.weft: stretch-weft", "stretch.warp: stretch-warp", "shear: shear"));
  EXPECT_THAT(kinds_of({friction, with.end()}), Each(StageKind::friction));
}

TEST(SheetPlan, HasNoFrictionWhereTheStudySaysSo) {
  FitSettings study;
  study.model.friction = FrictionChoice::none;
  EXPECT_THAT(in_words(Tests(kFiveTests, /*return_to_rest=*/true).plan(study)),
              ElementsAreArray(in_words(Tests(kFiveTests).plan())));
}

TEST(SheetPlan, FitsOneCurveToWeftAndWarpOfAnIsotropicMaterial) {
  FitSettings study;
  study.model.isotropic = true;
  std::vector<std::string> first = in_words(Tests(kFiveTests).plan(study));
  first.resize(4);
  EXPECT_THAT(first, ElementsAre("stretch.weft=stretch.warp: stretch-warp stretch-weft",
                                 "shear: shear", "bend.weft=bend.warp: bend-warp bend-weft",
                                 "bend.diagonal: bend-warp bend-weft"));
}

TEST(SheetPlan, TakesABiasExtensionForShearWhereThereIsNone) {
  EXPECT_THAT(in_words(Tests({"bias-extension", "stretch-warp"}).plan()),
              ElementsAre("stretch.warp: stretch-warp", "shear: bias-extension"));
  EXPECT_THAT(in_words(Tests({"bias-extension", "shear"}).plan()), ElementsAre("shear: shear"));
}

/// Settings whose plan has one stage.
FitSettings planned(std::vector<std::string> components, std::vector<std::string> experiments) {
  FitSettings study;
  study.fit.plan.push_back(
      {std::move(components), std::move(experiments), {"study.yaml", 7, "fit.plan[0]"}});
  return study;
}

TEST(SheetPlan, IsThatOfTheStudyWhereItStatesOne) {
  FitSettings study = planned({"stretch.weft"}, {"stretch-*"});
  study.fit.plan.push_back({{"shear", "stretch.weft"}, {"shear", "stretch-warp"}, {}});
  const std::vector<SheetStage> plan = Tests(kFiveTests).plan(study);
  EXPECT_THAT(in_words(plan), ElementsAre("stretch.weft: stretch-warp stretch-weft",
                                          "shear stretch.weft: shear stretch-warp"));
  EXPECT_THAT(kinds_of(plan), ElementsAre(StageKind::grow, StageKind::again));
}

TEST(SheetPlan, RefusesAStageThatNamesAWrongTestBesideARightOne) {
  const InputError error = test::input_error_of([] {
    Tests(kFiveTests).plan(planned({"stretch.weft"}, {"stretch-weft", "strech-warp"}));
  });
  EXPECT_EQ(error.where().line, 7);
  EXPECT_EQ(error.where().field, "fit.plan[0]");
  EXPECT_EQ(error.problem(), "\"strech-warp\" matches no session that is fitted");
}

TEST(SheetPlan, RefusesAStageWithATermThatTheModelLacks) {
  FitSettings study = planned({"stretch.weft", "stretch.weft*shear"}, {"stretch-weft"});
  const Tests tests(kFiveTests);
  const InputError error = test::input_error_of([&] { tests.plan(study); });
  EXPECT_EQ(error.where().field, "fit.plan[0]");
  EXPECT_EQ(error.problem(), "\"stretch.weft*shear\" is no component of the model");
  study.model.components["stretch.weft*shear"] = {};
  EXPECT_THAT(tests.plan(study), SizeIs(1));
}

}  // namespace
}  // namespace pliant
