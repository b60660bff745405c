// Reading lab/1 files.

#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/experiment/bending/pure_bending_type.h"
#include "pliant/experiment/buckling/buckling_bend_type.h"
#include "pliant/experiment/session/session_type.h"
#include "pliant/experiment/shear/shear_cycles_type.h"
#include "pliant/study/virtual_lab.h"

#include "io/temporary_folder.h"
#include "support/refusal.h"
#include "support/virtual_strips.h"

namespace pliant {
namespace {

using test::experiment_of;
using test::Refusal;
using test::TemporaryFolder;
using ::testing::ElementsAre;

constexpr const char* kMaterial =
    R"({"pliant": "material/1", "name": "jersey", "kind": "cloth", "density": 0.15,
 "components": {"stretch.warp": {"stiffness": {"curve": "constant", "value": 30}},
                "stretch.weft": {"stiffness": {"curve": "constant", "value": 30}},
                "shear": {"stiffness": {"curve": "constant", "value": 3}},
                "bend.warp": {"stiffness": {"curve": "constant", "value": 1e-5}},
                "stretch.bias": {"status": "unmeasured"}}})";

constexpr const char* kLab = R"(pliant: lab/1
material: jersey.json
specimens: 2
specimen_variation: 3 %
experiments:
  - {name: warp-weights, type: hanging-weights, direction: warp, length: 10 cm, width: 9 cm, clip_mass: 20 g,
     peaks: [1 N, 2 N], step: 0.5 N, repeats: 3, noise: {length: 0.2 mm}, resolution: {length: 0.5 mm}}
  - {name: weft, type: tensile-cycles, direction: weft, peaks: [5 %, 10 %], slack: 1 mm, samples: 50,
     noise: {force: 5 mN, length: 10 um}, resolution: {force: 1 mN, length: 10 um}}
  - {name: shear, type: shear-cycles, peaks: [8 deg], transverse_tension: 9.8 N/m, noise: {force: 0.1 N/m}}
  - {name: bending, type: pure-bending, direction: warp, peaks: [1 1/cm, 250 1/m], noise: {moment: 0.001 gf cm/cm},
     resolution: {moment: 1 uN}}
  - {name: overhangs, type: cantilever, direction: warp, overhangs: [4 cm, 80 mm], points: 11}
  - {name: rolls, type: rolled-strip, direction: warp, length: 12 cm, radii: [5 mm, -1 cm], repeats: 2,
     noise: {position: 0.1 mm}, resolution: {position: 10 um}}
  - {name: published, type: rolled-strip, direction: warp}
  - {name: lengths, type: bending-length, direction: warp, angle: 45 deg, repeats: 3, noise: {overhang: 0.5 mm},
     resolution: {overhang: 1 mm}}
  - {name: standard, type: bending-length, direction: warp}
validate: ["weft*"]
)";

VirtualLab read_lab_text(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("jersey.json", kMaterial);
  return read_lab(folder.write("lab.yaml", text));
}

