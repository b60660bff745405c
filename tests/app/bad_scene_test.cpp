// Scenes that cannot be simulated: status 2, one line that says where and what, nothing written.
// And one that cannot be solved.

#include <algorithm>
#include <cmath>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/io/ply.h"

#include "app/scene_folder.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kNet = R"({"pliant": "material/1", "name": "net", "kind": "cloth",
 "density": 0.1, "membrane": "stvk", "bending": "discrete-shells", "components": {
   "stretch.weft": {"stiffness": {"curve": "constant", "value": 30}},
   "stretch.warp": {"stiffness": {"curve": "constant", "value": 30}},
   "shear": {"stiffness": {"curve": "constant", "value": 10}},
   "bend.weft": {"stiffness": {"curve": "constant", "value": 1e-5}},
   "bend.warp": {"stiffness": {"curve": "constant", "value": 1e-5}},
   "bend.diagonal": {"stiffness": {"curve": "constant", "value": 1e-5}}}})";

// Line 4 is the cloth, line 5 what holds it, line 6 the time.
constexpr const char* kScene =
    "pliant: scene/1\n"
    "name: net\n"
    "cloth:\n"
    "  - {name: net, mesh: {grid: 100 mm x 100 mm, nodes: 5x5}, material: net.json}\n"
    "pins: [{cloth: net, corners: [top-left, top-right]}]\n"
    "time: {step: 5 ms, duration: 20 ms}\n";

constexpr const char* kGrid = "{grid: 100 mm x 100 mm, nodes: 5x5}";
constexpr const char* kPins = "pins: [{cloth: net, corners: [top-left, top-right]}]\n";

struct BadScene {
  std::string name;
  std::vector<TextEdit> scene, material;
  std::string mesh;  ///< content of mesh.obj
  std::string where;
  std::vector<std::string> says;

  friend void PrintTo(const BadScene& bad, std::ostream* out) { *out << bad.name; }
};

/// The scene with mesh.obj in place of its grid.
std::vector<TextEdit> with_file(const std::string& options) {
  return {{kGrid, "{file: mesh.obj" + options + "}"}, {kPins, ""}};
}

void expect_one_line(const ProgramRun& run, const BadScene& bad, const SceneFolder& folder) {
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, StartsWith("error: " + folder.file(bad.where) + ": "));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  for (const std::string& words : bad.says) EXPECT_THAT(run.err, HasSubstr(words));
  EXPECT_FALSE(std::filesystem::exists(folder.results())) << "a folder was made";
}

class RefusedScene : public ::testing::TestWithParam<BadScene> {};

