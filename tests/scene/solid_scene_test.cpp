// Solids in scenes: what is read and refused, what moves, what is written.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "pliant/geometry/block_mesh.h"
#include "pliant/geometry/volume_file.h"
#include "pliant/io/vtu.h"
#include "pliant/scene/checkpoint.h"
#include "pliant/scene/frame_files.h"
#include "pliant/scene/simulation_result.h"

#include "support/scene_simulation.h"

namespace pliant {
namespace {

constexpr const char* kRubber =
    R"({"pliant": "material/1", "name": "rubber", "kind": "solid", "density": 1000,
 "components": {"I1-bar": {"addends": [{"law": "linear", "c": 10000}]},
                "J": {"stiffness": {"curve": "constant", "value": 1e6}}}})";

test::FileContents files() {
  return {{"rubber.json", kRubber}, {"stiff.json", [] {
                                       std::string text = kRubber;
                                       text.replace(text.find("10000"), 5, "90000");
                                       return text;
                                     }()}};
}

/// A bar that hangs by an end.
std::string bar(const std::string& time, const std::string& elements,
                const std::string& more = "") {
  return "pliant: scene/1\nsolids:\n"
         "  - {name: bar, mesh: {block: [0.04, 0.04, 0.2], cells: [2, 2, 10], elements: " +
         elements +
         "}, material: rubber.json}\n"
         "pins: [{solid: bar, within: {box: {low: [0, 0, 0.2], high: [1, 1, 1]}}}]\n"
         "time: " +
         time + "\n" + more;
}

double volume_of(const Simulation& simulation) {
  VolumeMesh mesh = simulation.built().solids[0].mesh;
  mesh.positions = simulation.now().state.configuration.positions;
  return element_volumes(mesh).sum();
}

TEST(SolidScene, HangsStretchedByItsWeightAndKeepsItsVolume) {
  for (const char* elements : {"hexahedra", "tetrahedra"}) {
    Simulation simulation = test::simulation_of(
        bar("{kind: quasi-static, steps: 1, duration: 1 s}", elements), files());
    EXPECT_EQ(simulation.built().vertices, 3 * 3 * 11);
    const double volume = volume_of(simulation);
    simulation.advance();
    // Half its weight over its stiffness of 3 x 20 kPa, a little more where it is thinner.
    const double small = 1000 * 9.80665 * 0.2 / (2 * 6e4) * 0.2;
    EXPECT_NEAR(-test::way(simulation).row(2).minCoeff(), small, 0.1 * small) << elements;
    EXPECT_NEAR(volume_of(simulation), volume, 2e-3 * volume) << elements;
  }
}

TEST(SolidScene, SwingsWithoutGainingEnergy) {
  Simulation simulation = test::simulation_of(
      bar("{step: 5 ms, duration: 1 s}", "hexahedra", "gravity: [5, 0, -5]\n"), files());
  simulation.record_frame();
  for (int step = 0; step < 20; ++step) {
    simulation.advance();
    simulation.record_frame();
  }
  const auto& rows = simulation.now().energies;
  EXPECT_GT(rows.back().kinetic, 0);
  for (size_t i = 1; i < rows.size(); ++i) {
    EXPECT_LE(rows[i].total(), rows[i - 1].total() + 1e-6 * std::abs(rows[0].total()));
  }
}

TEST(SolidScene, GoesOnFromACheckpointToTheSameBits) {
  const std::string scene = bar("{step: 5 ms, duration: 1 s}", "tetrahedra");
  Simulation whole = test::simulation_of(scene, files());
  test::take_steps(whole, 6);
  const test::TemporaryFolder folder;
  Simulation first = test::simulation_of(scene, files());
  test::take_steps(first, 3);
  const auto file = folder.write("checkpoint.bin", checkpoint_bytes(first.now(), "this"));
  Simulation second = test::simulation_of(scene, files());
  second.resume(read_checkpoint(file, second, "this"));
  test::take_steps(second, 3);
  EXPECT_TRUE(second.now().state.configuration.positions ==
              whole.now().state.configuration.positions);
  EXPECT_TRUE(second.now().state.history == whole.now().state.history);
}

