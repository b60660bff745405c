// Fits of sheets know the addends of a material: laws that a page adds, and further branches of
// friction.

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/estimation/sheet/sheet_fit.h"
#include "pliant/experiment/session/virtual_session.h"
#include "pliant/material/addend/addend_registry.h"
#include "pliant/study/sheet_study.h"
#include "pliant/study/study_fit.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"
#include "support/added_stiffness.h"
#include "support/virtual_lab.h"
#include "support/virtual_sheets.h"

namespace pliant {
namespace {

RunContext on_two_threads() {
  RunContext context;
  context.threads = 2;
  return context;
}

TEST(SheetAddends, CarryAStretchAlone) {
  Material material = test::sheet_cloth(/*stiffens=*/false);
  MaterialComponent& weft = material.components.at("stretch.weft");
  weft.stiffness = ScalarCurve::none();
  weft.addends = {Addend(test::added_stiffness(), Eigen::Vector2d(80, 600))};
  const SheetTest stretch("stretch", test::virtual_stretch(material, 0, 7, 5),
                          SheetObjective::clip_forces);
  FitSettings settings;
  settings.model.components["stretch.weft"] = {
      CurveKind::none, FrictionChoice::none, {&test::added_stiffness()}};
  settings.fit.fix = {{"stretch.warp.k", 200}, {"shear.k", 8}};
  const std::vector<const SheetTest*> tests{&stretch};
  const SheetFit fit = fit_sheets(settings, sheet_plan(settings, tests), on_two_threads());
  const ComponentLaw law = law_of(fit.material, ComponentGroup{"stretch.weft"});
  EXPECT_EQ(law.stiffness.kind(), CurveKind::none);
  ASSERT_EQ(law.addends.size(), 1U);
  EXPECT_NEAR(law.addends.front().values()(0), 80, 0.08);
  EXPECT_NEAR(law.addends.front().values()(1), 600, 0.6);
  EXPECT_THAT(fit.warnings, ::testing::IsEmpty());
}

TEST(SheetAddends, ThatRememberAreMissedWhereNoLoopShowsThem) {
  const SheetTest stretch("stretch",
                          test::virtual_stretch(test::sheet_cloth(/*stiffens=*/false), 0, 7, 5),
                          SheetObjective::clip_forces);
  FitSettings settings;
  settings.model.components["stretch.weft"] = {
      std::nullopt, FrictionChoice::automatic, {find_addend_kind("dahl")}};
  const std::vector<const SheetTest*> tests{&stretch};
  const SheetFit fit = fit_sheets(settings, sheet_plan(settings, tests), on_two_threads());
  EXPECT_THAT(fit.warnings,
              ::testing::Contains(::testing::HasSubstr("1 of 1 addends of stretch.weft")));
}

/// A stretch along weft there and back, of a cloth whose friction has two branches.
class TwoBranches : public ::testing::Test {
 protected:
  TwoBranches() {
    Material cloth = first_sheet_material({});
    cloth.density = 0.15;
    MaterialComponent& weft = cloth.components.at("stretch.weft");
    weft.stiffness = ScalarCurve::hermite({0.0}, {300}, false);
    weft.friction = ComponentFriction{{1.2, 0, 0.002}, std::nullopt};
    weft.addends = {Addend(*find_addend_kind("dahl"), Eigen::Vector3d(2.5, 0, 0.03))};
    VirtualSession options = usual_session("stretch-weft");
    options.nodes = {9, 9};
    options.frames = 40;
    options.noise = {.position = 20e-6, .force = 1e-3};
    RandomStream random(1);
    write_session(folder_.path() / "stretch", make_virtual_session(cloth, options, random));
  }

  StudyResult fit(const std::string& addends) const {
    folder_.write("study.yaml",
                  "pliant: study/1\nname: loops\n"
                  "experiments:\n  - {name: stretch, type: session, data: stretch}\n"
                  "model: {mesh: measured, friction: dahl, components: {stretch.weft: {" +
                      addends + "}}}\n");
    return fit_study(read_study(folder_.path() / "study.yaml"), {}, on_two_threads());
  }

