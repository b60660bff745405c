// Strips and sheets of one fabric tell one material together.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/journal.h"
#include "pliant/study/study_fit.h"

#include "io/input_error_of.h"
#include "support/asked_for.h"
#include "support/virtual_lab.h"

namespace pliant {
namespace {

/// The cloth, whose bending is that of a sheet and has no friction.
constexpr const char* kCloth = R"({
  "pliant": "material/1", "name": "cloth", "kind": "cloth", "density": 0.15, "membrane": "stvk",
  "bending": "discrete-shells", "bending_of": "sheet",
  "components": {
    "stretch.weft": {"stiffness": {"curve": "constant", "value": 120}, "status": "assumed"},
    "stretch.warp": {"stiffness": {"curve": "affine", "k1": 150, "k2": 400},
                     "friction": {"law": "dahl", "a": 1.5, "b": 2, "tau": 0.006}, "status": "assumed"},
    "shear": {"stiffness": {"curve": "constant", "value": 20}, "status": "assumed"},
    "bend.weft": {"stiffness": {"curve": "constant", "value": 5e-6}, "status": "assumed"},
    "bend.warp": {"stiffness": {"curve": "constant", "value": 8e-6}, "status": "assumed"},
    "bend.diagonal": {"stiffness": {"curve": "constant", "value": 6e-6}, "status": "assumed"}
  }
})";

constexpr const char* kLab = R"(pliant: lab/1
name: joint
material: cloth.json
experiments:
  - {name: weights, type: hanging-weights, direction: warp, length: 100 mm, width: 100 mm, clip_mass: 20 g,
     peaks: [1 N, 2 N, 3 N, 4 N], step: 1 N, noise: {length: 0.2 mm}}
  - {name: bending, type: pure-bending, direction: warp, peaks: [100 1/m, 200 1/m], samples: 60, noise: {moment: 2e-5 N}}
  - {name: stretch, type: session, test: stretch-warp, strain: 8 %, frames: 16, mesh: {nodes: 9x9},
     noise: {position: 0.075 mm, force: 3 mN}}
  - {name: overhang, type: session, test: bend-warp, overhang: 70 mm, frames: 8, mesh: {nodes: 9x9}, noise: {position: 0.075 mm}}
  - {name: along-weft, type: session, test: bend-weft, overhang: 70 mm, frames: 8, mesh: {nodes: 9x9}, noise: {position: 0.075 mm}}
)";

constexpr const char* kExperiments = R"(pliant: study/1
name: joint
density: 0.15 kg/m^2
experiments:
  - {name: weights, type: hanging-weights, data: weights.csv, direction: warp, width: 100 mm, length: 100 mm, clip_mass: 20 g}
  - {name: bending, type: pure-bending, data: bending.csv, direction: warp, initial_friction: rest}
)";
constexpr const char* kSessions = R"(  - {name: stretch, type: session, data: stretch}
  - {name: overhang, type: session, data: overhang}
  - {name: along-weft, type: session, data: along-weft}
)";
constexpr const char* kModel =
    "model: {mesh: measured, components: {bend.warp: {friction: none}}}\n";

test::MeasuredFiles measured(std::uint64_t seed) {
  const test::TemporaryFolder lab;
  lab.write("cloth.json", kCloth);
  return test::measurements_of(read_lab(lab.write("lab.yaml", kLab)), seed);
}

/// The five experiments as files, each sheet on the mesh that it was measured on.
class JointStudy {
 public:
  /// @param others  files in place of those that were measured
  explicit JointStudy(std::uint64_t seed = 0, const test::MeasuredFiles& others = {})
      : folder_(measured(seed)) {
    for (const auto& [name, content] : others) folder_.write(name, content);
  }

  StudyResult fit(const std::string& text, const RunContext& context = on_two_threads()) const {
    return fit_study(read_study(folder_.write("asked.yaml", text)), {}, context);
  }
  StudyResult fit_all(const RunContext& context = on_two_threads()) const {
    return fit(std::string(kExperiments) + kSessions + kModel, context);
  }

 private:
  static RunContext on_two_threads() {
    RunContext context;
    context.threads = 2;
    return context;
  }

  test::LabFolder folder_;
};

const ParameterEstimate& named(const StudyResult& result, const std::string& name) {
  const auto found = std::ranges::find(result.parameters, name, &ParameterEstimate::name);
  EXPECT_NE(found, result.parameters.end()) << name;
  return *found;
}

bool holds(const ParameterEstimate& estimate, double truth) {
  return *estimate.lower <= truth && truth <= *estimate.upper;
}