TEST(SolidScene, WritesItsElementsAndItsSurface) {
  Simulation simulation =
      test::simulation_of(bar("{step: 5 ms, duration: 1 s}", "hexahedra",
                              "output: {formats: [ply, vtu], fields: [strain]}\n"),
                          files());
  simulation.record_frame();
  const auto written = frame_files(simulation, 0);
  ASSERT_EQ(written.size(), 2U);
  const test::TemporaryFolder folder;
  const VtuHead head = read_vtu_head(folder.write("0.vtu", written[1].second));
  EXPECT_EQ(head.points, 99);
  EXPECT_EQ(head.cells, 40);
  const auto has = [&](const std::string& name) {
    return std::ranges::find(head.fields, name, &VtuField::name) != head.fields.end();
  };
  EXPECT_TRUE(has("strain.green.zz"));
  EXPECT_TRUE(has("strain.J"));
  EXPECT_EQ(simulation.built().faces.cols(), 2 * (2 * 4 + 4 * 20));
  const std::string json = simulation_text(simulation_result(simulation, {}));
  EXPECT_NE(json.find("\"elements\": 40"), std::string::npos);
  EXPECT_NE(json.find("\"mesh\": null"), std::string::npos);
}

TEST(SolidScene, RestsOnWhatItFallsOn) {
  Simulation simulation = test::simulation_of(
      "pliant: scene/1\nsolids:\n"
      "  - {name: cube, mesh: {block: [0.05, 0.05, 0.05], cells: [3, 3, 3]}, material: "
      "rubber.json,\n"
      "     place: {translate: [0, 0, 0.005]}}\n"
      "obstacles: [{name: floor, plane: {point: [0, 0, 0], normal: [0, 0, 1]}, friction: 0.5}]\n"
      "damping: {fraction: 0.01}\ntime: {step: 5 ms, duration: 1 s}\n",
      files());
  test::take_steps(simulation, 60);
  const Eigen::Matrix3Xd& x = simulation.now().state.configuration.positions;
  EXPECT_GT(x.row(2).minCoeff(), 0);
  EXPECT_LT(x.row(2).minCoeff(), 1e-3);  // the thickness
  EXPECT_GT(x.row(2).maxCoeff(), 0.045);
  EXPECT_LT(simulation.now().state.velocities.cwiseAbs().maxCoeff(), 0.05);
}

TEST(SolidScene, TakesRegionsOfItsFile) {
  test::FileContents all = files();
  VolumeMesh mesh = block_of_tetrahedra({0.04, 0.04, 0.2}, {1, 1, 4});
  for (int e = 0; e < mesh.element_count(); ++e) {
    const double z = mesh.positions(Eigen::all, mesh.tetrahedra.col(e)).row(2).mean();
    mesh.labels.push_back(z > 0.1 ? 2 : 1);
  }
  mesh.region_names = {{2, "upper"}};
  all["bar.msh"] = volume_file_text(mesh, "bar.msh");
  const auto scene = [](const std::string& label) {
    return "pliant: scene/1\nsolids:\n  - name: bar\n    mesh: {file: bar.msh, unit: m}\n"
           "    material: rubber.json\n    regions: [{material: stiff.json, label: " +
           label + "}]\ntime: {step: 5 ms, duration: 1 s}\n";
  };
  const Simulation simulation = test::simulation_of(scene("upper"), all);
  const SolidPiece& piece = simulation.built().solids[0];
  ASSERT_EQ(piece.regions.size(), 2U);
  EXPECT_EQ(piece.regions[0].elements.size(), piece.regions[1].elements.size());
  EXPECT_NEAR(piece.masses().sum(), 1000 * 0.04 * 0.04 * 0.2, 1e-12);
  try {
    test::simulation_of(scene("uper"), all);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "the mesh has no region \"uper\" (did you mean \"upper\"?)");
  }
}

TEST(SolidScene, BlendsSamplesOfItsMaterial) {
  const auto scene = [](const std::string& material) {
    return "pliant: scene/1\nsolids:\n"
           "  - {name: bar, mesh: {block: [0.2, 0.04, 0.04], cells: [10, 2, 2]}, material: " +
           material +
           "}\npins: [{solid: bar, within: {box: {low: [-1, -1, -1], high: [1, 1, 0]}}}]\n"
           "time: {kind: quasi-static, steps: 1, duration: 1 s}\n";
  };
  test::FileContents all = files();
  // The same weight, nine times as stiff at the other end.
  Simulation simulation = test::simulation_of(
      scene("{samples: [{at: [0, 0, 0], material: rubber.json}, {at: [0.2, 0.04, 0], material: "
            "stiff.json}], width: 20 mm}"),
      all);
  EXPECT_NEAR(simulation.built().solids[0].masses().sum(), 1000 * 0.2 * 0.04 * 0.04, 1e-12);
  simulation.advance();
  const Eigen::Matrix3Xd change = test::way(simulation);
  const auto sag = [&](double x) {
    double sum = 0;
    for (const int node : nodes_at(simulation.built().solids[0].mesh, 0, x)) {
      sum -= change(2, node);
    }
    return sum;
  };
  EXPECT_GT(sag(0), 5 * sag(0.2));
  const auto refused = [&](const std::string& material) {
    try {
      test::simulation_of(scene(material), all);
    } catch (const InputError& error) {
      return error.where().field + ": " + error.problem();
    }
    return std::string();
  };
  EXPECT_EQ(refused("{samples: [{at: [0, 0, 0.1], material: rubber.json}]}"),
            "solids[0].material.samples[0]: lies outside the body");
  EXPECT_EQ(refused("{samples: [{at: [0, 0, 0], material: rubber.json}, {at: [0, 0, 0], material: "
                    "stiff.json}]}"),
            "solids[0].material.samples[1]: is a second sample at one place");
}