TEST(LabFile, ReadsEveryField) {
  const VirtualLab lab = read_lab_text(kLab);
  EXPECT_EQ(lab.name, "jersey");
  EXPECT_EQ(lab.specimens, 2);
  EXPECT_DOUBLE_EQ(lab.specimen_variation, 0.03);
  EXPECT_THAT(lab.validate, ElementsAre("weft*"));
  ASSERT_EQ(lab.experiments.size(), 9U);
  const auto& hung = experiment_of<VirtualHangingWeights>(lab, 0);
  EXPECT_DOUBLE_EQ(hung.length, 0.1);
  EXPECT_DOUBLE_EQ(hung.width, 0.09);
  EXPECT_DOUBLE_EQ(hung.clip_mass, 0.02);
  EXPECT_THAT(hung.peaks, ElementsAre(1, 2));
  EXPECT_DOUBLE_EQ(hung.step, 0.5);
  EXPECT_EQ(hung.repeats, 3);
  EXPECT_DOUBLE_EQ(hung.instrument.length_noise, 2e-4);
  EXPECT_DOUBLE_EQ(hung.instrument.length_resolution, 5e-4);
  const auto& pulled = experiment_of<VirtualTensileCycles>(lab, 1);
  EXPECT_THAT(pulled.peaks, ElementsAre(0.05, 0.1));
  EXPECT_DOUBLE_EQ(pulled.slack, 1e-3);
  EXPECT_EQ(pulled.samples, 50);
  EXPECT_DOUBLE_EQ(pulled.instrument.force_noise, 5e-3);
  EXPECT_DOUBLE_EQ(pulled.instrument.force_resolution, 1e-3);
  const auto& sheared = experiment_of<VirtualShearCycles>(lab, 2);
  EXPECT_DOUBLE_EQ(sheared.peaks[0], 8 * std::numbers::pi / 180);
  EXPECT_DOUBLE_EQ(sheared.transverse_tension, 9.8);
  const auto& bent = experiment_of<VirtualPureBending>(lab, 3);
  EXPECT_THAT(bent.peaks, ElementsAre(100, 250));
  EXPECT_DOUBLE_EQ(bent.instrument.force_noise, 9.80665e-6);
  EXPECT_DOUBLE_EQ(bent.instrument.force_resolution, 1e-6);
  const auto& overhangs = experiment_of<VirtualCantilever>(lab, 4);
  EXPECT_THAT(overhangs.settings, ElementsAre(0.04, 0.08));
  EXPECT_EQ(overhangs.points, 11);
  EXPECT_EQ(overhangs.repeats, 1);
  const auto& rolled = experiment_of<VirtualRolledStrip>(lab, 5);
  EXPECT_DOUBLE_EQ(rolled.length, 0.12);
  EXPECT_THAT(rolled.settings, ElementsAre(0.005, -0.01));
  EXPECT_EQ(rolled.repeats, 2);
  EXPECT_DOUBLE_EQ(rolled.instrument.length_noise, 1e-4);
  EXPECT_DOUBLE_EQ(rolled.instrument.length_resolution, 1e-5);
  const auto& lengths = experiment_of<VirtualBendingLength>(lab, 7);
  EXPECT_DOUBLE_EQ(lengths.angle, std::numbers::pi / 4);
  EXPECT_EQ(lengths.repeats, 3);
  EXPECT_DOUBLE_EQ(lengths.instrument.length_noise, 5e-4);
  EXPECT_DOUBLE_EQ(lengths.instrument.length_resolution, 1e-3);
  const auto& standard = experiment_of<VirtualBendingLength>(lab, 8);
  EXPECT_DOUBLE_EQ(standard.angle, 41.5 * std::numbers::pi / 180);
  EXPECT_EQ(standard.repeats, 2);
}

TEST(LabFile, ReadsABuckledStripAndTheErrorsOfItsTester) {
  const VirtualLab lab = read_lab_text(
      "pliant: lab/1\nmaterial: jersey.json\nexperiments:\n"
      "  - {name: b, type: buckling-bend, direction: warp, length: 21 mm, width: 4 cm, side: up,\n"
      "     slack: 1 mm, strip_length: 20.8 mm, force_offset: -10 mN, force_drift: 1 mN,\n"
      "     peaks: [15 %, 40 %], noise: {force: 0.1 mN}}\n"
      "  - {name: d, type: buckling-bend, direction: warp, length: 20 mm, side: down, peaks: [30 "
      "%]}\n");
  const auto& up = experiment_of<VirtualBucklingBend>(lab, 0);
  EXPECT_EQ(up.side, BucklingSide::up);
  EXPECT_DOUBLE_EQ(up.slack, 1e-3);
  EXPECT_DOUBLE_EQ(up.strip_length, 0.0208);
  EXPECT_DOUBLE_EQ(up.force_offset, -0.01);
  EXPECT_DOUBLE_EQ(up.force_drift, 1e-3);
  EXPECT_THAT(up.peaks, ElementsAre(0.15, 0.4));
  EXPECT_DOUBLE_EQ(up.instrument.force_noise, 1e-4);
  const auto& down = experiment_of<VirtualBucklingBend>(lab, 1);
  EXPECT_DOUBLE_EQ(down.strip_length, 0.02);
  EXPECT_DOUBLE_EQ(down.slack, 4e-4);
}