  test::TemporaryFolder folder_;
};

using SlowSheetAddends = TwoBranches;

TEST_F(SlowSheetAddends, FollowALoopCloserByASecondBranchAndStandInForFrictionThatIsLeftOut) {
  const StudyResult one = fit(""), two = fit("addends: [dahl]");
  std::printf("one branch %.2f %% of the peak, two %.2f %%\n", one.experiments.front().rms_percent,
              two.experiments.front().rms_percent);
  EXPECT_LT(two.experiments.front().rms_percent, one.experiments.front().rms_percent / 2);
  const std::map<std::string, double> truth{{"stretch.weft.k[0]", 300},
                                            {"stretch.weft.friction.a", 1.2},
                                            {"stretch.weft.friction.tau", 0.002},
                                            {"stretch.weft.dahl.a", 2.5},
                                            {"stretch.weft.dahl.tau", 0.03}};
  int met = 0;
  for (const ParameterEstimate& number : two.parameters) {
    const auto known = truth.find(number.name);
    if (known == truth.end()) continue;
    ++met;
    EXPECT_NEAR(number.value, known->second, 3 * number.std_error.value()) << number.name;
  }
  EXPECT_EQ(met, 5);

  const StudyResult added = fit("friction: none, addends: [dahl]");
  const auto named = [&](const char* name) {
    return std::ranges::find(added.parameters, name, &ParameterEstimate::name) !=
           added.parameters.end();
  };
  EXPECT_TRUE(named("stretch.weft.dahl.a"));
  EXPECT_FALSE(named("stretch.weft.friction.a"));
  EXPECT_NEAR(added.experiments.front().rms_percent, one.experiments.front().rms_percent, 0.05);
}

TEST(SheetAddends, CannotCarryASheetWhereAllOfThemRemember) {
  FitSettings settings;
  settings.model.components["stretch.weft"] = {
      CurveKind::none, FrictionChoice::automatic, {find_addend_kind("dahl")}};
  EXPECT_THAT(test::input_error_of([&] { refuse_foreign_options(settings); }).problem(),
              ::testing::HasSubstr("no addend is elastic"));
}

TEST(SheetStiffness, IsNotAffineForOneComponentEither) {
  FitSettings settings;
  settings.model.components["shear"] = {CurveKind::affine, FrictionChoice::automatic, {}};
  EXPECT_EQ(test::input_error_of([&] { refuse_foreign_options(settings); }).where().field,
            "model.components.shear.stiffness");
}

constexpr const char* kKnit = R"({
  "pliant": "material/1", "name": "knit", "kind": "cloth", "density": 0.15, "membrane": "stvk",
  "bending": "discrete-shells", "bending_of": "sheet",
  "components": {
    "stretch.weft": {"stiffness": {"curve": "constant", "value": 120}, "status": "assumed"},
    "stretch.warp": {"stiffness": {"curve": "constant", "value": 200},
                     "friction": {"law": "dahl", "a": 0.6, "b": 0, "tau": 0.002},
                     "addends": [{"law": "dahl", "a": 1.2, "b": 0, "tau": 0.03}], "status": "assumed"},
    "shear": {"stiffness": {"curve": "constant", "value": 20}, "status": "assumed"},
    "bend.weft": {"stiffness": {"curve": "constant", "value": 5e-6}, "status": "assumed"},
    "bend.warp": {"stiffness": {"curve": "constant", "value": 8e-6}, "status": "assumed"},
    "bend.diagonal": {"stiffness": {"curve": "constant", "value": 6e-6}, "status": "assumed"}
  }
})";

constexpr const char* kKnitLab = R"(pliant: lab/1
name: knit
material: cloth.json
experiments:
  - {name: weights, type: hanging-weights, direction: warp, length: 100 mm, width: 100 mm, clip_mass: 20 g,
     peaks: [1 N, 2 N, 3 N, 4 N], step: 0.25 N, noise: {length: 0.05 mm}}
  - {name: stretch, type: session, test: stretch-warp, strain: 2 %, frames: 24, mesh: {nodes: 9x9},
     noise: {position: 0.02 mm, force: 1 mN}}
)";

constexpr const char* kKnitStudy = R"(pliant: study/1
name: knit
density: 0.15 kg/m^2
experiments:
  - {name: weights, type: hanging-weights, data: weights.csv, direction: warp, width: 100 mm, length: 100 mm, clip_mass: 20 g}
  - {name: stretch, type: session, data: stretch}
model: {mesh: measured, stiffness: constant, friction: dahl, components: {stretch.warp: {addends: [dahl]}}}
)";

TEST(SlowJointAddends, OfWeightsAndASheetAreOne) {
  const test::TemporaryFolder lab;
  lab.write("cloth.json", kKnit);
  test::LabFolder folder(test::measurements_of(read_lab(lab.write("lab.yaml", kKnitLab)), 0));
  const StudyResult fit =
      fit_study(read_study(folder.write("study.yaml", kKnitStudy)), {}, on_two_threads());
  const std::map<std::string, double> truth{{"stretch.warp.dahl.a", 1.2},
                                            {"stretch.warp.dahl.tau", 0.03}};
  int met = 0;
  for (const ParameterEstimate& number : fit.parameters) {
    const auto known = truth.find(number.name);
    if (known == truth.end()) continue;
    ++met;
    EXPECT_NEAR(number.value, known->second, 3 * number.std_error.value()) << number.name;
  }
  EXPECT_EQ(met, 2);
  for (const ExperimentResult& experiment : fit.experiments) {
    EXPECT_LT(experiment.rms_percent, 0.7) << experiment.name;  // noise of poses
  }
}

}  // namespace
}  // namespace pliant
