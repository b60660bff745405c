// Reading scene/1 files.

#include "pliant/scene/scene.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/temporary_folder.h"
#include "scene/scene_text.h"

namespace pliant {
namespace {

using Eigen::Vector3d;
using test::read_scene_text;
using test::with_cloth;
using test::with_mesh;
using test::with_more;
using test::with_time;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kDegree = std::numbers::pi / 180;

TEST(Scene, NeedsNoMoreThanClothAndTime) {
  const Scene scene = read_scene_text(with_more(""));
  EXPECT_EQ(scene.name, "scene") << "as the file";
  ASSERT_EQ(scene.cloth.size(), 1U);
  EXPECT_EQ(scene.cloth[0].material.material.name, "jersey");
  EXPECT_EQ(scene.gravity, Vector3d(0, 0, -kStandardGravity));
  EXPECT_FALSE(scene.air);
  EXPECT_FALSE(scene.damping_fraction);
  EXPECT_THAT(scene.pins, IsEmpty());
  EXPECT_THAT(scene.clips, IsEmpty());
}

TEST(Scene, ReadsWhatActsOnAllOfIt) {
  const Scene scene =
      read_scene_text(with_more("name: curtain\ninfo: {shot: 12}\ngravity: [0, -9.81, 0]\n"
                                "air: {drag: 1.1, density: 1.3 kg/m^3, wind: [2, 0, 0]}\n"
                                "damping: {fraction: 0.02}\nobstacles: []\n"));
  EXPECT_EQ(scene.name, "curtain");
  EXPECT_EQ(scene.info.at("shot"), "12");
  EXPECT_EQ(scene.gravity, Vector3d(0, -9.81, 0));
  ASSERT_TRUE(scene.air);
  EXPECT_DOUBLE_EQ(scene.air->drag, 1.1);
  EXPECT_DOUBLE_EQ(scene.air->density, 1.3);
  EXPECT_EQ(scene.air->wind, Vector3d(2, 0, 0));
  EXPECT_DOUBLE_EQ(scene.damping_fraction.value(), 0.02);
}

TEST(SceneCloth, MayBeAGrid) {
  const Scene scene =
      read_scene_text(with_mesh("{grid: 10cm x 50 mm, nodes: 21 x 11, diagonals: falling}"));
  const auto& grid = std::get<GridMesh>(scene.cloth[0].mesh.kind);
  EXPECT_DOUBLE_EQ(grid.width, 0.1);
  EXPECT_DOUBLE_EQ(grid.height, 0.05);
  EXPECT_EQ(grid.nodes_u, 21);
  EXPECT_EQ(grid.nodes_v, 11);
  EXPECT_EQ(grid.diagonals, Diagonals::falling);
  EXPECT_TRUE(scene.cloth[0].mesh.is_rectangle());
}

TEST(SceneCloth, HasAlternatingDiagonalsUnlessItSaysOtherwise) {
  const Scene scene = read_scene_text(with_more(""));
  EXPECT_EQ(std::get<GridMesh>(scene.cloth[0].mesh.kind).diagonals, Diagonals::alternating);
}

TEST(SceneCloth, MayBeAnIrregularRectangle) {
  const Scene scene = read_scene_text(with_mesh("{rectangle: 100 mm x 50 mm, edge: 5 mm}"));
  const auto& rectangle = std::get<RectangleMesh>(scene.cloth[0].mesh.kind);
  EXPECT_DOUBLE_EQ(rectangle.width, 0.1);
  EXPECT_DOUBLE_EQ(rectangle.edge, 0.005);
  EXPECT_TRUE(scene.cloth[0].mesh.is_rectangle());
}

TEST(SceneCloth, MayBeATube) {
  const Scene scene = read_scene_text(with_mesh("{tube: 25 cm x 20 cm, nodes: 48x41}"));
  const auto& tube = std::get<TubeMesh>(scene.cloth[0].mesh.kind);
  EXPECT_DOUBLE_EQ(tube.circumference, 0.25);
  EXPECT_DOUBLE_EQ(tube.length, 0.2);
  EXPECT_EQ(tube.nodes_around, 48);
  EXPECT_EQ(tube.nodes_along, 41);
  EXPECT_EQ(tube.diagonals, Diagonals::alternating);
  EXPECT_FALSE(scene.cloth[0].mesh.is_rectangle());
}

TEST(SceneCloth, MayComeFromAFile) {
  const Scene scene =
      read_scene_text(with_mesh("{file: shirt.obj, unit: cm, up: -y, rest: uv, uv_scale: 1.27 m}"));
  const auto& file = std::get<FileMesh>(scene.cloth[0].mesh.kind);
  EXPECT_EQ(file.file.filename(), "shirt.obj");
  EXPECT_DOUBLE_EQ(file.options.unit, 0.01);
  EXPECT_EQ(file.options.up, "-y");
  EXPECT_EQ(file.options.rest, RestShape::uv);
  EXPECT_DOUBLE_EQ(file.options.uv_scale.value(), 1.27);
  EXPECT_FALSE(scene.cloth[0].mesh.is_rectangle());
}

TEST(SceneCloth, TakesTheRestShapeOfAnObjFileFromItsTextureCoordinates) {
  const Scene scene = read_scene_text(with_mesh("{file: shirt.obj, unit: m}"));
  EXPECT_EQ(std::get<FileMesh>(scene.cloth[0].mesh.kind).options.rest, RestShape::uv);
  EXPECT_EQ(std::get<FileMesh>(scene.cloth[0].mesh.kind).options.up, "z");
}

TEST(SceneCloth, IsShapedPlacedAndThrown) {
  const Scene scene = read_scene_text(
      with_cloth("{name: a, mesh: {grid: 1 m x 1 m, nodes: 2x2}, material: jersey.json,\n"
                 "   regions: [{material: jersey.json, faces: [1]}],\n"
                 "   shape: {cylinder: {radius: 20 mm, axis: diagonal, side: back, pitch: 2 mm}},\n"
                 "   noise: {amplitude: 1 um, seed: 3},\n"
                 "   place: {rotate: {axis: [2, 0, 0], angle: 90 deg}, translate: [0, 0, 1]},\n"
                 "   velocity: [0, 1, 0]}"));
  const SceneCloth& cloth = scene.cloth[0];
  EXPECT_THAT(cloth.regions.at(0).faces.numbers, ElementsAre(1));
  EXPECT_DOUBLE_EQ(cloth.shape->radius, 0.02);
  EXPECT_EQ(cloth.shape->axis, CylinderAxis::diagonal);
  EXPECT_TRUE(cloth.shape->towards_back);
  EXPECT_DOUBLE_EQ(cloth.shape->pitch, 0.002);
  EXPECT_DOUBLE_EQ(cloth.noise.amplitude, 1e-6);
  EXPECT_EQ(cloth.noise.seed, 3);
  EXPECT_LT((cloth.place.apply({0, 1, 0}) - Vector3d(0, 0, 2)).norm(), 1e-15);
  EXPECT_EQ(cloth.velocity, Vector3d(0, 1, 0));
}

TEST(ScenePin, HoldsStillInEveryDirectionUnlessItSaysOtherwise) {
  const Scene scene = read_scene_text(with_more("pins: [{cloth: sheet, vertices: [0]}]"));
  EXPECT_THAT(scene.pins.at(0).directions, ElementsAre(true, true, true));
  EXPECT_FALSE(scene.pins[0].motion);
}

TEST(ScenePin, MovesAlongItsKeyframes) {
  const Scene scene = read_scene_text(with_more(
      "pins:\n  - cloth: sheet\n    corners: [top-left]\n    directions: [z]\n    motion:\n"
      "      pivot: [0, 0, 1]\n      interpolation: smooth\n      keyframes:\n"
      "        - {time: 0 s}\n        - {time: 500 ms, translate: [0, 0, 0.1]}\n"
      "        - {time: 1 s, rotate: {quaternion: [2, 0, 0, 0]}}\n"));
  const ScenePin& pin = scene.pins.at(0);
  EXPECT_THAT(pin.directions, ElementsAre(false, false, true));
  ASSERT_TRUE(pin.motion);
  EXPECT_THAT(pin.motion->times, ElementsAre(0, 0.5, 1));
  EXPECT_EQ(pin.motion->interpolation, Interpolation::smooth);
  EXPECT_EQ(pin.motion->pivot, Vector3d(0, 0, 1));
  EXPECT_EQ(pose_at(*pin.motion, 0.5).translation, Vector3d(0, 0, 0.1));
  EXPECT_EQ(pose_at(*pin.motion, 1).translation, Vector3d(0, 0, 0));
}

TEST(ScenePin, TurnsWholeTurnsByAngles) {
  const Scene scene = read_scene_text(
      with_more("pins: [{cloth: sheet, vertices: [0], motion: {keyframes: [{time: 0 s},\n"
                "  {time: 1 s, rotate: {axis: [0, 0, 3], angle: 360 deg}}]}}]"));
  EXPECT_NEAR(scene.pins.at(0).motion->keyframes[1].turn.z(), 360 * kDegree, 1e-14);
}

TEST(SceneClip, IsABodyThatCordsPull) {
  const Scene scene = read_scene_text(with_more(
      "clips:\n"
      "  - {name: left, cloth: sheet, edges: [left], mass: 10.1 g, free: true, cords: [\n"
      "      {at: [0, 0.05, 0], force: [-0.1, 0, 0]},\n"
      "      {vertex: 3, force: {interpolation: smooth, keyframes: [{time: 0 s, value: [0, 0, 0]},"
      " {time: 1 s, value: [0, 0, 2]}]}},\n"
      "      {vertex: 0, end: [0, 0, 1], length: 90 cm, stiffness: 500 N/m}]}\n"
      "  - {name: right, cloth: sheet, edges: [right], mass: 10 g, motion: {keyframes: [{time: 1 "
      "s}]}}\n"
      "  - {name: held, cloth: sheet, vertices: [1], mass: 10 g}\n"));
  ASSERT_EQ(scene.clips.size(), 3U);
  const SceneClip& clip = scene.clips[0];
  EXPECT_DOUBLE_EQ(clip.mass, 0.0101);
  EXPECT_TRUE(clip.free);
  ASSERT_EQ(clip.cords.size(), 3U);
  EXPECT_FALSE(clip.cords[0].vertex);
  EXPECT_EQ(clip.cords[0].at, Vector3d(0, 0.05, 0));
  EXPECT_EQ(value_at(clip.cords[0].force.value(), 7), Vector3d(-0.1, 0, 0));
  EXPECT_EQ(clip.cords[1].vertex, 3);
  EXPECT_EQ(value_at(clip.cords[1].force.value(), 0.5), Vector3d(0, 0, 1));
  EXPECT_FALSE(clip.cords[2].force);
  EXPECT_EQ(value_at(clip.cords[2].spring.end, 0), Vector3d(0, 0, 1));
  EXPECT_DOUBLE_EQ(clip.cords[2].spring.length, 0.9);
  EXPECT_DOUBLE_EQ(clip.cords[2].spring.stiffness, 500);
  EXPECT_TRUE(scene.clips[1].motion);
  EXPECT_FALSE(scene.clips[2].motion);
  EXPECT_FALSE(scene.clips[2].free) << "held still";
}

TEST(SceneTime, IteratesBackwardEulerWithVariationalFrictionUnlessItSaysOtherwise) {
  const Stepping time = read_scene_text(with_more("")).time;
  EXPECT_EQ(time.kind, SimulationKind::dynamic);
  EXPECT_DOUBLE_EQ(time.step, 0.005);
  EXPECT_DOUBLE_EQ(time.duration, 1);
  EXPECT_EQ(time.integrator, Integrator::backward_euler);
  EXPECT_EQ(time.solution, StepSolve::iterated);
  EXPECT_FALSE(time.motion_tolerance.has_value());
  EXPECT_EQ(time.friction, FrictionForm::variational);
  EXPECT_FALSE(time.adaptive);
  EXPECT_FALSE(time.tolerance.has_value());
}

TEST(SceneTime, ConvergesWhereItStatesTheForcesThatAStepMayLeave) {
  const auto stepping = [](const std::string& more) {
    return read_scene_text(with_time("{step: 1 ms, duration: 1 s" + more + "}")).time;
  };
  const Stepping old = stepping(", tolerance: 20 uN");
  EXPECT_EQ(old.solution, StepSolve::converged);
  EXPECT_DOUBLE_EQ(old.tolerance.value(), 2e-5);
  const Stepping iterated = stepping(", solve: iterated, motion_tolerance: 20 um");
  EXPECT_EQ(iterated.solution, StepSolve::iterated);
  EXPECT_DOUBLE_EQ(iterated.motion_tolerance.value(), 2e-5);
}

TEST(SceneTime, ReadsEveryField) {
  const Stepping time =
      read_scene_text(with_time("{kind: dynamic, step: 1 ms, duration: 50 ms, integrator: bdf2,\n"
                                "  solve: linearized, friction: linearized, adaptive: true,\n"
                                "  linear_tolerance: 1e-5}"))
          .time;
  EXPECT_EQ(time.integrator, Integrator::bdf2);
  EXPECT_EQ(time.solution, StepSolve::linearized);
  EXPECT_EQ(time.friction, FrictionForm::linearized);
  EXPECT_TRUE(time.adaptive);
  EXPECT_DOUBLE_EQ(time.linear_tolerance, 1e-5);
  EXPECT_EQ(time.step_count(), 50);
}

TEST(SceneTime, MayLeaveFrictionOut) {
  const Stepping time =
      read_scene_text(with_time("{step: 1 ms, duration: 1 s, friction: none}")).time;
  EXPECT_FALSE(time.friction.has_value());
}

TEST(SceneTime, EndsWithAWholeStep) {
  EXPECT_EQ(read_scene_text(with_time("{step: 15 ms, duration: 2 s}")).time.step_count(), 134);
  EXPECT_EQ(read_scene_text(with_time("{step: 30 ms, duration: 3 s}")).time.step_count(), 100);
}

TEST(SceneTime, IsTheParameterOfAQuasiStaticPath) {
  const Scene scene =
      read_scene_text(with_time("{kind: quasi-static, steps: 20, duration: 2 s, tolerance: 1 uN}"));
  EXPECT_EQ(scene.time.kind, SimulationKind::quasi_static);
  EXPECT_EQ(scene.time.step_count(), 20);
  EXPECT_DOUBLE_EQ(scene.time.step, 0.1);
  EXPECT_EQ(scene.time.tolerance, 1e-6);
  EXPECT_EQ(steps_per_frame(scene.output, scene.time), 1) << "every equilibrium is written";
}

TEST(SceneOutput, IsAPlyFileEachFortyMillisecondsUnlessItSaysOtherwise) {
  const Scene scene = read_scene_text(with_more(""));
  EXPECT_THAT(scene.output.formats, ElementsAre(FrameFormat::ply));
  EXPECT_THAT(scene.output.fields, IsEmpty());
  EXPECT_DOUBLE_EQ(scene.output.every, 0.04);
  EXPECT_EQ(steps_per_frame(scene.output, scene.time), 8);
}

TEST(SceneOutput, FallsOnStepsOfItsOwn) {
  EXPECT_DOUBLE_EQ(read_scene_text(with_time("{step: 15 ms, duration: 1 s}")).output.every, 0.045);
  EXPECT_DOUBLE_EQ(read_scene_text(with_time("{step: 1 ms, duration: 5 ms}")).output.every, 0.005);
  EXPECT_DOUBLE_EQ(read_scene_text(with_time("{step: 50 ms, duration: 1 s}")).output.every, 0.05);
}

TEST(SceneOutput, ReadsEveryField) {
  const Scene scene = read_scene_text(
      with_more("output: {every: 10 ms, formats: [vtu, pc2, ply], fields: [friction, strain]}"));
  EXPECT_DOUBLE_EQ(scene.output.every, 0.01);
  EXPECT_THAT(scene.output.formats,
              ElementsAre(FrameFormat::vtu, FrameFormat::pc2, FrameFormat::ply));
  EXPECT_THAT(scene.output.fields, ElementsAre(FrameField::friction, FrameField::strain));
  EXPECT_EQ(steps_per_frame(scene.output, scene.time), 2);
}

TEST(SceneOutput, MayFallBetweenAdaptiveSteps) {
  const Scene scene = read_scene_text(
      with_time("{step: 5 ms, duration: 1 s, adaptive: true}", "output: {every: 12 ms}"));
  EXPECT_DOUBLE_EQ(scene.output.every, 0.012);
}

}  // namespace
}  // namespace pliant