TEST(SlowJointFit, CoversTheTruthAndKnowsItBetterThanStripsAlone) {
  const std::map<std::string, double> truth{
      {"bend.warp.k[0]", 8e-6},       {"bend.diagonal.k[0]", 6e-6},
      {"bend.weft.k[0]", 5e-6},       {"stretch.warp.k1", 150},
      {"stretch.warp.k2", 400},       {"stretch.warp.friction.a", 1.5},
      {"stretch.warp.friction.b", 2}, {"stretch.warp.friction.tau", 0.006}};
  int asked = 0, held = 0;
  const std::uint64_t seeds = test::makes_figures() ? 3 : 2;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const JointStudy study(seed);
    const StudyResult together = study.fit_all();
    const StudyResult strips = study.fit(std::string(kExperiments) + kModel);
    for (const auto& [name, value] : truth) {
      const ParameterEstimate& estimate = named(together, name);
      ASSERT_TRUE(estimate.std_error.has_value()) << name;
      std::printf("%-28s %.4g +- %.2g (%.4g)\n", name.c_str(), estimate.value, *estimate.std_error,
                  value);
      ++asked;
      held += holds(estimate, value) ? 1 : 0;
      if (name == "bend.diagonal.k[0]" || name == "bend.weft.k[0]") continue;  // sheets alone do
      const ParameterEstimate& alone = named(strips, name);
      if (alone.at_bound) continue;
      // Two jackknives of so few groups agree to 30 % or so.
      EXPECT_LE(*estimate.std_error, 1.4 * *alone.std_error) << name;
    }
  }
  EXPECT_GE(held, asked - 2);  // one of twenty by chance
}

void expect_one_covariance_and_one_material(const StudyResult& result) {
  const auto count = std::ssize(result.parameters) + std::ssize(result.nuisance);
  ASSERT_EQ(result.covariance.rows(), count);
  for (Eigen::Index i = 0; i < std::ssize(result.parameters); ++i) {
    const ParameterEstimate& estimate = result.parameters[static_cast<std::size_t>(i)];
    if (!estimate.std_error) continue;
    EXPECT_NEAR(std::sqrt(result.covariance(i, i)), *estimate.std_error, 1e-9 * *estimate.std_error)
        << estimate.name;
  }
  EXPECT_EQ(result.material.bending_of, "sheet");
  EXPECT_EQ(result.experiments.size(), 5u);
  EXPECT_EQ(result.stages.back().name, "together");
  EXPECT_EQ(*result.material.components.at("bend.warp").stiffness->values().begin(),
            named(result, "bend.warp.k[0]").value);
}

TEST(SlowJointFit, LeavesFrictionOutThatStripsDoNotShow) {
  const StudyResult result =
      JointStudy().fit(std::string(kExperiments) + kSessions +
                       "model: {mesh: measured}\n"
                       "fit: {bounds: {stretch.warp.friction.b: [2.5, 60]}}\n");
  EXPECT_FALSE(result.material.components.at("bend.warp").friction);
  EXPECT_TRUE(result.material.components.at("stretch.warp").friction);
  EXPECT_THAT(result.undetermined,
              ::testing::Contains(::testing::HasSubstr("friction of bend.warp")));
  // The strips alone have a limit of it, which says nothing of what all tell together.
  const ParameterEstimate& b = named(result, "stretch.warp.friction.b");
  EXPECT_TRUE(b.at_bound);
  EXPECT_FALSE(b.limit);
}

/// A cloth whose threads rub where it bends, rolled along warp and pushed over an edge.
constexpr const char* kRubbingCloth = R"({
  "pliant": "material/1", "name": "cloth", "kind": "cloth", "density": 0.15, "membrane": "stvk",
  "bending": "discrete-shells", "bending_of": "sheet",
  "components": {
    "stretch.weft": {"stiffness": {"curve": "constant", "value": 136}, "status": "assumed"},
    "stretch.warp": {"stiffness": {"curve": "constant", "value": 136}, "status": "assumed"},
    "shear": {"stiffness": {"curve": "constant", "value": 20}, "status": "assumed"},
    "bend.weft": {"stiffness": {"curve": "constant", "value": 8e-6},
                  "friction": {"law": "dahl", "a": 2e-4, "b": 0, "tau": 10}, "status": "assumed"},
    "bend.warp": {"stiffness": {"curve": "constant", "value": 8e-6},
                  "friction": {"law": "dahl", "a": 2e-4, "b": 0, "tau": 10}, "status": "assumed"},
    "bend.diagonal": {"stiffness": {"curve": "constant", "value": 6e-6},
                      "friction": {"law": "dahl", "a": 1e-4, "b": 0, "tau": 20}, "status": "assumed"}
  }
})";
constexpr const char* kRubbingLab = R"(pliant: lab/1
name: joint
material: cloth.json
experiments:
  - {name: edge, type: session, test: bend-warp, overhang: 70 mm, frames: 12, mesh: {nodes: 13x13}, noise: {position: 0.05 mm}}
  - {name: rolls, type: rolled-strip, direction: warp, length: 80 mm, width: 25 mm, radii: [6 mm, 10 mm, 16 mm, 25 mm],
     points: 20, noise: {position: 0.1 mm}}
)";
constexpr const char* kRubbingStudy = R"(pliant: study/1
name: joint
density: 0.15 kg/m^2
experiments:
  - {name: edge, type: session, data: edge}
  - {name: rolls, type: rolled-strip, data: rolls.csv, direction: warp, width: 25 mm, length: 80 mm}
