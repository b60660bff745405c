// Studies that cannot be used are refused with file, line and field.

#include <string>

#include <gtest/gtest.h>

#include "pliant/study/study.h"

#include "io/temporary_folder.h"
#include "study/study_text.h"
#include "support/refusal.h"

namespace pliant {
namespace {

using test::kWeightsEntry;
using test::Refusal;
using test::study_with_more;
using test::TemporaryFolder;
using test::with_experiment;

class StudyRefusal : public ::testing::TestWithParam<Refusal> {};

TEST_P(StudyRefusal, NamesFileLineAndField) {
  const TemporaryFolder folder;
  const auto path = folder.write("study.yaml", GetParam().text);
  expect_refused(GetParam(), path, read_study);
}

/// A hanging-weights experiment with further fields on line 5.
std::string with_field(const std::string& field) {
  return with_experiment("{name: w, type: hanging-weights, direction: warp, data: w.csv,\n     " +
                         field + "}");
}

std::string strip(const std::string& name, const std::string& direction) {
  return "{name: " + name + ", type: tensile-cycles, direction: " + direction +
         ", data: w.csv, length: 1 m, width: 1 m";
}

std::string after(const std::string& name, const std::string& direction) {
  return strip("after-" + name, direction) + ", after: " + name;
}

const Refusal kRefusals[] = {
    {"UnknownVersion", "pliant: study/2\nname: x\n", 1, "pliant", "unknown version \"2\""},
    {"AnotherDocument", "pliant: scene/1\nname: x\n", 1, "pliant", "study/1"},
    {"NoType", "name: x\n", 1, "pliant", "is missing"},
    {"NoName", "pliant: study/1\nexperiments: []\n", 1, "name", "is missing"},
    {"NoExperiments", "pliant: study/1\nname: x\n", 1, "experiments", "is missing"},
    {"EmptyExperiments", "pliant: study/1\nname: x\nexperiments: []\n", 3, "experiments",
     "has no experiment"},
    {"UnknownKey", study_with_more("densty: 1 kg/m^2\n"), 5, "densty", "did you mean \"density\"?"},
    {"RepeatedKey", study_with_more("name: y\n"), 5, "name", "name"},
    {"UnknownKeyOfAnExperiment", with_field("length: 1 m, width: 1 m, clip_mas: 2 g"), 5,
     "experiments[0].clip_mas", "did you mean \"clip_mass\"?"},
    {"UnknownKeyOfTheModel", study_with_more("model: {frictoin: dahl}\n"), 5, "model.frictoin",
     "did you mean \"friction\"?"},
    {"UnknownKeyOfTheFit", study_with_more("fit: {estimater: path}\n"), 5, "fit.estimater",
     "did you mean \"estimator\"?"},
    {"UnknownKeyOfTheDefaults", study_with_more("defaults: {lenght: 1 m}\n"), 5, "defaults.lenght",
     "did you mean \"length\"?"},
    {"UnknownExperimentType",
     with_experiment("{name: w, type: hanging-weight, direction: warp, data: w.csv}"), 4,
     "experiments[0].type", "did you mean \"hanging-weights\"?"},
    {"UnknownEstimator", study_with_more("fit: {estimator: anchors}\n"), 5, "fit.estimator",
     "did you mean \"anchor\"?"},
    {"UnknownMeasure", study_with_more("model: {membrane: stvkk}\n"), 5, "model.membrane",
     "did you mean \"stvk\"?"},
    {"UnknownComponent", study_with_more("model: {components: {stretch.wrap: {friction: none}}}\n"),
     5, "model.components.stretch.wrap", "did you mean \"stretch.warp\"?"},
    {"FunctionOfAnotherStrain",
     study_with_more("model: {membrane: spring, components: {area: {}}}\n"), 5, "model.components",
     "a function of Green's strain, and the membrane is `spring`"},
    {"PlacesOfGaussians",
     study_with_more("model: {components: {stretch.weft*shear@0.1/0~0.1/0.1: {gaussians: 2}}}\n"),
     5, "model.components.stretch.weft*shear@0.1/0~0.1/0.1", "unknown key"},
    {"LimitOfBending", study_with_more("model: {limits: [{of: [bend.weft]}]}\n"), 5,
     "model.limits[0].of[0]", "bend.weft"},
    {"UnknownKeyOfWhatIsAccepted", study_with_more("accept: {lop: 3 %}\n"), 5, "accept.lop",
     "did you mean \"loop\"?"},
    {"AcceptedShareWithoutUnit", study_with_more("accept: {rms: 0.03}\n"), 5, "accept.rms",
     "has no unit"},
    {"NothingIsAccepted", study_with_more("accept: {loop: 0 %}\n"), 5, "accept.loop",
     "not positive"},
    {"UnknownAddend", study_with_more("model: {components: {shear: {addends: [dahlia]}}}\n"), 5,
     "model.components.shear.addends[0]", "did you mean \"dahl\"?"},
    {"NothingThatCarries", study_with_more("model: {components: {shear: {stiffness: none}}}\n"), 5,
     "model.components.shear.stiffness", "no addends are there"},
    {"NoStiffnessAtAll", study_with_more("model: {stiffness: none}\n"), 5, "model.stiffness",
     "none"},
    {"UnknownDirection",
     with_experiment("{name: w, type: hanging-weights, direction: wrap, data: w.csv}"), 4,
     "experiments[0].direction", "expected \"warp\", \"weft\" or \"bias\""},
    {"ObliqueStripInOneDimension",
     with_experiment(
         "{name: w, type: tensile-cycles, direction: 30 deg, data: w.csv,\n     length: "
         "1 m, width: 1 m}"),
     4, "experiments[0].direction", "expected `model: {strips: sheet}`"},
    {"AngleOfAStripWithoutUnit",
     with_experiment("{name: w, type: tensile-cycles, direction: 30, data: w.csv}"), 4,
     "experiments[0].direction", "deg"},
    {"StripTurnedHalfWay",
     with_experiment("{name: w, type: tensile-cycles, direction: 180 deg, data: w.csv}"), 4,
     "experiments[0].direction", "less than 180 deg"},
    {"AfterWhatComesLater",
     with_experiment(after("l", "warp") + "}\n  - " + strip("l", "warp") + "}"), 4,
     "experiments[0].after", "names no experiment that stands before it"},
    {"AfterAnotherDirection",
     with_experiment(strip("l", "weft") + "}\n  - " + after("l", "warp") + "}"), 5,
     "experiments[1].after",
     "expected an earlier experiment of the list, tensile-cycles along warp"},
    {"AfterAndUnknownFriction",
     with_experiment(strip("l", "warp") + "}\n  - " + after("l", "warp") +
                     ", initial_friction: unknown}"),
     5, "experiments[1].initial_friction", "as the test before has left it"},
    {"AfterOfAnotherType", with_field("length: 1 m, width: 1 m, after: x"), 5,
     "experiments[0].after", "unknown key"},
    {"NoDirection", with_experiment("{name: w, type: tensile-cycles, data: w.csv}"), 4,
     "experiments[0].direction", "is missing"},
    {"NoData", with_experiment("{name: w, type: shear-cycles}"), 4, "experiments[0].data",
     "is missing"},
    {"NoLength", with_field("width: 1 m"), 4, "experiments[0].length", "is missing"},
    {"DensityWithoutUnit", study_with_more("density: 0.157\n"), 5, "density", "kg/m^2"},
    {"LengthWithoutUnit", with_field("length: 100, width: 1 m"), 5, "experiments[0].length", "mm"},
    {"ClipMassInNewtons", with_field("length: 1 m, width: 1 m, clip_mass: 1 N"), 5,
     "experiments[0].clip_mass", "kg"},
    {"UnknownUnit", with_field("length: 3 furlongs, width: 1 m"), 5, "experiments[0].length",
     "furlongs"},
    {"NegativeLength", with_field("length: -1 m, width: 1 m"), 5, "experiments[0].length",
     "is not positive"},
    {"ZeroDensity", study_with_more("density: 0 kg/m^2\n"), 5, "density", "is not positive"},
    {"NegativeClipMass", with_field("length: 1 m, width: 1 m, clip_mass: -2 g"), 5,
     "experiments[0].clip_mass", "is negative"},
    {"NegativePreconditioning",
     with_experiment("{name: w, type: tensile-cycles, direction: warp, data: w.csv, length: 1 m, "
                     "width: 1 m, precondition_cycles: -1}"),
     4, "experiments[0].precondition_cycles", "-1"},
    {"RangeOfRowsBackwards",
     with_field("length: 1 m, width: 1 m, exclude: [{rows: 5-3, reason: x}]"), 5,
     "experiments[0].exclude[0].rows", "no range of rows"},
    {"RowsCountedFromZero",
     with_field("length: 1 m, width: 1 m, exclude: [{rows: 0-3, reason: x}]"), 5,
     "experiments[0].exclude[0].rows", "no range of rows"},
    {"RowsWithTextBehind",
     with_field("length: 1 m, width: 1 m, exclude: [{rows: 3-5x, reason: x}]"), 5,
     "experiments[0].exclude[0].rows", "no range of rows"},
    {"ExclusionWithoutReason", with_field("length: 1 m, width: 1 m, exclude: [{rows: 3-5}]"), 5,
     "experiments[0].exclude[0].reason", "is missing"},
    {"TheSameNameTwice", with_experiment(std::string(kWeightsEntry) + "\n  - " + kWeightsEntry), 5,
     "experiments[1].name", "called \"w\""},
    {"ANameThatIsNoFileName", with_experiment("{name: ../w, type: shear-cycles, data: w.csv}"), 4,
     "experiments[0].name", "no name for an experiment"},
    {"ValidationOfNothing", study_with_more("validate:\n  - \"w*\"\n  - \"*-2cm\"\n"), 7,
     "validate[1]", "\"*-2cm\" matches no experiment"},
    {"APatternWithoutFiles", with_experiment("{name: w, type: shear-cycles, data: \"none-*.csv\"}"),
     4, "experiments[0].data", "matches no file"},
    {"BoundsBackwards", study_with_more("fit: {bounds: {\"*.k1\": [2, 1]}}\n"), 5,
     "fit.bounds.*.k1", "is no interval"},
    {"PriorWithoutSpread", study_with_more("fit: {priors: {\"*.k1\": {mean: 1, sd: 0}}}\n"), 5,
     "fit.priors.*.k1.sd", "is not positive"},
    {"TextForAFlag", with_field("length: 1 m, width: 1 m, rested: maybe"), 5,
     "experiments[0].rested", "true or false"},
    // Nothing is ignored silently: a field that means nothing to the type is refused.
    {"TransverseTensionOfAStrip", with_field("length: 1 m, width: 1 m, transverse_tension: 9 N/m"),
     5, "experiments[0].transverse_tension", "transverse_tension"},
    {"ClipOfShear",
     with_experiment("{name: s, type: shear-cycles, data: s.csv,\n  clip_mass: 2 g}"), 5,
     "experiments[0].clip_mass", "clip_mass"},
    {"ApparatusFrictionOfWeights", with_field("length: 1 m, width: 1 m, apparatus_friction: 0.1 N"),
     5, "experiments[0].apparatus_friction", "apparatus_friction"},
    {"LengthOfACantilever",
     with_experiment("{name: c, type: cantilever, direction: warp, data: c.csv,\n  length: 1 m}"),
     5, "experiments[0].length", "unknown key"},
    {"RolledStripWithoutLength",
     with_experiment("{name: r, type: rolled-strip, direction: warp, data: r.csv}"), 4,
     "experiments[0].length", "is missing"},
    {"ForceNoiseOfAProfile",
     with_experiment("{name: c, type: cantilever, direction: warp, data: c.csv,\n"
                     "     noise: {force: 1 N}}"),
     5, "experiments[0].noise.force", "unknown key"},
    {"InitialFrictionOfARolledStrip",
     with_experiment("{name: r, type: rolled-strip, direction: warp, data: r.csv, length: 1 m,\n"
                     "     initial_friction: unknown}"),
     5, "experiments[0].initial_friction", "initial_friction"},
    {"PositionNoiseOfWeights", with_field("length: 1 m, width: 1 m, noise: {position: 0.1 mm}"), 5,
     "experiments[0].noise.position", "unknown key"},
    {"AnAngleOf90Degrees",
     with_experiment("{name: l, type: bending-length, direction: warp, data: l.csv,\n"
                     "     angle: 90 deg}"),
     5, "experiments[0].angle", "is 90 degrees or more"},
    {"ANegativeAngle",
     with_experiment("{name: l, type: bending-length, direction: warp, data: l.csv,\n"
                     "     angle: -41.5 deg}"),
     5, "experiments[0].angle", "is not positive"},
    {"LengthOfABendingLength",
     with_experiment("{name: l, type: bending-length, direction: warp, data: l.csv,\n"
                     "     length: 1 m}"),
     5, "experiments[0].length", "unknown key"},
    {"PositionNoiseOfAnOverhang",
     with_experiment("{name: l, type: bending-length, direction: warp, data: l.csv,\n"
                     "     noise: {position: 1 mm}}"),
     5, "experiments[0].noise.position", "unknown key"},
    {"BendingWithoutDirection", with_experiment("{name: b, type: pure-bending, data: b.csv}"), 4,
     "experiments[0].direction", "is missing"},
    {"ForceNoiseOfAMoment",
     with_experiment("{name: b, type: pure-bending, direction: warp, data: b.csv,\n"
                     "     noise: {force: 1 mN}}"),
     5, "experiments[0].noise.force", "unknown key"},
    {"ClipMassOfBending",
     with_experiment("{name: b, type: pure-bending, direction: warp, data: b.csv,\n"
                     "     clip_mass: 2 g}"),
     5, "experiments[0].clip_mass", "clip_mass"},
    {"BucklingWithoutASide",
     with_experiment("{name: b, type: buckling-bend, direction: warp, data: b.csv, length: 2 cm,\n"
                     "     width: 4 cm}"),
     4, "experiments[0].side", "is missing"},
    {"BucklingToAnUnknownSide",
     with_experiment("{name: b, type: buckling-bend, direction: warp, data: b.csv, length: 2 cm,\n"
                     "     width: 4 cm, side: left}"),
     5, "experiments[0].side", "expected \"down\" or \"up\""},
    {"BucklingWithoutLength",
     with_experiment("{name: b, type: buckling-bend, direction: warp, data: b.csv, side: up}"), 4,
     "experiments[0].length", "is missing"},
    {"InitialFrictionOfABuckledStrip",
     with_experiment("{name: b, type: buckling-bend, direction: warp, data: b.csv, length: 2 cm,\n"
                     "     width: 4 cm, side: up, initial_friction: unknown}"),
     5, "experiments[0].initial_friction", "initial_friction"},
    {"UnknownInitialFrictionOfWeights",
     with_field("length: 1 m, width: 1 m, initial_friction: unknown"), 5,
     "experiments[0].initial_friction", "initial_friction"},
};

INSTANTIATE_TEST_SUITE_P(Of, StudyRefusal, ::testing::ValuesIn(kRefusals), test::name_of_refusal);

}  // namespace
}  // namespace pliant
