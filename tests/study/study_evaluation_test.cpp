#include "pliant/study/study_evaluation.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/study/result_files.h"
#include "pliant/study/test_template.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// The examples of a pull and of a bend along the warp, in one study.
class PulledAndBent {
 public:
  explicit PulledAndBent(const std::string& more = "") {
    for (const char* type : {"tensile-cycles", "pure-bending"}) {
      for (const auto& [name, content] : test_template(type)) {
        if (name.ends_with(".csv")) folder_.write(std::string(type) + ".csv", content);
      }
    }
    study_ = read_study(folder_.write("study.yaml", R"(pliant: study/1
name: cloth
density: 150 g/m^2
experiments:
  - {name: pull, type: tensile-cycles, direction: warp, data: tensile-cycles.csv, length: 100 mm, width: 50 mm}
  - {name: bend, type: pure-bending, direction: warp, data: pure-bending.csv}
)" + more));
  }

  StudyResult evaluated(const Material& material, const FoundNuisance& found = {}) const {
    return evaluate_study(study_, material, {}, found);
  }

 private:
  test::TemporaryFolder folder_;
  Study study_;
};

Material cloth() {
  Material material;
  material.name = "cloth";
  material.density = 0.15;
  material.components["stretch.warp"].stiffness = ScalarCurve::constant(130);
  material.components["bend.warp"].stiffness = ScalarCurve::constant(3e-6);
  return material;
}

TEST(Evaluation, SkipsTheExperimentsWhoseComponentTheMaterialDoesNotHave) {
  const PulledAndBent study;
  EXPECT_THAT(study.evaluated(cloth()).skipped, IsEmpty());
  Material material = cloth();
  material.components.erase("bend.warp");
  const StudyResult result = study.evaluated(material);
  ASSERT_EQ(result.experiments.size(), 1u);
  EXPECT_EQ(result.experiments[0].name, "pull");
  ASSERT_EQ(result.skipped.size(), 1u);
  EXPECT_EQ(result.skipped[0].name, "bend");
  EXPECT_THAT(result.skipped[0].missing, ElementsAre("bend.warp"));
  const auto json = nlohmann::json::parse(summary_text(result, {}, false));
  EXPECT_EQ(json["skipped"][0]["missing"][0], "bend.warp");
  EXPECT_NE(result.judgement.fitness, Fitness::fit);
  EXPECT_THAT(result.judgement.headline, HasSubstr("Not all experiments are predicted."));
}

TEST(Evaluation, NamesTheNumbersOfExperimentsThatNoFitTells) {
  const PulledAndBent study("validate: [bend]\n");
  Material material = cloth();
  const StudyResult elastic = study.evaluated(material);
  ASSERT_EQ(elastic.left_out.size(), 1u) << "the bend is predicted in its fit, too";
  EXPECT_EQ(elastic.left_out[0].experiment, "pull");
  EXPECT_THAT(elastic.left_out[0].numbers, ElementsAre("force offset"));

  material.components["stretch.warp"].friction = {{2, 1, 0.01}, {}};
  const StudyResult result = study.evaluated(material);
  EXPECT_THAT(result.left_out[0].numbers, ElementsAre("force offset", "initial friction"));
  EXPECT_THAT(result.warnings,
              Contains(HasSubstr("left out of pull, so that it counts as error of the material: "
                                 "force offset, initial friction")));
  EXPECT_THAT(result.judgement.headline,
              HasSubstr("Left out, for no fit tells them: force offset, initial friction."));
  for (const ExperimentResult& e : result.experiments) {
    EXPECT_THAT(e.handled, Contains(HasSubstr("predicted, the material as it is given")));
    EXPECT_THAT(e.handled, Not(Contains(HasSubstr("estimated along")))) << e.name;
  }
}

TEST(Evaluation, TakesTheNumbersOfExperimentsThatAFitTells) {
  FoundNuisance found;
  found.others = {{"pull.force_offset", 0.25}, {"pull.initial_friction", 0}};
  const PulledAndBent study("validate: [bend]\n");
  const StudyResult result = study.evaluated(cloth(), found);
  EXPECT_THAT(result.left_out, IsEmpty());
  EXPECT_THAT(result.judgement.headline, Not(HasSubstr("Left out")));
  const ExperimentResult& pull = result.experiments[0];
  EXPECT_THAT(pull.handled, Not(Contains(HasSubstr("estimated along"))));
  EXPECT_THAT(pull.handled, Contains("its own numbers are those of the fit of the material"));
  const Eigen::VectorXd shift = pull.predicted - study.evaluated(cloth()).experiments[0].predicted;
  EXPECT_TRUE(shift.isConstant(0.25, 1e-12)) << shift;
}

TEST(Evaluation, RefusesAMaterialThatPredictsNothing) {
  Material material = cloth();
  material.components.erase("bend.warp");
  material.components["stretch.warp"].status = ComponentStatus::unmeasured;
  material.components["stretch.warp"].stiffness.reset();
  const PulledAndBent study;
  const InputError error = test::input_error_of([&] { study.evaluated(material); });
  EXPECT_THAT(error.problem(), HasSubstr("has no bend.warp, stretch.warp"));
}

TEST(Evaluation, AsksWhetherAMaterialOfAnotherWeightIsTheSameFabric) {
  const PulledAndBent study;
  Material material = cloth();
  material.density = 0.16;
  EXPECT_THAT(study.evaluated(material).questions, IsEmpty());
  material.density = 0.2;
  const StudyResult result = study.evaluated(material);
  EXPECT_THAT(
      result.questions,
      ElementsAre(HasSubstr("\"cloth\" weighs 200 g/m^2, the study's fabric 150 g/m^2: is it "
                            "the same fabric?")));
  const auto json = nlohmann::json::parse(summary_text(result, {}, false));
  EXPECT_EQ(json["warnings"][0], result.questions[0]);
  EXPECT_THAT(result.judgement.headline, HasSubstr("the fabric are in question."));
}

TEST(Evaluation, AsksAboutBendingOfHingesWhereStripsAreBent) {
  Material material = cloth();
  material.bending_of = "hinges";
  EXPECT_THAT(PulledAndBent().evaluated(material).questions,
              ElementsAre(HasSubstr("bending of the material \"cloth\" is that of hinges")));
}

TEST(Evaluation, AsksAboutAnotherStrainMeasureThanTheStudys) {
  EXPECT_THAT(PulledAndBent("model: {membrane: spring}\n").evaluated(cloth()).questions,
              ElementsAre(HasSubstr("measures strain by spring, the material \"cloth\" by stvk")));
}

}  // namespace
}  // namespace pliant