TEST(LabFile, ReadsASession) {
  const TemporaryFolder folder;
  folder.write("cloth.json", test::content_of(PLIANT_SOURCE_DIR "/examples/assumed-cloth.json"));
  const VirtualLab lab = read_lab(folder.write(
      "lab.yaml",
      "pliant: lab/1\nmaterial: cloth.json\nexperiments:\n"
      "  - {name: f, type: session, test: shear, size: 8 cm x 12 cm, frames: 21, cycles: 3,\n"
      "     angle: 20 deg, initial_strain: 1 %, grip: 4 mm, clip_mass: 5 g, mesh: {nodes: 9x13},\n"
      "     noise: {position: 75 um, force: 3 mN}, cord_friction: 0.1 N}\n"
      "  - {name: b, type: session, test: bias-extension}\n"));
  const VirtualSession& frame = experiment_of<VirtualSessionTest>(lab, 0).session;
  EXPECT_EQ(frame.test, "shear");
  EXPECT_DOUBLE_EQ(frame.width, 0.08);
  EXPECT_DOUBLE_EQ(frame.height, 0.12);
  EXPECT_EQ(frame.frames, 21);
  EXPECT_EQ(frame.cycles, 3);
  EXPECT_DOUBLE_EQ(frame.amplitude, std::numbers::pi / 9);
  EXPECT_DOUBLE_EQ(frame.initial_strain, 0.01);
  EXPECT_DOUBLE_EQ(frame.grip, 4e-3);
  EXPECT_DOUBLE_EQ(frame.clip_mass, 5e-3);
  EXPECT_EQ(frame.nodes, std::pair(9, 13));
  EXPECT_DOUBLE_EQ(frame.noise.position, 75e-6);
  EXPECT_DOUBLE_EQ(frame.noise.force, 3e-3);
  EXPECT_DOUBLE_EQ(frame.noise.cord_friction, 0.1);
  const VirtualSession& strip = experiment_of<VirtualSessionTest>(lab, 1).session;
  EXPECT_DOUBLE_EQ(strip.height, 0.15);
  EXPECT_DOUBLE_EQ(strip.amplitude, 0.1);
  EXPECT_DOUBLE_EQ(strip.clip_mass, 10.1e-3) << "[T] Table 3.1";
  EXPECT_FALSE(strip.nodes.has_value());
}

TEST(LabFile, ReadsCamerasWithTheirLightAndNoise) {
  const TemporaryFolder folder;
  folder.write("cloth.json", test::content_of(PLIANT_SOURCE_DIR "/examples/assumed-cloth.json"));
  const VirtualLab lab = read_lab(folder.write(
      "lab.yaml",
      "pliant: lab/1\nmaterial: cloth.json\n"
      "cameras: {count: 3, picture: 640x480, pixel: 0.2 mm, distance: 400 mm, angle: 30 deg, blur: "
      "1.2,\n"
      "  read_noise: 0.5 %, shot_noise: 2 %, bits: 12, gloss: 30 %, boards: 8, cell_noise: 1 mN,\n"
      "  log_start: 2.5 s}\n"
      "experiments: [{name: f, type: session, test: shear}]\n"));
  ASSERT_TRUE(lab.cameras);
  const VirtualCameras& cameras = *lab.cameras;
  EXPECT_EQ(cameras.count, 3);
  EXPECT_EQ(cameras.columns, 640);
  EXPECT_EQ(cameras.rows, 480);
  EXPECT_DOUBLE_EQ(cameras.pixel, 0.2e-3);
  EXPECT_DOUBLE_EQ(cameras.distance, 0.4);
  EXPECT_DOUBLE_EQ(cameras.angle, std::numbers::pi / 6);
  EXPECT_DOUBLE_EQ(cameras.blur, 1.2);
  EXPECT_DOUBLE_EQ(cameras.read_noise, 0.005);
  EXPECT_DOUBLE_EQ(cameras.shot_noise, 0.02);
  EXPECT_EQ(cameras.bits, 12);
  EXPECT_DOUBLE_EQ(cameras.gloss, 0.3);
  EXPECT_EQ(cameras.boards, 8);
  EXPECT_DOUBLE_EQ(cameras.cell_noise, 1e-3);
  EXPECT_DOUBLE_EQ(cameras.log_start, 2.5);
}

TEST(LabFile, NeedsAGridForASessionOfSprings) {
  const TemporaryFolder folder;
  std::string cloth = test::content_of(PLIANT_SOURCE_DIR "/examples/assumed-cloth.json");
  cloth.replace(cloth.find("stvk"), 4, "spring");
  folder.write("cloth.json", cloth);
  const auto lab_with = [&](const std::string& mesh) {
    return folder.write("lab.yaml",
                        "pliant: lab/1\nmaterial: cloth.json\nexperiments:\n"
                        "  - {name: s, type: session, test: shear, mesh: {" +
                            mesh + "}}\n");
  };
  EXPECT_EQ(read_lab(lab_with("nodes: 9x9")).experiments.size(), 1U);
  const InputError error = test::input_error_of([&] { read_lab(lab_with("edge: 5 mm")); });
  EXPECT_EQ(error.where().line, 4);
  EXPECT_THAT(error.problem(), ::testing::HasSubstr("need a grid"));
}

