#include "pliant/study/study.h"

#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/name_pattern.h"
#include "pliant/experiment/buckling/buckling_bend_type.h"
#include "pliant/experiment/hanging/hanging_weights_type.h"
#include "pliant/experiment/shear/shear_cycles_type.h"
#include "pliant/experiment/tensile/tensile_cycles_type.h"

#include "io/temporary_folder.h"
#include "study/study_text.h"

namespace pliant {
namespace {

using test::study_with_more;
using test::TemporaryFolder;
using test::with_experiment;
using ::testing::ElementsAre;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

// The example of the documented format, with an experiment for its pattern of validations.
constexpr const char* kExample = R"(pliant: study/1
name: spandex
density: 0.157 kg/m^2
info: {lot: A7, operator: KL}
conditions: {temperature: 20 degC, humidity: 65 %}
defaults: {length: 100 mm, width: 100 mm}                 # for every experiment that does not say otherwise
experiments:
  - {name: warp-weights, type: hanging-weights, direction: warp, data: warp-weights.csv, clip_mass: 20 g,
     standard: ISO 20932-1, exclude: [{rows: 12-18, reason: jaw slip}]}
  - {name: weft-2cm, type: tensile-cycles, direction: weft, data: weft.csv, length: 2 cm}
model:  {kind: cloth, membrane: stvk, bending: discrete-shells, stiffness: affine, friction: dahl}
fit:    {estimator: path}
validate: ["*-2cm"]                                       # names or patterns kept out of the fit
)";

Study read_text(const std::string& text) {
  const TemporaryFolder folder;
  return read_study(folder.write("study.yaml", text));
}

ExperimentSpec read_experiment(const std::string& experiment) {
  return read_text(with_experiment(experiment)).experiments.at(0);
}

TEST(Study, ReadsTheDocumentedExample) {
  const Study study = read_text(kExample);
  EXPECT_EQ(study.name, "spandex");
  EXPECT_EQ(study.density, 0.157);
  EXPECT_THAT(study.info, UnorderedElementsAre(Pair("lot", "A7"), Pair("operator", "KL")));
  EXPECT_THAT(study.conditions,
              UnorderedElementsAre(Pair("temperature", "20 degC"), Pair("humidity", "65 %")));
  EXPECT_EQ(study.model.membrane, MembraneMeasure::stvk);
  EXPECT_EQ(study.model.bending, "discrete-shells");
  EXPECT_EQ(study.model.stiffness, CurveKind::affine);
  EXPECT_EQ(study.model.friction, FrictionChoice::dahl);
  EXPECT_EQ(study.fit.estimator, EstimatorKind::path);
  EXPECT_THAT(study.validate, ElementsAre("*-2cm"));

  ASSERT_EQ(study.experiments.size(), 2U);
  const ExperimentSpec& weights = study.experiments[0];
  EXPECT_EQ(weights.name, "warp-weights");
  EXPECT_EQ(weights.type, "hanging-weights");
  EXPECT_EQ(weights.direction, "warp");
  EXPECT_EQ(weights.data.written, "warp-weights.csv");
  EXPECT_DOUBLE_EQ(spec_of<HangingWeightsSpec>(weights).clip_mass, 0.020);
  EXPECT_DOUBLE_EQ(weights.test->length, 0.1);
  EXPECT_DOUBLE_EQ(weights.test->width, 0.1);
  EXPECT_EQ(weights.standard, "ISO 20932-1");
  ASSERT_EQ(weights.excluded.size(), 1U);
  EXPECT_EQ(weights.excluded[0].first, 12);
  EXPECT_EQ(weights.excluded[0].last, 18);
  EXPECT_EQ(weights.excluded[0].reason, "jaw slip");
  EXPECT_EQ(weights.role, ExperimentRole::fit);
  EXPECT_EQ(study.experiments[1].role, ExperimentRole::validate);
  EXPECT_DOUBLE_EQ(study.experiments[1].test->length, 0.02);
}

TEST(Study, DefaultsAreThoseOfTheFormat) {
  const Study study = read_text(study_with_more(""));
  EXPECT_EQ(study.density, 0);
  EXPECT_EQ(study.model.membrane, MembraneMeasure::stvk);
  EXPECT_EQ(study.model.friction, FrictionChoice::automatic);
  EXPECT_FALSE(study.model.stiffness);
  EXPECT_EQ(study.fit.estimator, EstimatorKind::path);
  EXPECT_EQ(study.fit.control_points, 5);
  EXPECT_FALSE(spec_of<HangingWeightsSpec>(study.experiments[0]).rested);
}

template <class Spec>
InitialFriction initial_friction_of(const std::string& experiment) {
  return spec_of<Spec>(read_experiment(experiment)).initial_friction;
}

TEST(Study, TheFrictionStateOfCyclesIsUnknownByDefault) {
  const std::string strip =
      "{name: x, data: x.csv, type: tensile-cycles, direction: weft, length: 8 cm, width: 5 cm";
  const std::string sheared = "{name: x, data: x.csv, type: shear-cycles";
  const std::string rest = ", initial_friction: rest}";
  EXPECT_EQ(initial_friction_of<TensileCyclesSpec>(strip + "}"), InitialFriction::unknown);
  EXPECT_EQ(initial_friction_of<TensileCyclesSpec>(strip + rest), InitialFriction::rest);
  EXPECT_EQ(initial_friction_of<ShearCyclesSpec>(sheared + "}"), InitialFriction::unknown);
  EXPECT_EQ(initial_friction_of<ShearCyclesSpec>(sheared + rest), InitialFriction::rest);
}

TEST(Study, ReadsEveryFieldOfTensileCycles) {
  const ExperimentSpec spec = read_experiment(
      "{name: x, type: tensile-cycles, direction: bias, length: 8 cm, width: 5 cm, "
      "data: {file: x.csv, columns: {force: \"Load (N)\", extension: \"Extension (mm)\"}, "
      "encoding: gbk, skip_rows: 3}, pretension: 5 cN, apparatus_friction: 0.1 N, "
      "precondition_cycles: 2, noise: {force: 3 mN, length: 20 um}, rest_length: known}");
  const auto& own = spec_of<TensileCyclesSpec>(spec);
  EXPECT_EQ(spec.data.csv.encoding, "gbk");
  EXPECT_EQ(spec.data.csv.skip_rows, 3);
  EXPECT_EQ(spec.data.csv.columns.at("extension"), "Extension (mm)");
  EXPECT_DOUBLE_EQ(own.pretension, 0.05);
  EXPECT_DOUBLE_EQ(own.apparatus_friction, 0.1);
  EXPECT_EQ(own.precondition_cycles, 2);
  EXPECT_DOUBLE_EQ(spec.noise.force.value(), 3e-3);
  EXPECT_DOUBLE_EQ(spec.noise.length.value(), 2e-5);
  EXPECT_EQ(own.rest_length, RestLength::known);
}

TEST(Study, ReadsTheOptionsOfTheFit) {
  const Study study = read_text(study_with_more(
      "model:\n  components: {shear: {stiffness: constant, friction: none, addends: [dahl]}}\n"
      "fit:\n  estimator: anchor\n  control_points: 3\n"
      "  bounds: {\"*.friction.tau\": [0.001, 0.1]}\n  fix: {stretch.warp.k1: 4.5}\n"
      "  priors: {stretch.warp.k2: {mean: 30, sd: 2}}\n"));
  EXPECT_EQ(study.fit.estimator, EstimatorKind::anchor);
  EXPECT_EQ(study.fit.control_points, 3);
  EXPECT_EQ(study.fit.bounds.at("*.friction.tau"), std::make_pair(0.001, 0.1));
  EXPECT_EQ(study.fit.fix.at("stretch.warp.k1"), 4.5);
  EXPECT_EQ(study.fit.priors.at("stretch.warp.k2").sd, 2);
  EXPECT_EQ(study.model.components.at("shear").stiffness, CurveKind::constant);
  EXPECT_EQ(study.model.components.at("shear").friction, FrictionChoice::none);
  ASSERT_EQ(study.model.components.at("shear").addends.size(), 1u);
  EXPECT_EQ(study.model.components.at("shear").addends.front()->name, "dahl");
}

TEST(Study, ReadsWhichWayAStripBuckles) {
  for (const auto& [text, side] :
       {std::pair("up", BucklingSide::up), std::pair("down", BucklingSide::down)}) {
    const ExperimentSpec spec = read_experiment(
        std::string("{name: b, type: buckling-bend, direction: weft, length: 21 mm, width: 4 cm, "
                    "data: b.csv, noise: {force: 0.2 mN, length: 5 um}, side: ") +
        text + "}");
    const auto& own = spec_of<BucklingBendSpec>(spec);
    EXPECT_EQ(own.side, side) << text;
    EXPECT_EQ(own.rest_length, RestLength::known);
    EXPECT_DOUBLE_EQ(own.length, 0.021);
    EXPECT_DOUBLE_EQ(spec.noise.force.value(), 2e-4);
    EXPECT_DOUBLE_EQ(spec.noise.length.value(), 5e-6);
    EXPECT_EQ(component_of_test(spec.type, spec.direction), "bend.weft");
  }
}

}  // namespace
}  // namespace pliant