TEST_P(RefusedScene, NamesFileLineAndReasonAndLeavesNothing) {
  const BadScene& bad = GetParam();
  const SceneFolder folder;
  const std::string scene = folder.write("scene.yaml", edited_text(kScene, bad.scene)).string();
  folder.write("net.json", edited_text(kNet, bad.material));
  folder.write("mesh.obj", bad.mesh);
  expect_one_line(run_program({"simulate", scene, "-o", folder.results().string()}), bad, folder);
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n";

const BadScene kBadScenes[] = {
    {"NonManifoldMesh",
     with_file(", unit: m, rest: shape"),
     {},
     kSquare + "f 1 2 3\nf 1 3 4\nf 1 3 5\n",
     "mesh.obj:6",
     {"vertices 1 and 3", "faces 1, 2, 3"}},
    {"DegenerateTriangle",
     with_file(", unit: m, rest: shape"),
     {},
     "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 3 4\nf 1 2 3\n",
     "mesh.obj:6",
     {"face 2", "no area"}},
    {"InvertedRestTriangle",
     with_file(", unit: m"),
     {},
     kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nvt 2 0.4\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n",
     "mesh.obj:11",
     {"face 2 runs clockwise at rest"}},
    {"PackedTextureCoordinates",
     with_file(", unit: m"),
     {},
     "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvt 0 0\nvt .3 0\nvt .3 .3\nvt 0 .3\n"
     "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n",
     "mesh.obj",
     {"uv_scale", "4 m^2", "0.09 m^2"}},
    {"MeshFileWithoutUnit",
     with_file(""),
     {},
     kSquare,
     "scene.yaml:4",
     {"cloth[0].mesh.unit: is missing"}},
    {"MaterialWithoutDensity",
     {},
     {{"\"density\": 0.1, ", ""}},
     "",
     "scene.yaml:4",
     {"cloth[0].material", "\"net\" has no density"}},
    {"ZeroStiffness",
     {},
     {{"\"value\": 10", "\"value\": 0"}},
     "",
     "scene.yaml:4",
     {"stiffness shear", "is 0"}},
    {"NegativeStiffness",
     {},
     {{"\"value\": 10", "\"value\": -1"}},
     "",
     "scene.yaml:4",
     {"stiffness shear", "is -1"}},
    {"StiffnessThatTurnsNegative",
     {},
     {{R"({"curve": "constant", "value": 10})", R"({"curve": "affine", "k1": 10, "k2": -100})"}},
     "",
     "scene.yaml:4",
     {"stiffness shear", "turns negative at strain 0.1", "a `range` of the component"}},
    {"VertexWithoutFaces",
     with_file(", unit: m, rest: shape"),
     {},
     kSquare + "f 1 2 3\nf 1 3 4\n",
     "mesh.obj:5",
     {"vertex 5 belongs to no triangle", "expected only vertices of faces"}},
    {"MaterialThatIsNoMaterialFile",
     {{"net.json", "scene.yaml"}},
     {},
     "",
     "scene.yaml:1",
     {"expected a material file"}},
    {"NumberThatOverflows",
     {},
     {{"\"value\": 10", "\"value\": 1e400"}},
     "",
     "net.json:5",
     {"components.shear.stiffness.value: \"1e400\" is not a finite number"}},
    {"NoDuration",
     {{", duration: 20 ms", ""}},
     {},
     "",
     "scene.yaml:6",
     {"time.duration: is missing; expected a time with its unit"}},
    {"PinOnAVertexThatIsNotThere",
     {{"corners: [top-left, top-right]", "vertices: [3, 25]"}},
     {},
     "",
     "scene.yaml:5",
     {"pins[0].vertices[1]", "no vertex 25"}},
    {"VertexThatIsHeldTwice",
     {{"corners: [top-left, top-right]}", "vertices: [1]}, {cloth: net, vertices: [1]}"}},
     {},
     "",
     "scene.yaml:5",
     {"vertex 1 is held twice"}},
    {"KeyframesOutOfOrder",
     {{"top-right]", "top-right], motion: {keyframes: [{time: 1 s}, {time: 10 ms}]}"}},
     {},
     "",
     "scene.yaml:5",
     {"pins[0].motion.keyframes[1].time", "out of order"}},
    {"StepOfZero",
     {{"step: 5 ms", "step: 0 ms"}},
     {},
     "",
     "scene.yaml:6",
     {"time.step: is not positive"}},
    {"MaterialForAnotherKindOfBody",
     {},
     {{"\"cloth\"", "\"solid\""}},
     "",
     "net.json:3",
     {"components.stretch.weft", "\"J\""}},
    {"SpringsOnAnIrregularMesh",
     {{kGrid, "{rectangle: 10 cm x 10 cm, edge: 2 cm}"}},
     {{"\"stvk\"", "\"spring\""}},
     "",
     "scene.yaml:4",
     {"the springs of \"net\" need a grid"}},
    {"UnmeasuredComponents",
     {},
     {{R"("shear": {"stiffness": {"curve": "constant", "value": 10}})",
       R"("shear": {"status": "unmeasured"})"}},
     "",
     "scene.yaml:4",
     {"shear of the material \"net\"", "was not measured", "--fill FILE"}},
    {"NoSuchMaterial",
     {{"net.json", "none.json"}},
     {},
     "",
     "scene.yaml:4",
     {"none.json", "does not exist"}},
};

INSTANTIATE_TEST_SUITE_P(Table, RefusedScene, ::testing::ValuesIn(kBadScenes),
                         [](const auto& bad) { return bad.param.name; });

TEST(RefusedFill, ThatDoesNotKnowTheComponentEither) {
  const SceneFolder folder;
  const auto scene = folder.write("scene.yaml", kScene);
  const std::string unmeasured =
      edited_text(kNet, {{R"("shear": {"stiffness": {"curve": "constant", "value": 10}})",
                          R"("shear": {"status": "unmeasured"})"}});
  folder.write("net.json", unmeasured);
  const ProgramRun run = run_program({"simulate", scene.string(), "-o", folder.results().string(),
                                      "--fill", folder.file("net.json")});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("shear of the material \"net\" was not measured"));
}