// [P] 4.3: twelve cylinders from 3 to 50 mm, three times each.
TEST(LabFile, RollsAroundThePublishedCylindersByDefault) {
  const VirtualLab lab = read_lab_text(kLab);
  const auto& rolled = experiment_of<VirtualRolledStrip>(lab, 6);
  ASSERT_EQ(rolled.settings.size(), 12u);
  EXPECT_DOUBLE_EQ(rolled.settings.front(), 0.003);
  EXPECT_DOUBLE_EQ(rolled.settings.back(), 0.05);
  EXPECT_EQ(rolled.repeats, 3);
}

TEST(LabFile, NeedsTheDensityOfAStripThatHangs) {
  const TemporaryFolder folder;
  folder.write("light.json", R"({"pliant": "material/1", "name": "light", "kind": "cloth",
    "components": {"bend.warp": {"stiffness": {"curve": "constant", "value": 1e-5}}}})");
  const auto lab = folder.write("lab.yaml",
                                "pliant: lab/1\nmaterial: light.json\nexperiments:\n"
                                "  - {name: r, type: rolled-strip, direction: warp}\n");
  const InputError error = test::input_error_of([&] { read_lab(lab); });
  EXPECT_EQ(error.where().line, 4);
  EXPECT_THAT(error.problem(), ::testing::HasSubstr("needs the density"));
}

class LabFileRefusal : public ::testing::TestWithParam<Refusal> {};

TEST_P(LabFileRefusal, NamesFileLineAndField) {
  const TemporaryFolder folder;
  folder.write("jersey.json", kMaterial);
  expect_refused(GetParam(), folder.write("lab.yaml", GetParam().text), read_lab);
}

/// A lab with experiments from line 4 on.
std::string with_experiments(const std::string& list) {
  return "pliant: lab/1\nmaterial: jersey.json\nexperiments:\n  - " + list + "\n";
}