TEST(SolidScene, WarnsOfAMaterialOfAnotherBody) {
  test::FileContents all = files();
  all["fitted.json"] =
      R"({"pliant": "material/1", "name": "fitted", "kind": "solid", "density": 1000,
 "components": {"J": {"stiffness": {"curve": "constant", "value": 1e6}}},
 "samples": {"width": 0.05, "at": [
   {"place": [0.02, 0.02, 0.05], "components": {"I1-bar": {"addends": [{"law": "linear", "c": 1e4}]}}},
   {"place": [0.02, 0.02, 0.5], "components": {"I1-bar": {"addends": [{"law": "linear", "c": 2e4}]}}}]}})";
  std::string scene = bar("{step: 5 ms, duration: 1 s}", "tetrahedra");
  scene.replace(scene.find("rubber.json"), 11, "fitted.json");
  const Simulation simulation = test::simulation_of(scene, all);
  ASSERT_EQ(simulation.built().warnings.size(), 1U);
  EXPECT_EQ(simulation.built().warnings.front(),
            "1 of 2 samples of the material \"fitted\" lie outside the body bar: was it fitted to "
            "another?");
}

struct Refused {
  const char* solid;
  const char* field;
  const char* problem;
};

TEST(SolidScene, RefusesWhatCannotBeASolid) {
  const std::vector<Refused> cases{
      {"{name: a, mesh: {block: [1, 1, 0], cells: [1, 1, 1]}, material: rubber.json}",
       "solids[0].mesh.block", "has no volume"},
      {"{name: a, mesh: {block: [1, 1, 1], cells: [1, 1]}, material: rubber.json}",
       "solids[0].mesh.cells", "are not three numbers"},
      {"{name: a, mesh: {cells: [1, 1, 1]}, material: rubber.json}", "solids[0].mesh",
       "is not one mesh"},
      {"{name: a, mesh: {block: [1, 1, 1], cells: [1, 1, 1]}, material: cloth.json}",
       "solids[0].material", "is a material of cloth"},
      {"{name: a, mesh: {block: [1, 1, 1], cells: [1, 1, 1]}, material: soft.json}",
       "solids[0].material", "the material \"soft\" does not resist every small strain"},
      {"{name: a, mesh: {block: [1, 1, 1], cells: [1, 1, 1]}, material: light.json}",
       "solids[0].material", "the material \"light\" has no density"},
      // [T] Fig. 4.2: lambda below 0, so that the energy falls where strains grow together.
      {"{name: a, mesh: {block: [1, 1, 1], cells: [1, 1, 1]}, material: concave.json}",
       "solids[0].material", "the material \"concave\" does not resist every small strain"}};
  test::FileContents all = files();
  all["cloth.json"] = material_text(test::linear_cloth(30, 10, 1e-5));
  all["soft.json"] =
      R"({"pliant": "material/1", "name": "soft", "kind": "solid", "density": 1000,
 "components": {"J": {"stiffness": {"curve": "constant", "value": 1e6}}}})";
  all["concave.json"] =
      R"({"pliant": "material/1", "name": "concave", "kind": "solid", "density": 1000,
 "components": {"trace": {"stiffness": {"curve": "constant", "value": -1e4}},
                "trace-of-square": {"addends": [{"law": "linear", "c": 1e4}]}}})";
  all["light.json"] =
      R"({"pliant": "material/1", "name": "light", "kind": "solid",
 "components": {"trace-of-square": {"addends": [{"law": "linear", "c": 1e4}]}}})";
  for (const auto& [solid, field, problem] : cases) {
    try {
      test::simulation_of("pliant: scene/1\nsolids:\n  - " + std::string(solid) +
                              "\ntime: {step: 5 ms, duration: 1 s}\n",
                          all);
      ADD_FAILURE() << problem;
    } catch (const InputError& error) {
      EXPECT_EQ(error.where().field, field);
      EXPECT_EQ(error.problem(), problem);
    }
  }
}

}  // namespace
}  // namespace pliant