TEST(RefusedFill, ThatIsAScene) {
  const SceneFolder folder;
  folder.write("net.json", kNet);
  folder.write("scene.yaml", kScene);
  std::vector<std::string> command = folder.command();
  command[5] = folder.file("scene.yaml");
  const ProgramRun run = run_program(command);
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("expected a material file"));
}

TEST(RefusedFill, OfAnotherStrain) {
  const SceneFolder folder;
  folder.write("scene.yaml",
               edited_text(kScene, {{"net.json", PLIANT_SOURCE_DIR "/materials/cotton.json"}}));
  folder.write("soft.json", edited_text(kNet, {{"\"stvk\"", "\"soft-constraint\""}}));
  std::vector<std::string> command = folder.command();
  command[5] = folder.file("soft.json");
  const ProgramRun run = run_program(command);
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("`soft-constraint`; expected `stvk`"));
}

/// A corner of the net is still for 10 ms, and then torn away.
std::string torn_scene(const std::string& shift, const std::string& time) {
  return edited_text(
      kScene, {{kPins,
                "gravity: [0, 0, 0]\n"
                "pins: [{cloth: net, corners: [top-left], motion: {keyframes: [{time: 10 ms},\n"
                "  {time: 15 ms, translate: [" +
                    shift + ", 0, 0]}]}}]\n"},
               {"{step: 5 ms, duration: 20 ms}", time}});
}

void expect_no_nan(const SceneFolder& folder) {
  for (const auto& [name, bytes] : folder.computed_files()) {
    if (name.ends_with(".csv")) {
      EXPECT_THAT(bytes, AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf")))) << name;
    }
    if (!name.ends_with(".ply")) continue;
    for (const Point3& point : read_ply(folder.results() / name).positions) {
      for (const double x : point) EXPECT_TRUE(std::isfinite(x)) << name;
    }
  }
}

TEST(UnsolvableScene, StopsWithStepResidualAndTheLastGoodState) {
  const SceneFolder folder;
  folder.write("net.json", kNet);
  folder.write("scene.yaml",
               torn_scene("1000", "{step: 5 ms, duration: 20 ms, tolerance: 1e-10 N}"));
  for (const char* argument : {"--quiet", "--resume"}) {
    const ProgramRun run = folder.simulate({argument});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.last_line(),
                AllOf(StartsWith("error: the step to 0.015 s did not converge"),
                      HasSubstr("residual"), HasSubstr("checkpoint.bin (after step 2 of 4")));
    const json result = json::parse(content_of(folder.results() / "simulation.json"));
    EXPECT_EQ(result["finished"], false);
    EXPECT_EQ(result["steps"], 2);
    expect_no_nan(folder);
  }
}

TEST(SlowUnsolvableScene, NeverWritesNaN) {
  for (const char* time :
       {"{step: 5 ms, duration: 20 ms, solve: linearized}", "{step: 5 ms, duration: 20 ms}",
        "{step: 5 ms, duration: 20 ms, integrator: bdf2, adaptive: true}",
        "{kind: quasi-static, steps: 4, duration: 20 ms}"}) {
    for (const char* shift : {"1e4", "1e100", "1e200"}) {
      const SceneFolder folder;
      folder.write("net.json", kNet);
      folder.write("scene.yaml", torn_scene(shift, time));
      const ProgramRun run = folder.simulate({"--no-report"});
      EXPECT_THAT(run.status, ::testing::AnyOf(0, 1)) << time << " " << shift << ": " << run.err;
      expect_no_nan(folder);
    }
  }
}

TEST(SlowFallingStiffness, IsSimulatedBeyondItsRangeWithoutGainingEnergy) {
  const SceneFolder folder;
  folder.write(
      "net.json",
      edited_text(kNet, {{R"("stretch.warp": {"stiffness": {"curve": "constant", "value": 30}})",
                          R"("stretch.warp": {"stiffness": {"curve": "affine", "k1": 30,)"
                          R"( "k2": -100}, "range": [0, 0.02]})"}}));
  folder.write("scene.yaml", edited_text(kScene, {{"duration: 20 ms", "duration: 500 ms"}}) +
                                 "gravity: [0, 0, -300]\n");
  const ProgramRun run = folder.simulate();
  EXPECT_EQ(run.status, 0) << run.err;
  const json result = json::parse(content_of(folder.results() / "simulation.json"));
  EXPECT_EQ(result["finished"], true);
  expect_no_nan(folder);
}

}  // namespace
}  // namespace pliant::test