model: {mesh: measured}
)";

TEST(SlowJointFit, FindsTheFrictionOfTheDiagonalBesideRolledStrips) {
  const test::TemporaryFolder lab;
  lab.write("cloth.json", kRubbingCloth);
  const test::LabFolder folder(
      test::measurements_of(read_lab(lab.write("lab.yaml", kRubbingLab)), 1));
  RunContext context;
  context.threads = 2;
  const StudyResult result =
      fit_study(read_study(folder.write("study.yaml", kRubbingStudy)), {}, context);
  // A tenth above the noise at most, which is in space for the sheet.
  EXPECT_LT(result.experiments[0].rms, 1.1 * 0.1e-3);
  EXPECT_LT(result.experiments[1].rms, 1.1 * std::sqrt(3) * 0.05e-3);
  for (const std::string& warning : result.warnings) {
    EXPECT_THAT(warning, ::testing::Not(::testing::HasSubstr("fitted together")));
  }
  for (const auto& [name, truth] :
       std::map<std::string, double>{{"bend.warp.k1", 8e-6}, {"bend.warp.friction.a", 2e-4}}) {
    const ParameterEstimate& estimate = named(result, name);
    std::printf("%s %.4g +- %.2g\n", name.c_str(), estimate.value, *estimate.std_error);
    EXPECT_NEAR(estimate.value, truth, 3 * *estimate.std_error) << name;
    EXPECT_LT(*estimate.std_error, 0.05 * truth);
  }
}

TEST(SlowJointFit, SaysThatStripsDoNotFollowTheLawOfTheSheets) {
  std::string stiffer = kCloth;
  stiffer.replace(stiffer.find("8e-6"), 4, "2.4e-5");
  const test::TemporaryFolder lab;
  lab.write("cloth.json", stiffer);
  const test::MeasuredFiles strips =
      test::measurements_of(read_lab(lab.write("lab.yaml", kLab)), 0);
  const JointStudy study(
      0, {*std::ranges::find(strips, "bending.csv", &test::MeasuredFiles::value_type::first)});
  const StudyResult result = study.fit(
      std::string(kExperiments) + "  - {name: overhang, type: session, data: overhang}\n" + kModel);
  EXPECT_THAT(result.warnings, ::testing::Contains(::testing::HasSubstr("do not follow one law")));
}

TEST(SlowJointFit, HasOneCovarianceAndOneMaterialAndGoesOnToTheSameBits) {
  const JointStudy study;
  std::vector<Journal::Content> contents;
  Journal journal([&](const Journal::Content& now) {
    if (now.reached.empty() &&
        (contents.empty() || contents.back().entries.size() < now.entries.size()))
      contents.push_back(now);
  });
  const StudyResult whole = study.fit_all({silent_progress(), {}, 2, 0, journal});
  expect_one_covariance_and_one_material(whole);
  ASSERT_GT(contents.size(), 2u);
  Journal later([](const auto&) {});
  later.resume(contents[contents.size() - 2], "progress.bin");
  const StudyResult rest = study.fit_all({silent_progress(), {}, 2, 0, later});
  for (std::size_t i = 0; i < whole.parameters.size(); ++i) {
    EXPECT_EQ(rest.parameters[i].value, whole.parameters[i].value) << whole.parameters[i].name;
    EXPECT_EQ(rest.parameters[i].std_error, whole.parameters[i].std_error);
  }
}

TEST(JointFit, SaysThatSheetsWhichStripsCannotPredictAreLeftOut) {
  const StudyResult result = JointStudy().fit(std::string(kExperiments) + kSessions +
                                              "validate: [stretch, overhang, along-weft]\n");
  EXPECT_EQ(result.experiments.size(), 2u);
  EXPECT_THAT(result.warnings, ::testing::Contains(::testing::HasSubstr("stretch: left out")));
}

TEST(JointFit, RefusesModelsThatStripsAndSheetsDoNotShare) {
  const JointStudy study;
  const std::string experiments = std::string(kExperiments) + kSessions;
  const auto field_of = [&](const std::string& model) {
    return test::input_error_of([&] { study.fit(experiments + model); }).where().field;
  };
  EXPECT_EQ(field_of("model: {mesh: measured, bending: spring}\n"), "model.bending");
  EXPECT_EQ(field_of("model: {variant: nonlinear-isotropic}\n"), "model.variant");
  EXPECT_EQ(field_of("fit: {estimator: anchor}\n"), "fit.estimator");
}

}  // namespace
}  // namespace pliant
