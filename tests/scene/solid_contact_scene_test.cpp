// Solids that touch solids, cloth, themselves and bodies of meshes: nothing passes through, which
// an exact test tells that knows nothing of contact, what lies still carries its weight, and no
// energy is gained.

#include <string>

#include <gtest/gtest.h>

#include "pliant/geometry/block_mesh.h"
#include "pliant/geometry/crossings.h"
#include "pliant/geometry/volume_file.h"
#include "pliant/material/solid/standard_solids.h"

#include "support/cloth_sheet.h"
#include "support/scene_simulation.h"

namespace pliant {
namespace {

test::FileContents gel_and_cloth() {
  Material gel = neo_hookean_solid(1e4, 2e5);
  gel.name = "gel";
  gel.density = 1000;
  return {{"gel.json", material_text(gel)},
          {"cloth.json", material_text(test::linear_cloth(200, 80, 1e-5))}};
}

/// Steps to the end; after each no triangles cross, and no energy was gained.
void expect_apart(Simulation& simulation) {
  double total = INFINITY;
  while (!simulation.is_finished()) {
    simulation.advance();
    const auto crossing = crossing_triangles(simulation.now().state.configuration.positions,
                                             simulation.built().faces);
    if (crossing) {
      ASSERT_TRUE(crossing->empty()) << simulation.now().state.time;
    }
    simulation.record_frame();
    const double now = simulation.now().energies.back().total();
    EXPECT_LE(now, total + 1e-6) << simulation.now().state.time;
    total = now;
  }
}

/// Lowest and highest points of a solid (m).
std::pair<double, double> heights(const Simulation& simulation, std::size_t solid) {
  const SolidPiece& piece = simulation.built().solids[solid];
  const auto own = simulation.now().state.configuration.positions.middleCols(
      piece.first_point, piece.mesh.positions.cols());
  return {own.row(2).minCoeff(), own.row(2).maxCoeff()};
}

constexpr const char* kFloorAndTime =
    "obstacles: [{name: floor, plane: {point: [0, 0, 0], normal: [0, 0, 1]}, friction: 0.5}]\n"
    "contact: {thickness: 1 mm, friction: 0.5}\n"
    "damping: {fraction: 0.02}\ntime: {step: 5 ms, duration: 300 ms}\n";

TEST(SlowSolidContact, StacksSolidOnSolid) {
  Simulation simulation = test::simulation_of(
      std::string("pliant: scene/1\nsolids:\n"
                  "  - {name: lower, mesh: {block: [0.05, 0.05, 0.05], cells: [3, 3, 3]}, "
                  "material: gel.json, place: {translate: [0, 0, 0.0009]}}\n"
                  "  - {name: upper, mesh: {block: [0.03, 0.03, 0.03], cells: [2, 2, 2]}, "
                  "material: gel.json, place: {translate: [0.01, 0.01, 0.056]}}\n") +
          kFloorAndTime,
      gel_and_cloth());
  expect_apart(simulation);
  const auto lower = heights(simulation, 0), upper = heights(simulation, 1);
  EXPECT_GT(upper.first, 0.04);
  EXPECT_LT(upper.first - lower.second, 2e-3);
  EXPECT_LT(simulation.now().state.velocities.cwiseAbs().maxCoeff(), 0.1);
}

TEST(SlowSolidContact, CarriesClothOnASolid) {
  Simulation simulation = test::simulation_of(
      std::string("pliant: scene/1\nsolids:\n"
                  "  - {name: cube, mesh: {block: [0.06, 0.06, 0.06], cells: [4, 4, 4]}, "
                  "material: gel.json, place: {translate: [0.02, 0.02, 0.0009]}}\n"
                  "cloth:\n"
                  "  - {name: sheet, mesh: {grid: 100 mm x 100 mm, nodes: 11x11}, material: "
                  "cloth.json, place: {translate: [0, 0, 0.065]}}\n") +
          kFloorAndTime,
      gel_and_cloth());
  expect_apart(simulation);
  // The middle lies on the cube, the corners hang down beside it.
  const Eigen::Matrix3Xd& x = simulation.now().state.configuration.positions;
  const double top = heights(simulation, 0).second;
  double highest = 0, lowest = 1;
  for (const ClothPiece& piece : simulation.built().cloths) {
    const auto own = x.middleCols(piece.first_point, piece.mesh.vertex_count());
    highest = own.row(2).maxCoeff();
    lowest = own.row(2).minCoeff();
  }
  EXPECT_GT(highest, top - 1e-3);
  EXPECT_LT(lowest, top - 0.002);
}

// A clamp of gel whose upper arm sinks onto its lower one.
TEST(SlowSolidContact, StopsASolidOnItself) {
  test::FileContents files = gel_and_cloth();
  const VolumeMesh block = block_of_tetrahedra({0.12, 0.02, 0.03}, {12, 2, 6});
  VolumeMesh clamp;
  clamp.positions = block.positions;
  std::vector<int> kept;
  for (int e = 0; e < block.tetrahedron_count(); ++e) {
    const Eigen::Vector3d middle =
        block.positions(Eigen::all, block.tetrahedra.col(e)).rowwise().mean();
    const bool is_gap = middle.x() > 0.01 && middle.z() > 0.01 && middle.z() < 0.015;
    if (!is_gap) kept.push_back(e);
  }
  clamp.tetrahedra = block.tetrahedra(Eigen::all, kept);
  files["clamp.msh"] = volume_file_text(clamp, "clamp.msh");
  Simulation simulation = test::simulation_of(
      std::string(
          "pliant: scene/1\nsolids:\n"
          "  - {name: clamp, mesh: {file: clamp.msh, unit: m}, material: gel.json, place: "
          "{translate: [0, 0, 0.0009]}}\n"
          "pins: [{solid: clamp, within: {box: {low: [-1, -1, -1], high: [1, 1, 0.006]}}}]\n") +
          kFloorAndTime,
      files);
  const double before = heights(simulation, 0).second;
  expect_apart(simulation);
  const double after = heights(simulation, 0).second;
  EXPECT_GT(after, 0.02);
  EXPECT_LE(after, before + 1e-3);
  EXPECT_GT(simulation.built()
                .surface_contact->touching(simulation.now().state.configuration.positions)
                .front()
                .count,
            0);
}

TEST(SlowSolidContact, RestsOnABodyOfAMesh) {
  test::FileContents files = gel_and_cloth();
  // A square table of two faces.
  files["table.obj"] = "v -0.1 -0.1 0\nv 0.1 -0.1 0\nv 0.1 0.1 0\nv -0.1 0.1 0\nf 1 2 3\nf 1 3 4\n";
  Simulation simulation = test::simulation_of(
      "pliant: scene/1\nsolids:\n"
      "  - {name: cube, mesh: {block: [0.05, 0.05, 0.05], cells: [3, 3, 3]}, material: gel.json, "
      "place: {translate: [0, 0, 0.006]}}\n"
      "obstacles: [{name: table, mesh: {file: table.obj, unit: m}, friction: 0.5}]\n"
      "contact: {thickness: 1 mm}\n"
      "damping: {fraction: 0.02}\ntime: {step: 5 ms, duration: 300 ms}\n",
      files);
  while (!simulation.is_finished()) simulation.advance();
  const auto [low, high] = heights(simulation, 0);
  EXPECT_GT(low, 0);
  EXPECT_LT(low, 1e-3);
  EXPECT_GT(high, 0.04);
}

}  // namespace
}  // namespace pliant
