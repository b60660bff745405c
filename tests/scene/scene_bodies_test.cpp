// What a scene says of cloths, pins and clips becomes their masses, materials, holds and motion.

#include <gtest/gtest.h>

#include "pliant/io/ply.h"
#include "pliant/scene/frame_files.h"
#include "pliant/scene/simulation.h"

#include "support/scene_simulation.h"

namespace pliant {
namespace {

using test::ClampedStrip;
using test::simulation_of;
using test::take_steps;
using test::way;

constexpr double kSheetMass = 0.002;  // kg: 0.2 kg/m^2, 100 mm wide and high
const Eigen::Vector3d kVelocity(1, 2, -2);

/// A sheet of 3 x 3 vertices that flies without weight.
/// @param more  further keys of the scene
std::string flying_sheet(const std::string& more = "", const std::string& integrator = "bdf2") {
  return "pliant: scene/1\n"
         "cloth:\n"
         "  - name: sheet\n"
         "    mesh: {grid: 100 mm x 100 mm, nodes: 3x3}\n"
         "    material: cloth.json\n"
         "    velocity: [1, 2, -2]\n"
         "gravity: [0, 0, 0]\n"
         "time: {step: 10 ms, duration: 1 s, tolerance: 1e-10 N, integrator: " +
         integrator + "}\n" + more;
}

double kinetic_energy(Simulation& simulation) {
  simulation.record_frame();
  return simulation.now().energies.back().kinetic;
}

void expect_flight(Simulation& simulation, double mass) {
  EXPECT_NEAR(kinetic_energy(simulation), mass * kVelocity.squaredNorm() / 2, 1e-15);
  take_steps(simulation, 5);
  // The tolerance over the mass of a vertex.
  EXPECT_LT((way(simulation).colwise() - 0.05 * kVelocity).norm(), 1e-8);
  EXPECT_LT((simulation.now().state.velocities.colwise() - kVelocity).norm(), 1e-7);
  EXPECT_NEAR(kinetic_energy(simulation), mass * kVelocity.squaredNorm() / 2, 1e-9);
}

TEST(SceneBodies, AClothFliesWithItsVelocityAndHalfItsMassTimesTheSquare) {
  for (const char* integrator : {"backward-euler", "bdf2"}) {
    Simulation sheet = simulation_of(flying_sheet("", integrator), ClampedStrip::material());
    expect_flight(sheet, kSheetMass);
  }
}

TEST(SceneBodies, AFreeClipFliesWithItsCloth) {
  for (const char* integrator : {"backward-euler", "bdf2"}) {
    Simulation sheet = simulation_of(
        flying_sheet("clips: [{name: clip, cloth: sheet, edges: [top], mass: 5 g, free: true,\n"
                     "  cords: [{at: [0.05, 0.12, 0], force: [0, 0, 0]}]}]\n",
                     integrator),
        ClampedStrip::material());
    expect_flight(sheet, kSheetMass + 0.005);
  }
}

TEST(SceneBodies, WhatIsHeldStartsAtRestWhereverItIsHeld) {
  const Simulation sheet =
      simulation_of(flying_sheet("pins:\n"
                                 "  - {cloth: sheet, corners: [bottom-left]}\n"
                                 "  - {cloth: sheet, corners: [bottom-right], directions: [z]}\n"
                                 "clips: [{name: held, cloth: sheet, edges: [top], mass: 5 g}]\n"),
                    ClampedStrip::material());
  Eigen::Matrix3Xd expected = kVelocity.replicate<1, 9>();
  expected.col(0).setZero();
  expected(2, 2) = 0;
  expected.rightCols<3>().setZero();
  EXPECT_EQ(sheet.now().state.velocities, expected);
}

TEST(SceneBodies, AClipAddsItsMassToWhatItHolds) {
  Simulation strip =
      simulation_of(ClampedStrip::scene(
                        "gravity: [0, 10, 0]\n"
                        "time: {kind: quasi-static, steps: 1, duration: 1 s, tolerance: 1e-9 N}\n"),
                    ClampedStrip::material());
  EXPECT_NEAR(strip.built().system->masses().sum(),
              ClampedStrip::kClipMass +
                  ClampedStrip::kDensity * ClampedStrip::kWidth * ClampedStrip::kLength,
              1e-15);
  take_steps(strip, 1);
  const double length = ClampedStrip::length(strip);
  EXPECT_GT(length, 1.05 * ClampedStrip::kLength);
  EXPECT_NEAR(ClampedStrip::elastic_pull(length), 10 * ClampedStrip::kMovingMass, 1e-8);
}

/// Two cells, one above the other, 100 mm wide and 200 mm high together, of which the upper one is
/// of another material; it is stretched by a fifth.
std::string patched_strip(const std::string& faces) {
  return "pliant: scene/1\n"
         "cloth:\n"
         "  - name: strip\n"
         "    mesh: {grid: 100 mm x 200 mm, nodes: 2x3}\n"
         "    material: cloth.json\n"
         "    regions: [{material: patch.json, faces: " +
         faces +
         "}]\n"
         "pins:\n"
         "  - {cloth: strip, edges: [bottom]}\n"
         "  - cloth: strip\n"
         "    edges: [top]\n"
         "    motion: {keyframes: [{time: 0 s}, {time: 1 s, translate: [0, 0.04, 0]}]}\n"
         "time: {kind: quasi-static, steps: 1, duration: 1 s, tolerance: 1e-9 N}\n"
         "gravity: [0, 0, 0]\n";
}

TEST(SceneBodies, ARegionHasTheDensityAndTheStiffnessOfItsMaterial) {
  Material patch = test::linear_cloth(3 * ClampedStrip::kStiffness, 10, 1e-5);
  patch.density = 0.5;
  for (const char* faces : {"[2, 3]", "upper.txt"}) {
    Simulation strip = simulation_of(patched_strip(faces),
                                     {{"cloth.json", material_text(ClampedStrip::material())},
                                      {"patch.json", material_text(patch)},
                                      {"upper.txt", "3, 2  # the upper cell\n"}});
    constexpr double kCell = 0.01;  // m^2, half of it at each side
    const Eigen::VectorXd& masses = strip.built().system->masses();
    EXPECT_NEAR(masses.head<2>().sum(), 0.2 * kCell / 2, 1e-15);
    EXPECT_NEAR(masses.segment<2>(2).sum(), (0.2 + 0.5) * kCell / 2, 1e-15);
    EXPECT_NEAR(masses.tail<2>().sum(), 0.5 * kCell / 2, 1e-15);

    take_steps(strip, 1);
    const double middle = strip.now().state.configuration.positions(1, 2);
    const auto pull = [](double stiffness, double stretch) {
      return 0.1 * stiffness * (stretch * stretch - 1) / 2 * stretch;
    };
    EXPECT_GT(middle, 0.12);  // the softer cell takes more than half
    EXPECT_NEAR(pull(ClampedStrip::kStiffness, middle / 0.1),
                pull(3 * ClampedStrip::kStiffness, (0.24 - middle) / 0.1), 1e-8);
  }
}

TEST(SceneBodies, EachOfTwoClothsHasItsOwnMaterialHoldsAndFaces) {
  constexpr double kStep = 0.02, kGravity = 10;
  Material heavy = test::linear_cloth(500, 500, 1e-3);
  heavy.density = 1.5;
  Simulation scene = simulation_of(
      "pliant: scene/1\n"
      "cloth:\n"
      "  - {name: flag, mesh: {grid: 10 mm x 10 mm, nodes: 2x2}, material: heavy.json}\n"
      "  - {name: strip, mesh: {grid: 40 mm x 100 mm, nodes: 3x2}, material: cloth.json}\n"
      "pins: [{cloth: strip, edges: [bottom]}]\n"
      "clips: [{name: weight, cloth: strip, edges: [top], mass: 10 g, free: true}]\n"
      "gravity: [0, 10, 0]\n"
      "time: {step: 20 ms, duration: 1 s, tolerance: 1e-10 N}\n",
      {{"cloth.json", material_text(ClampedStrip::material())},
       {"heavy.json", material_text(heavy)}});
  EXPECT_NEAR(scene.built().system->masses().head<4>().sum(), 1.5 * 1e-4, 1e-15);
  EXPECT_EQ(scene.built().vertices, 10);
  ASSERT_EQ(scene.built().faces.cols(), 6);
  EXPECT_LT(scene.built().faces.leftCols<2>().maxCoeff(), 4);
  EXPECT_GE(scene.built().faces.rightCols<4>().minCoeff(), 4);

  take_steps(scene, 1);
  const Eigen::Matrix3Xd way = test::way(scene);
  EXPECT_LT((way.row(1).head<4>().array() - kGravity * kStep * kStep).abs().maxCoeff(), 1e-8);
  EXPECT_EQ(way.middleCols<3>(4).norm(), 0);
  const double moved = way(1, 4 + ClampedStrip::kTop);
  EXPECT_GT(moved, 1e-3);
  EXPECT_NEAR(ClampedStrip::kMovingMass * (moved / (kStep * kStep) - kGravity) +
                  ClampedStrip::elastic_pull(ClampedStrip::kLength + moved),
              0, 1e-9);
}

TEST(SceneBodies, PinsOfAFileHoldItsVerticesAndNoOther) {
  Simulation sheet = simulation_of(
      "pliant: scene/1\n"
      "cloth: [{name: sheet, mesh: {grid: 100 mm x 100 mm, nodes: 3x3}, material: cloth.json}]\n"
      "pins: [{cloth: sheet, vertices: held.txt}]\n"
      "time: {step: 10 ms, duration: 1 s}\n",
      {{"cloth.json", material_text(ClampedStrip::material())},
       {"held.txt", "0, 2  # corners\n7\n"}});
  take_steps(sheet, 1);
  for (int i = 0; i < 9; ++i) {
    const bool held = i == 0 || i == 2 || i == 7;
    EXPECT_EQ(way(sheet).col(i).norm() == 0, held) << i;
  }
}

TEST(SceneBodies, APinMovesItsVerticesAlongItsDirectionsAlone) {
  Simulation sheet = simulation_of(
      "pliant: scene/1\n"
      "cloth: [{name: sheet, mesh: {grid: 100 mm x 100 mm, nodes: 2x2}, material: cloth.json}]\n"
      "pins:\n"
      "  - cloth: sheet\n"
      "    vertices: [0, 1, 2, 3]\n"
      "    directions: [z]\n"
      "    motion: {keyframes: [{time: 0 s}, {time: 1 s, translate: [1, 1, 2]}]}\n"
      "gravity: [0, 10, 0]\n"
      "time: {step: 10 ms, duration: 1 s, tolerance: 1e-9 N}\n",
      ClampedStrip::material());
  take_steps(sheet, 2);
  const Eigen::Vector3d expected(0, 3 * 10 * 0.01 * 0.01, 0.02 * 2);
  EXPECT_LT((way(sheet).colwise() - expected).norm(), 1e-8);
}

/// The columns of the vertices in a frame of a strip that is stretched by a tenth.
std::map<std::string, std::vector<double>> columns(const std::string& fields) {
  Material material = ClampedStrip::material();
  material.components["stretch.warp"] =
      test::component(ScalarCurve::constant(ClampedStrip::kStiffness), DahlParameters{2, 0, 0.01});
  Simulation strip = simulation_of(
      "pliant: scene/1\n"
      "cloth: [{name: strip, mesh: {grid: 40 mm x 100 mm, nodes: 3x2}, material: cloth.json}]\n"
      "pins:\n"
      "  - {cloth: strip, edges: [bottom]}\n"
      "  - cloth: strip\n"
      "    edges: [top]\n"
      "    motion: {keyframes: [{time: 0 s}, {time: 1 s, translate: [0, 0.01, 0]}]}\n"
      "time: {kind: quasi-static, steps: 1, duration: 1 s}\n"
      "output: {fields: " +
          fields + "}\n",
      material);
  take_steps(strip, 1);
  const test::TemporaryFolder folder;
  const auto file = frame_files(strip, 1).front();
  std::map<std::string, std::vector<double>> columns;
  for (const PlyColumn& column : read_ply(folder.write(file.first, file.second)).vertex_columns) {
    columns[column.name] = column.values;
  }
  return columns;
}

TEST(SceneBodies, FieldsStrainWritesTheStrainsAlone) {
  const auto found = columns("[strain]");
  std::vector<std::string> names;
  for (const auto& [name, values] : found) names.push_back(name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"strain.bend.diagonal", "strain.bend.weft", "strain.shear",
                                      "strain.stretch.warp", "strain.stretch.weft"}));
  for (const double value : found.at("strain.stretch.warp")) {
    EXPECT_NEAR(value, (1.1 * 1.1 - 1) / 2, 1e-12);
  }
  for (const double value : found.at("strain.stretch.weft")) EXPECT_NEAR(value, 0, 1e-12);
}

TEST(SceneBodies, FieldsFrictionWritesTheFrictionStressesAlone) {
  const auto found = columns("[friction]");
  ASSERT_EQ(found.size(), 1u);
  // Saturated: the strain is ten times tau, and more.
  for (const double value : found.at("friction.stretch.warp")) EXPECT_NEAR(value, 2, 1e-4);
}

TEST(SceneBodies, FieldsNobodyAskedForAreNotWritten) { EXPECT_TRUE(columns("[]").empty()); }

}  // namespace
}  // namespace pliant
