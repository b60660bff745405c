#include "pliant/estimation/sheet/sheet_options.h"

#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/sheet/sheet_problem.h"
#include "pliant/study/study_fit.h"

#include "io/temporary_folder.h"
#include "support/virtual_sheets.h"

namespace pliant {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr double kWeft = 80, kShear = 8;  // of the cloth that the sessions are made with (N/m)

/// A stretch along weft and a shear, fitted with some options.
class StretchAndShear {
 public:
  StretchAndShear() {
    Material cloth = test::sheet_cloth(false);
    // No session tells it: as a fit guesses it.
    cloth.components.at("stretch.warp").stiffness = ScalarCurve::hermite({0.0}, {100.0});
    write_session(folder_.path() / "weft", test::virtual_stretch(cloth, 0, 7, 4));
    write_session(folder_.path() / "shear", test::virtual_shear(cloth, 7, 4));
  }

  StudyResult fit(const std::string& options) const {
    folder_.write("study.yaml",
                  "pliant: study/1\nname: two\nexperiments:\n"
                  "  - {name: weft, type: session, data: weft}\n"
                  "  - {name: shear, type: session, data: shear}\n"
                  "model: {mesh: measured}\nfit: {" +
                      options + "}\n");
    return fit_study(read_study(folder_.path() / "study.yaml"), {}, {});
  }

 private:
  test::TemporaryFolder folder_;
};

std::vector<ParameterEstimate> of_component(const StudyResult& result, const std::string& name) {
  std::vector<ParameterEstimate> found;
  for (const ParameterEstimate& p : result.parameters) {
    if (p.owner == name) found.push_back(p);
  }
  return found;
}

TEST(SheetOptions, KeepAStiffnessThatTheStudyStates) {
  const StretchAndShear tests;
  const StudyResult result = tests.fit("fix: {shear.k: 12}");
  const auto shear = of_component(result, "shear");
  ASSERT_EQ(shear.size(), 1U);
  EXPECT_EQ(shear[0].value, 12);
  EXPECT_TRUE(shear[0].fixed);
  EXPECT_FALSE(shear[0].std_error.has_value());
  EXPECT_EQ(result.material.components.at("shear").status, ComponentStatus::measured);
  // What is not fixed is fitted as before.
  const auto weft = of_component(result, "stretch.weft");
  ASSERT_FALSE(weft.empty());
  EXPECT_NEAR(weft[0].value, kWeft, 0.01 * kWeft);
  EXPECT_TRUE(weft[0].std_error.has_value());
}

TEST(SheetOptions, HoldEveryControlValueWithinBounds) {
  const StretchAndShear tests;
  const StudyResult result = tests.fit("control_points: 3, bounds: {\"stretch.*.k\": [100, 500]}");
  for (const ParameterEstimate& p : of_component(result, "stretch.weft")) {
    EXPECT_GE(p.value, 100) << p.name;
    EXPECT_EQ(p.at_bound, p.value == 100) << p.name;
  }
  const ParameterEstimate first = of_component(result, "stretch.weft")[0];
  EXPECT_EQ(first.value, 100);
  EXPECT_THAT(result.warnings,
              Contains(AllOf(HasSubstr("at their bounds"), HasSubstr(first.name))));
}

TEST(SheetOptions, WeighPriorsAgainstTheData) {
  const StretchAndShear tests;
  const auto shear_with = [&](double sd) {
    const StudyResult result =
        tests.fit(fmt::format("control_points: 1, priors: {{shear.k: {{mean: 12, sd: {}}}}}", sd));
    return of_component(result, "shear").at(0);
  };
  // Forces without noise count as if they had 1 mN of it: they tell shear to some hundredths of a
  // N/m, far better than the one prior and far worse than the other. Stretch was fitted before
  // shear was known, which leaves it 2 % off.
  const ParameterEstimate by_data = shear_with(10), by_prior = shear_with(1e-5);
  EXPECT_NEAR(by_data.value, kShear, 0.03 * kShear);
  EXPECT_TRUE(by_data.identified);
  EXPECT_NEAR(by_prior.value, 12, 0.01);
  EXPECT_FALSE(by_prior.identified);
  EXPECT_NEAR(*by_prior.std_error, 1e-5, 1e-6);
}

TEST(SheetOptions, FixAndBoundFriction) {
  Material cloth = test::sheet_cloth(false);
  cloth.components.at("stretch.weft").friction =
      ComponentFriction{DahlParameters{1, 0, 0.01}, std::nullopt};
  const SheetTest weft("weft", test::virtual_stretch(test::sheet_cloth(false), 0, 5, 2),
                       SheetObjective::clip_forces);
  FitOptions options;
  options.fix = {{"*.friction.b", 3}};
  options.bounds = {{"stretch.weft.friction.tau", {0.02, 0.03}}};
  options.priors = {{"stretch.weft.friction.a", {2, 0.5}}};
  const SheetProblem problem({&weft}, cloth, {{"stretch.weft"}}, {0.1}, {}, {}, options);
  ASSERT_EQ(problem.unknowns().size(), 4U);
  // Stiffness, a, b, tau: the search begins within the bounds.
  EXPECT_EQ(problem.start(), Eigen::Vector4d(kWeft, 1, 3, 0.02));
  EXPECT_TRUE(problem.unknowns()[2].fixed);
  EXPECT_EQ(problem.unknowns()[1].prior->mean, 2);
  EXPECT_EQ(problem.least_squares().residuals, weft.rows() + 1);
}

TEST(SheetOptions, AreRefusedForParametersThatSheetsDoNotHave) {
  const StretchAndShear tests;
  for (const char* options :
       {"fix: {\"shear.k[0]\": 8}", "bounds: {bend.weft.friction.a: [0, 1]}",
        "priors: {weft.clip0.1.cord_friction: {mean: 0.1, sd: 0.1}}", "fix: {shear.k1: 3}"}) {
    try {
      tests.fit(options);
      FAIL() << options;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("no parameter of a fit of sheets")) << options;
      EXPECT_THAT(error.what(), HasSubstr("COMPONENT.k")) << options;
    }
  }
}

}  // namespace
}  // namespace pliant
