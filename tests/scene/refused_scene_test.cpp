// Scenes that cannot be used are refused with file, line and field.

#include <string>

#include <gtest/gtest.h>

#include "pliant/scene/scene.h"

#include "io/temporary_folder.h"
#include "scene/scene_text.h"
#include "support/refusal.h"

namespace pliant {
namespace {

using test::name_of_refusal;
using test::Refusal;
using test::with_cloth;
using test::with_mesh;
using test::with_more;
using test::with_time;

class SceneRefusal : public ::testing::TestWithParam<Refusal> {};

TEST_P(SceneRefusal, NamesFileLineAndField) {
  const test::TemporaryFolder folder;
  folder.write("jersey.json", test::kJersey);
  folder.write(
      "rubber.json",
      R"({"pliant": "material/1", "name": "rubber", "kind": "solid", "density": 1000, "components": {"I1": {"addends": [{"law": "linear", "c": 1e5}]}}})");
  folder.write("shirt.obj", "");
  const auto path = folder.write("scene.yaml", GetParam().text);
  expect_refused(GetParam(), path, read_scene);
}

std::string with_pin(const std::string& pin) { return with_more("pins:\n  - " + pin + "\n"); }

std::string with_clip(const std::string& more) {
  return with_more("clips:\n  - {name: c, cloth: sheet, vertices: [0], mass: 1 g,\n     " + more +
                   "}\n");
}

std::string with_motion(const std::string& motion) {
  return with_pin("{cloth: sheet, vertices: [0],\n     motion: " + motion + "}");
}

constexpr const char* kFree = "free: true, cords: [";

const Refusal kDocumentRefusals[] = {
    {"UnknownVersion", "pliant: scene/2\n", 1, "pliant", "unknown version \"2\""},
    {"AnotherDocument", "pliant: lab/1\n", 1, "pliant", "scene/1"},
    {"NoCloth", "pliant: scene/1\n", 1, "cloth", "is missing"},
    {"AnEmptyListOfCloths", "pliant: scene/1\ncloth: []\n", 2, "cloth", "has no cloth"},
    {"UnknownKey", with_more("gravitiy: [0, 0, -9.81]\n"), 5, "gravitiy",
     "did you mean \"gravity\"?"},
    {"GravityOfTwoNumbers", with_more("gravity: [0, -9.81]\n"), 5, "gravity", "has 2 numbers"},
    {"GravityAsOneNumber", with_more("gravity: -9.81\n"), 5, "gravity", "a list of numbers"},
    {"AnObstacleOfAFileThatIsNotThere",
     with_more("obstacles: [{name: a, mesh: {file: floor.obj, unit: m}}]\n"), 5,
     "obstacles[0].mesh.file", "does not exist"},
    {"AnObstacleThatBeginsElsewhere",
     with_more("obstacles: [{name: a, sphere: {centre: [0, 0, -1], radius: 0.5 m},\n"
               "  motion: {keyframes: [{time: 0 s, translate: [0, 0, 1]}]}}]\n"),
     6, "obstacles[0].motion", "begins elsewhere"},
    {"AFlatBox", with_more("obstacles: [{name: a, box: {centre: [0, 0, -1], size: [1, 1, 0]}}]\n"),
     5, "obstacles[0].box.size", "has no extent"},
    {"AnObstacleWithoutShape", with_more("obstacles: [{name: a}]\n"), 5, "obstacles[0]",
     "has no shape"},
    {"APlaneWithoutDirection",
     with_more("obstacles: [{name: a, plane: {point: [0, 0, 0], normal: [0, 0, 0]}}]\n"), 5,
     "obstacles[0].plane.normal", "has no direction"},
    {"NegativeFriction",
     with_more("obstacles: [{name: a, sphere: {centre: [0, 0, -1], radius: 1 m}, friction: -1}]\n"),
     5, "obstacles[0].friction", "is negative"},
    {"KineticFrictionAboveStatic",
     with_more("obstacles: [{name: a, sphere: {centre: [0, 0, -1], radius: 1 m},\n"
               "  friction: {static: 0.2, kinetic: 0.3}}]\n"),
     6, "obstacles[0].friction.kinetic", "exceeds the static"},
    {"FrictionOfGlue",
     with_more("obstacles: [{name: a, sphere: {centre: [0, 0, -1], radius: 1 m}, friction: 50}]\n"),
     5, "obstacles[0].friction", "more than any fabric has"},
    {"AContactOfNothing", with_more("contact: {thickness: 1 um}\n"), 5, "contact.thickness",
     "no thickness of a contact"},
    {"NegativeFrictionOfClothOnItself", with_more("contact: {friction: -0.6}\n"), 5,
     "contact.friction", "is negative"},
    {"AirWithoutDrag", with_more("air: {wind: [1, 0, 0]}\n"), 5, "air.drag", "is missing"},
    {"NegativeDrag", with_more("air: {drag: -1}\n"), 5, "air.drag", "is negative"},
    {"AirOfNoMass", with_more("air: {drag: 1, density: 0 kg/m^3}\n"), 5, "air.density",
     "is not positive"},
    {"NegativeDamping", with_more("damping: {fraction: -0.1}\n"), 5, "damping.fraction",
     "is negative"},
};

const Refusal kClothRefusals[] = {
    {"NoName", with_cloth("{mesh: {grid: 1 m x 1 m, nodes: 2x2}, material: jersey.json}"), 4,
     "cloth[0].name", "is missing"},
    {"TheSameNameTwice",
     with_more("  - {name: sheet, mesh: {grid: 1 m x 1 m, nodes: 2x2}, material: jersey.json}\n"),
     5, "cloth[1].name", "called \"sheet\""},
    {"ANameThatIsNoFileName", with_cloth("{name: a/b, mesh: {}, material: jersey.json}"), 4,
     "cloth[0].name", "is no name for a cloth"},
    {"NoMesh", with_cloth("{name: a, material: jersey.json}"), 4, "cloth[0].mesh", "is missing"},
    {"AMeshOfNothing", with_mesh("{nodes: 2x2}"), 4, "cloth[0].mesh",
     "one of `file`, `grid`, `rectangle` and `tube`"},
    {"ATubeOfTwoVerticesAround", with_mesh("{tube: 10 cm x 10 cm, nodes: 2x5}"), 4,
     "cloth[0].mesh.nodes", "makes no tube"},
    {"AnOddTubeOfAlternatingDiagonals", with_mesh("{tube: 10 cm x 10 cm, nodes: 7x5}"), 4,
     "cloth[0].mesh.nodes", "is odd around the tube"},
    {"NoiseWithoutAmplitude",
     with_cloth("{name: a, material: jersey.json, mesh: {grid: 1 m x 1 m, nodes: 2x2},\n"
                "   noise: {seed: 1}}"),
     5, "cloth[0].noise.amplitude", "is missing"},
    {"TwoMeshes", with_mesh("{grid: 1 m x 1 m, nodes: 2x2, file: shirt.obj, unit: m}"), 4,
     "cloth[0].mesh", "is not one mesh"},
    {"AMeshFileWithoutUnit", with_mesh("{file: shirt.obj}"), 4, "cloth[0].mesh.unit",
     "is missing; expected the length unit of the file's coordinates"},
    {"AUnitOfMass", with_mesh("{file: shirt.obj, unit: kg}"), 4, "cloth[0].mesh.unit", "mm"},
    {"AMeshFileThatIsNotThere", with_mesh("{file: skirt.obj, unit: m}"), 4, "cloth[0].mesh.file",
     "does not exist"},
    {"UnknownUpAxis", with_mesh("{file: shirt.obj, unit: m, up: w}"), 4, "cloth[0].mesh.up",
     "\"w\""},
    {"UvScaleOfAShape", with_mesh("{file: shirt.obj, unit: m, rest: shape, uv_scale: 1 m}"), 4,
     "cloth[0].mesh.uv_scale", "`rest: uv`"},
    {"UnitOfAGrid", with_mesh("{grid: 1 m x 1 m, nodes: 2x2, unit: m}"), 4, "cloth[0].mesh.unit",
     "unknown key"},
    {"AGridOfOneLength", with_mesh("{grid: 1 m, nodes: 2x2}"), 4, "cloth[0].mesh.grid",
     "WIDTH x HEIGHT"},
    {"AGridWithoutUnits", with_mesh("{grid: 1x1, nodes: 2x2}"), 4, "cloth[0].mesh.grid",
     "has no unit"},
    {"AGridOfNoWidth", with_mesh("{grid: 0 m x 1 m, nodes: 2x2}"), 4, "cloth[0].mesh.grid",
     "is not positive"},
    {"AGridWithoutNodes", with_mesh("{grid: 1 m x 1 m}"), 4, "cloth[0].mesh.nodes", "is missing"},
    {"AGridOfOneNode", with_mesh("{grid: 1 m x 1 m, nodes: 1x5}"), 4, "cloth[0].mesh.nodes",
     "from 2"},
    {"NodesThatAreNoNumbers", with_mesh("{grid: 1 m x 1 m, nodes: 5 x y}"), 4,
     "cloth[0].mesh.nodes", "\"5 x y\""},
    {"AGridTooFine", with_mesh("{grid: 1 m x 1 m, nodes: 9999x9999}"), 4, "cloth[0].mesh.nodes",
     "1e+08 vertices"},
    {"UnknownDiagonals", with_mesh("{grid: 1 m x 1 m, nodes: 2x2, diagonals: alternating}"), 4,
     "cloth[0].mesh.diagonals", "did you mean \"alternate\"?"},
    {"ARectangleWithoutEdgeLength", with_mesh("{rectangle: 1 m x 1 m}"), 4, "cloth[0].mesh.edge",
     "is missing"},
    {"AnEdgeLongerThanTheRectangle", with_mesh("{rectangle: 1 m x 10 mm, edge: 2 cm}"), 4,
     "cloth[0].mesh.edge", "longer than a side"},
    {"ARectangleTooFine", with_mesh("{rectangle: 1 m x 1 m, edge: 1 um}"), 4, "cloth[0].mesh.edge",
     "vertices"},
    {"NoMaterial", with_cloth("{name: a, mesh: {grid: 1 m x 1 m, nodes: 2x2}}"), 4,
     "cloth[0].material", "is missing"},
    {"AMaterialThatIsNotThere",
     with_cloth("{name: a, mesh: {grid: 1 m x 1 m, nodes: 2x2}, material: wool.json}"), 4,
     "cloth[0].material", "does not exist"},
    {"AMaterialForAnotherKindOfBody",
     with_cloth("{name: a, mesh: {grid: 1 m x 1 m, nodes: 2x2}, material: rubber.json}"), 4,
     "cloth[0].material", "expected one of the kind `cloth`"},
    {"ARadiusOfZero",
     with_cloth("{name: a, mesh: {grid: 1 m x 1 m, nodes: 2x2}, material: jersey.json,\n"
                "   shape: {cylinder: {radius: 0 mm, axis: u}}}"),
     5, "cloth[0].shape.cylinder.radius", "is not positive"},
    {"ARegionWithoutFaces",
     with_cloth("{name: a, mesh: {grid: 1 m x 1 m, nodes: 2x2}, material: jersey.json,\n"
                "   regions: [{material: jersey.json, faces: []}]}"),
     5, "cloth[0].regions[0].faces", "is empty"},
    {"AnAxisOfNoLength",
     with_cloth("{name: a, mesh: {grid: 1 m x 1 m, nodes: 2x2}, material: jersey.json,\n"
                "   place: {rotate: {axis: [0, 0, 0], angle: 9 deg}}}"),
     5, "cloth[0].place.rotate.axis", "has no direction"},
};

const Refusal kPinRefusals[] = {
    {"OfAnUnknownCloth", with_pin("{cloth: shet, vertices: [0]}"), 6, "pins[0].cloth",
     "there is no cloth \"shet\" (did you mean \"sheet\"?)"},
    {"OfNoCloth", with_pin("{vertices: [0]}"), 6, "pins[0].cloth", "is missing"},
    {"OfNothing", with_pin("{cloth: sheet}"), 6, "pins[0]", "`groups` or `within`"},
    {"OfNoVertices", with_pin("{cloth: sheet, vertices: []}"), 6, "pins[0].vertices", "is empty"},
    {"OfANegativeVertex", with_pin("{cloth: sheet, vertices: [0, -1]}"), 6, "pins[0].vertices[1]",
     "\"-1\""},
    {"OfAFileThatIsNotThere", with_pin("{cloth: sheet, vertices: left.txt}"), 6, "pins[0].vertices",
     "does not exist"},
    {"OfAnUnknownEdge", with_pin("{cloth: sheet, edges: [upper]}"), 6, "pins[0].edges[0]",
     "\"top\""},
    {"OfAnUnknownCorner", with_pin("{cloth: sheet, corners: [topleft]}"), 6, "pins[0].corners[0]",
     "did you mean \"top-left\"?"},
    {"OfABoxInsideOut",
     with_pin("{cloth: sheet, within: {box: {low: [1, 0, 0], high: [0, 1, 1]}}}"), 6,
     "pins[0].within.box", "is empty"},
    {"OfAnEdgeOfAMeshFile",
     with_mesh("{file: shirt.obj, unit: m}") + "pins: [{cloth: sheet, edges: [top]}]\n", 5,
     "pins[0].edges", "comes from a file"},
    {"InNoDirection", with_pin("{cloth: sheet, vertices: [0], directions: []}"), 6,
     "pins[0].directions", "is empty"},
    {"TwiceInOneDirection", with_pin("{cloth: sheet, vertices: [0], directions: [z, z]}"), 6,
     "pins[0].directions[1]", "twice"},
    {"MovedByNoKeyframes", with_motion("{keyframes: []}"), 7, "pins[0].motion.keyframes",
     "is empty"},
    {"MovedByKeyframesOutOfOrder", with_motion("{keyframes: [{time: 1 s},\n      {time: 500 ms}]}"),
     8, "pins[0].motion.keyframes[1].time", "500 ms comes after 1 s: keyframes out of order"},
    {"MovedByTwoKeyframesAtOneTime", with_motion("{keyframes: [{time: 1 s}, {time: 1000 ms}]}"), 7,
     "pins[0].motion.keyframes[1].time", "strictly increase"},
    {"MovedByAKeyframeWithoutTime", with_motion("{keyframes: [{translate: [0, 0, 1]}]}"), 7,
     "pins[0].motion.keyframes[0].time", "is missing"},
    {"MovedByAQuaternionOfThreeNumbers",
     with_motion("{keyframes: [{time: 0 s, rotate: {quaternion: [1, 0, 0]}}]}"), 7,
     "pins[0].motion.keyframes[0].rotate.quaternion", "has 3 numbers"},
    {"MovedByAnAngleWithoutUnit",
     with_motion("{keyframes: [{time: 0 s, rotate: {axis: [1, 0, 0], angle: 90}}]}"), 7,
     "pins[0].motion.keyframes[0].rotate.angle", "deg"},
    {"MovedByUnknownInterpolation", with_motion("{keyframes: [{time: 0 s}], interpolation: cubic}"),
     7, "pins[0].motion.interpolation", "\"smooth\""},
};

const Refusal kClipRefusals[] = {
    {"WithoutMass", with_more("clips: [{name: c, cloth: sheet, vertices: [0]}]"), 5,
     "clips[0].mass", "is missing"},
    {"OfNoMass", with_more("clips: [{name: c, cloth: sheet, vertices: [0], mass: 0 g}]"), 5,
     "clips[0].mass", "is not positive"},
    {"OfASecondName",
     with_more("clips:\n  - {name: c, cloth: sheet, vertices: [0], mass: 1 g}\n"
               "  - {name: c, cloth: sheet, vertices: [1], mass: 1 g}"),
     7, "clips[1].name", "called \"c\""},
    {"ThatIsFreeAndMoved", with_clip("free: true, motion: {keyframes: [{time: 0 s}]}"), 7,
     "clips[0].motion", "free"},
    {"ThatIsHeldAndPulled", with_clip("cords: [{vertex: 0, force: [0, 0, 1]}]"), 7,
     "clips[0].cords", "`free: true`"},
    {"PulledNowhere", with_clip(std::string(kFree) + "{force: [0, 0, 1]}]"), 7, "clips[0].cords[0]",
     "either `at` or `vertex`"},
    {"PulledAtTwoPoints",
     with_clip(std::string(kFree) + "{vertex: 0, at: [0, 0, 0], force: [0, 0, 1]}]"), 7,
     "clips[0].cords[0]", "either `at` or `vertex`"},
    {"PulledByNothing", with_clip(std::string(kFree) + "{vertex: 0}]"), 7, "clips[0].cords[0]",
     "either `force`, or `end`, `length` and `stiffness`"},
    {"PulledByAForceAndACord",
     with_clip(std::string(kFree) + "{vertex: 0, force: [0, 0, 1], end: [0, 0, 1]}]"), 7,
     "clips[0].cords[0].end", "unknown key"},
    {"PulledByACordOfNoStiffness",
     with_clip(std::string(kFree) + "{vertex: 0, end: [0, 0, 1], length: 1 m, stiffness: 0 N/m}]"),
     7, "clips[0].cords[0].stiffness", "is not positive"},
};

const Refusal kTimeRefusals[] = {
    {"ThatIsMissing",
     "pliant: scene/1\ncloth: [{name: a, mesh: {grid: 1 m x 1 m, nodes: 2x2}, "
     "material: jersey.json}]\n",
     1, "time", "is missing"},
    {"WithoutUnit", with_time("{step: 0.005, duration: 1 s}"), 2, "time.step", "ms"},
    {"WithAStepOfZero", with_time("{step: 0 s, duration: 1 s}"), 2, "time.step", "is not positive"},
    {"NotLongerThanTheStep", with_time("{step: 1 s, duration: 1000 ms}"), 2, "time.duration",
     "is not longer than the step"},
    {"OfTooManySteps", with_time("{step: 1 us, duration: 1000 h}"), 2, "time.step",
     "3.6e+12 steps"},
    {"WithoutDuration", with_time("{step: 1 s}"), 2, "time.duration", "is missing"},
    {"WithAnUnknownIntegrator", with_time("{step: 1 s, duration: 9 s, integrator: bdf}"), 2,
     "time.integrator", "did you mean \"bdf2\"?"},
    {"WithAToleranceOfALinearizedStep",
     with_time("{step: 1 s, duration: 9 s, solve: linearized, tolerance: 1 uN}"), 2,
     "time.tolerance", "unknown key"},
    {"WithAForceToleranceOfAnIteratedStep",
     with_time("{step: 1 s, duration: 9 s, solve: iterated, tolerance: 1 uN}"), 2, "time.tolerance",
     "unknown key"},
    {"WithAMotionToleranceOfAConvergedStep",
     with_time("{step: 1 s, duration: 9 s, tolerance: 1 uN, motion_tolerance: 1 um}"), 2,
     "time.motion_tolerance", "unknown key"},
    {"WithAMotionToleranceInNewtons",
     with_time("{step: 1 s, duration: 9 s, motion_tolerance: 1 uN}"), 2, "time.motion_tolerance",
     "um"},
    {"WithALinearToleranceOfOne",
     with_time("{step: 1 s, duration: 9 s, solve: linearized, linear_tolerance: 1}"), 2,
     "time.linear_tolerance", "between 0 and 1"},
    {"WithAToleranceOfZero", with_time("{step: 1 s, duration: 9 s, tolerance: 0 N}"), 2,
     "time.tolerance", "is not positive"},
    {"OfNoQuasiStaticSteps", with_time("{kind: quasi-static, steps: 0, duration: 1 s}"), 2,
     "time.steps", "\"0\""},
    {"OfAnIntegratedQuasiStaticPath",
     with_time("{kind: quasi-static, steps: 9, duration: 1 s, integrator: bdf2}"), 2,
     "time.integrator", "unknown key"},
    {"OfADampedQuasiStaticPath",
     with_time("{kind: quasi-static, steps: 9, duration: 1 s}", "damping: {fraction: 1}"), 3,
     "damping", "quasi-static"},
    {"OfAQuasiStaticThrow",
     "pliant: scene/1\ntime: {kind: quasi-static, steps: 9, duration: 1 s}\ncloth:\n"
     "  - {name: a, mesh: {grid: 1 m x 1 m, nodes: 2x2}, material: jersey.json,\n"
     "     velocity: [0, 0, 1]}\n",
     4, "cloth[0].velocity", "quasi-static"},
    {"OfFramesBetweenSteps", with_more("output: {every: 12 ms}"), 5, "output.every",
     "12 ms is no multiple of the step"},
    {"OfFramesWithinAStep", with_more("output: {every: 1 us}"), 5, "output.every",
     "is no multiple of the step"},
    {"OfNoSecondFrame", with_more("output: {every: 2 s}"), 5, "output.every",
     "longer than the simulation"},
    {"OfFramesInNoFormat", with_more("output: {formats: []}"), 5, "output.formats", "is empty"},
    {"OfFramesInAnUnknownFormat", with_more("output: {formats: [plt]}"), 5, "output.formats[0]",
     "did you mean \"ply\"?"},
    {"OfFramesInAFormatTwice", with_more("output: {formats: [ply, ply]}"), 5, "output.formats[1]",
     "twice"},
    {"OfUnknownFields", with_more("output: {fields: [stress]}"), 5, "output.fields[0]",
     "\"strain\""},
};

INSTANTIATE_TEST_SUITE_P(OfDocuments, SceneRefusal, ::testing::ValuesIn(kDocumentRefusals),
                         name_of_refusal);
INSTANTIATE_TEST_SUITE_P(OfCloth, SceneRefusal, ::testing::ValuesIn(kClothRefusals),
                         name_of_refusal);
INSTANTIATE_TEST_SUITE_P(OfPins, SceneRefusal, ::testing::ValuesIn(kPinRefusals), name_of_refusal);
INSTANTIATE_TEST_SUITE_P(OfClips, SceneRefusal, ::testing::ValuesIn(kClipRefusals),
                         name_of_refusal);
INSTANTIATE_TEST_SUITE_P(OfTime, SceneRefusal, ::testing::ValuesIn(kTimeRefusals), name_of_refusal);

}  // namespace
}  // namespace pliant