const Refusal kRefusals[] = {
    {"UnknownKey", with_experiments("{name: w, type: shear-cycles, peaks: [8 deg], repeat: 2}"), 4,
     "experiments[0].repeat", "did you mean \"repeats\"?"},
    {"KeyOfAnotherType",
     with_experiments("{name: w, type: shear-cycles, peaks: [8 deg], slack: 1 mm}"), 4,
     "experiments[0].slack", "unknown key"},
    {"UnknownType", with_experiments("{name: w, type: shear-cycle, peaks: [8 deg]}"), 4,
     "experiments[0].type", "did you mean \"shear-cycles\"?"},
    {"PeakOfAnotherKind",
     with_experiments("{name: w, type: tensile-cycles, direction: warp, peaks: [8 deg]}"), 4,
     "experiments[0].peaks[0]", "%"},
    {"AfterNothing",
     with_experiments("{name: w, type: tensile-cycles, direction: warp, peaks: [5 %], after: v}"),
     4, "experiments[0].after", "names no such experiment"},
    {"NegativePeak",
     with_experiments("{name: w, type: tensile-cycles, direction: warp, peaks: [-5 %]}"), 4,
     "experiments[0].peaks[0]", "not positive"},
    {"NoOverhangs", with_experiments("{name: c, type: cantilever, direction: warp}"), 4,
     "experiments[0].overhangs", "is missing"},
    {"ZeroRadius",
     with_experiments("{name: r, type: rolled-strip, direction: warp, radii: [5 mm, 0 mm]}"), 4,
     "experiments[0].radii[1]", "is zero"},
    {"BucklingToNoSide",
     with_experiments(
         "{name: b, type: buckling-bend, direction: warp, length: 2 cm, peaks: [20 %]}"),
     4, "experiments[0].side", "is missing"},
    {"BucklingLessThanItsSlack",
     with_experiments("{name: b, type: buckling-bend, direction: warp, side: up, length: 10 cm,\n"
                      "     slack: 5 mm, peaks: [20 %, 4 %]}"),
     5, "experiments[0].peaks[1]", "is no approach"},
    {"BucklingOfAStripThatIsTaut",
     with_experiments("{name: b, type: buckling-bend, direction: warp, side: up, length: 10 cm,\n"
                      "     slack: 1 mm, strip_length: 98 mm, peaks: [20 %]}"),
     5, "experiments[0].strip_length", "is not above the distance"},
    {"FourPoints", with_experiments("{name: r, type: rolled-strip, direction: warp, points: 4}"), 4,
     "experiments[0].points", "5"},
    {"PeaksOfARolledStrip",
     with_experiments("{name: r, type: rolled-strip, direction: warp, peaks: [5 mm]}"), 4,
     "experiments[0].peaks", "unknown key"},
    {"ABendThatTheMaterialLacks",
     with_experiments("{name: r, type: rolled-strip, direction: weft}"), 4, "experiments[0]",
     "does not have"},
    {"AnAngleOf90Degrees",
     with_experiments("{name: l, type: bending-length, direction: warp, angle: 90 deg}"), 4,
     "experiments[0].angle", "is 90 degrees or more"},
    {"OverhangsOfABendingLength",
     with_experiments("{name: l, type: bending-length, direction: warp, overhangs: [5 mm]}"), 4,
     "experiments[0].overhangs", "unknown key"},
    {"NoPeaks", with_experiments("{name: w, type: shear-cycles, peaks: []}"), 4,
     "experiments[0].peaks", "is empty"},
    {"NegativeNoise",
     with_experiments("{name: w, type: shear-cycles, peaks: [8 deg], noise: {force: -1 N/m}}"), 4,
     "experiments[0].noise.force", "is negative"},
    {"ADirectionTheMaterialLacks",
     with_experiments("{name: w, type: tensile-cycles, direction: bias, peaks: [5 %]}"), 4,
     "experiments[0]", "does not have"},
    {"ForceNoiseOfAMoment",
     with_experiments(
         "{name: b, type: pure-bending, direction: warp, peaks: [1 1/cm], noise: {force: 1 uN}}"),
     4, "experiments[0].noise.force", "unknown key"},
    {"CurvatureThatIsARadius",
     with_experiments("{name: b, type: pure-bending, direction: warp, peaks: [4 mm]}"), 4,
     "experiments[0].peaks[0]", "1/cm"},
    {"ABendingTheMaterialLacks",
     with_experiments("{name: b, type: pure-bending, direction: weft, peaks: [1 1/cm]}"), 4,
     "experiments[0]", "does not have"},
    {"ANameThatIsNoFileName", with_experiments("{name: ../w, type: shear-cycles, peaks: [8 deg]}"),
     4, "experiments[0].name", "name"},
    {"SessionWithoutTest", with_experiments("{name: s, type: session}"), 4, "experiments[0].test",
     "is missing"},
    {"SessionOfAnotherTestsAmplitude",
     with_experiments("{name: s, type: session, test: shear, strain: 5 %}"), 4,
     "experiments[0].strain", "unknown key"},
    {"SessionWithFewerFramesThanTurns",
     with_experiments("{name: s, type: session, test: corner-pull, cycles: 2, frames: 8}"), 4,
     "experiments[0].frames", "at least 9"},
    {"SessionBeyondItsTable",
     with_experiments("{name: s, type: session, test: bend-weft, size: 8 cm x 20 cm,\n"
                      "     overhang: 75 mm}"),
     5, "experiments[0].overhang", "at most 72 mm"},
    {"SessionWithTwoMeshes",
     with_experiments("{name: s, type: session, test: shear, mesh: {edge: 2 mm, nodes: 20x20}}"), 4,
     "experiments[0].mesh", "either `edge`"},
    {"SessionWhoseNoiseLosesTheClips",
     with_experiments("{name: s, type: session, test: shear, noise: {position: 1 mm}}"), 4,
     "experiments[0].noise.position", "too much"},
    {"SessionNamedAsAFile", with_experiments("{name: study.yaml, type: session, test: shear}"), 4,
     "experiments[0].name", "file"},
    {"SessionOfAStrip", with_experiments("{name: s, type: session, test: shear}"), 4,
     "experiments[0]", "does not have: bend.weft"},
    {"ShotNoiseThatDrowns",
     with_experiments("{name: w, type: shear-cycles, peaks: [8 deg]}") +
         "cameras: {shot_noise: 20 %}\n",
     5, "cameras.shot_noise", "drowns the picture"},
    {"GlossBeyondTheLight",
     with_experiments("{name: w, type: shear-cycles, peaks: [8 deg]}") +
         "cameras: {gloss: 120 %}\n",
     5, "cameras.gloss", "more than the light"},
    {"TheSameNameTwice",
     with_experiments("{name: w, type: shear-cycles, peaks: [8 deg]}\n"
                      "  - {name: w, type: shear-cycles, peaks: [9 deg]}"),
     5, "experiments[1].name", "\"w\""},
};

INSTANTIATE_TEST_SUITE_P(Of, LabFileRefusal, ::testing::ValuesIn(kRefusals), test::name_of_refusal);

}  // namespace
}  // namespace pliant
