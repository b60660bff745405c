// What `pliant simulate` writes.

#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/io/csv.h"
#include "pliant/io/obj.h"
#include "pliant/io/pc2.h"
#include "pliant/io/ply.h"

#include "app/scene_folder.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;

constexpr const char* kShort = "{step: 10 ms, duration: 60 ms}";

class Simulate : public ::testing::Test {
 protected:
  void simulate(const std::string& time, const std::string& output,
                const std::vector<std::string>& arguments = {}) {
    folder.write("scene.yaml", small_scene(time, output));
    run = folder.simulate(arguments);
    ASSERT_EQ(run.status, 0) << run.err;
    result = json::parse(content_of(folder.results() / "simulation.json"));
  }

  std::string bytes(const std::string& name) const { return content_of(folder.results() / name); }
  PlyMesh frame(int index) const {
    return read_ply(folder.results() / "frames" / fmt::format("{:06}.ply", index));
  }

  SceneFolder folder;
  ProgramRun run;
  json result;
};
using SlowSimulate = Simulate;

TEST_F(SlowSimulate, WritesTheFramesThatItTellsOf) {
  simulate(kShort, "{every: 20 ms, fields: [strain, friction]}");
  EXPECT_EQ(result["finished"], true);
  EXPECT_EQ(result["steps"], 6);
  EXPECT_EQ(result["triangles"], 128);
  EXPECT_EQ(result["vertices"], 81);
  ASSERT_EQ(result["frames"].size(), 4u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(result["frames"][i]["index"], i);
    EXPECT_NEAR(result["frames"][i]["time"].get<double>(), 0.02 * i, 1e-15);
    const PlyMesh mesh = frame(i);
    EXPECT_EQ(mesh.positions.size(), 81u);  // the point of the cord is no vertex
    EXPECT_EQ(mesh.faces.size(), 128u);
    ASSERT_EQ(mesh.vertex_columns.size(), result["fields"].size());
    for (const PlyColumn& column : mesh.vertex_columns) {
      EXPECT_TRUE(result["fields"].contains(column.name)) << column.name;
      for (const double value : column.values) EXPECT_TRUE(std::isfinite(value)) << column.name;
    }
  }
  EXPECT_EQ(names_in(folder.results() / "frames").size(), 4u);
  EXPECT_THAT(names_in(folder.results()), IsSupersetOf({"simulation.json", "energy.csv",
                                                        "clips.csv", "cloth.obj", "report.html"}));
}

TEST_F(Simulate, SaysWhatItDoesNotModelAndWhatBecameOfIt) {
  simulate(kShort, "{every: 60 ms}");
  EXPECT_THAT(result["not_modelled"], Contains("contact"));
  if (result["crossing_pairs"].is_null()) GTEST_SKIP() << "this program was built without CGAL";
  EXPECT_EQ(result["crossing_pairs"], 0);
  EXPECT_THAT(run.err, HasSubstr("Not modelled: contact"));
}

// Two equal squares, of which one stands upright through the other.
TEST_F(Simulate, CountsTrianglesThatPassThroughEachOther) {
  const std::string sheet =
      "mesh: {grid: 100 mm x 100 mm, nodes: 4x4}, material: " PLIANT_SOURCE_DIR
      "/materials/cotton.json";
  folder.write("scene.yaml",
               "pliant: scene/1\ncloth:\n  - {name: a, " + sheet + "}\n  - {name: b, " + sheet +
                   ", place: {rotate: {axis: [1, 0, 0], angle: 90 deg}, translate: [0.005, 0.05, "
                   "-0.04]}}\ngravity: [0, 0, 0]\n"
                   "time: {step: 10 ms, duration: 20 ms}\n");
  run = folder.simulate({});
  ASSERT_EQ(run.status, 0) << run.err;
  result = json::parse(bytes("simulation.json"));
  if (result["crossing_pairs"].is_null()) GTEST_SKIP() << "this program was built without CGAL";
  EXPECT_GT(result["crossing_pairs"], 0);
}

TEST_F(SlowSimulate, GivesFieldsTheUnitsOfTheirComponents) {
  simulate(kShort, "{every: 60 ms, fields: [strain, friction]}", {"--no-report"});
  EXPECT_EQ(result["fields"]["strain.stretch.weft"], "1");
  EXPECT_EQ(result["fields"]["strain.bend.weft"], "1/m");
  EXPECT_EQ(result["fields"]["friction.stretch.weft"], "N/m");
  EXPECT_EQ(result["fields"]["friction.bend.weft"], "N");
}

TEST_F(SlowSimulate, LeavesFrictionOutWhereTheSceneSaysNone) {
  simulate("{step: 10 ms, duration: 60 ms, friction: none}",
           "{every: 60 ms, fields: [strain, friction]}", {"--no-report"});
  for (const auto& [name, unit] : result["fields"].items()) EXPECT_THAT(name, StartsWith("strain"));
  EXPECT_FALSE(result["fields"].empty());
}

TEST_F(Simulate, SaysWhatItAssumed) {
  simulate(kShort, "{every: 60 ms}");
  EXPECT_THAT(run.err, HasSubstr("warning: shear of \"cotton\" was not measured: that of \"assumed "
                                 "light cloth\" is assumed"));
  EXPECT_THAT(result["warnings"].get<std::vector<std::string>>(),
              Contains(HasSubstr("bend.diagonal of \"cotton\"")));
}

TEST_F(SlowSimulate, WritesFramesAndCheckpointsThatInfoDescribes) {
  simulate(kShort, "{every: 60 ms, formats: [ply, vtu], fields: [strain]}",
           {"--checkpoint-every", "40 ms", "--no-report"});
  const auto info = [&](const char* name) {
    return json::parse(run_program({"info", (folder.results() / name).string(), "--json"}).out);
  };
  const json frame = info("frames/000001.vtu");
  EXPECT_EQ(frame["vertices"], 81);
  EXPECT_EQ(frame["cells"], 128);
  EXPECT_EQ(frame["fields"].size(), result["fields"].size());
  EXPECT_EQ(frame["fields"][0]["of"], "vertex");
  EXPECT_TRUE(result["fields"].contains(frame["fields"][0]["name"]));
  const json checkpoint = info("checkpoint.bin");
  EXPECT_EQ(checkpoint["type"], "checkpoint/1");
  EXPECT_EQ(checkpoint["steps"], 6);
  EXPECT_NEAR(checkpoint["time"].get<double>(), 0.06, 1e-15);
  EXPECT_EQ(checkpoint["scene_identity"].get<std::string>().size(), 64u);

  std::string damaged = bytes("checkpoint.bin");
  damaged.back() ^= 1;
  const auto file = folder.write("damaged.bin", damaged);
  EXPECT_THAT(run_program({"info", file.string()}).err, HasSubstr("is a damaged checkpoint"));
}

TEST_F(Simulate, NamesWhatItDoesNotUseOnce) {
  std::string material = content_of(PLIANT_SOURCE_DIR "/materials/cotton.json");
  const std::string components = "\"components\": {";
  material.insert(material.find(components) + components.size(),
                  R"("stretch.bias": {"stiffness": {"curve": "constant", "value": 5}},)");
  folder.write("cotton.json", material);
  folder.write("scene.yaml",
               edited_text(small_scene(kShort, "{every: 60 ms}"),
                           {{PLIANT_SOURCE_DIR "/materials/cotton.json",
                             "cotton.json\n    regions: [{material: cotton.json, faces: [0]}]"}}));
  const std::string err = folder.simulate().err;
  const std::string warning = "stretch.bias of \"cotton\" was measured, but";
  EXPECT_THAT(err, HasSubstr(warning));
  EXPECT_EQ(err.find(warning), err.rfind(warning));
}

TEST_F(Simulate, PrintsItsResultAsJson) {
  simulate(kShort, "{every: 60 ms}", {"--json"});
  const json printed = json::parse(run.out);
  EXPECT_EQ(printed["pliant"], "simulation/1");
  EXPECT_EQ(printed["frames"], result["frames"]);
}

TEST_F(Simulate, AccountsForEnergyFrameByFrame) {
  simulate("{step: 5 ms, duration: 100 ms}", "{every: 10 ms, formats: [vtu]}");
  const CsvTable table = read_csv(folder.results() / "energy.csv");
  const auto column = [&](const char* name) { return table.numbers(name); };
  ASSERT_EQ(table.rows(), 11u);
  for (size_t i = 0; i < table.rows(); ++i) {
    EXPECT_NEAR(column("time_s")[i], 0.01 * static_cast<double>(i), 1e-15);
    const double sum = column("kinetic_J")[i] + column("stored_J")[i] + column("work_J")[i];
    EXPECT_NEAR(column("total_J")[i], sum, 1e-15);
  }
  EXPECT_EQ(column("kinetic_J").front(), 0);
  EXPECT_GT(column("work_J").back(), 0);
}

TEST_F(Simulate, WritesPosesOfClipsAndTheForcesOnThem) {
  simulate("{kind: quasi-static, steps: 10, duration: 100 ms}", "{every: 50 ms}");
  const CsvTable table = read_csv(folder.results() / "clips.csv");
  ASSERT_EQ(table.rows(), 3u);
  EXPECT_EQ(table.texts("clip"), std::vector<std::string>(3, "weight"));
  EXPECT_EQ(table.integers("frame"), (std::vector<long>{0, 1, 2}));
  const auto at_end = [&](const std::vector<const char*>& names) {
    Eigen::VectorXd values(std::ssize(names));
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      values(i) = table.numbers(names[static_cast<size_t>(i)]).back();
    }
    return values;
  };
  // Vertex 4 is one of the clip's.
  const Eigen::Vector4d turn = at_end({"qw", "qx", "qy", "qz"});
  const Eigen::Quaterniond rotation(turn(0), turn(1), turn(2), turn(3));
  const Eigen::Vector3d before(frame(0).positions[4].data()), after(frame(2).positions[4].data());
  EXPECT_GT((after - before).norm(), 1e-3);
  EXPECT_LT((rotation * before + at_end({"tx", "ty", "tz"}) - after).norm(), 1e-12);
  // It is free, and the tolerance of an equilibrium is 10 uN.
  EXPECT_LT(at_end({"fx", "fy", "fz"}).cwiseAbs().maxCoeff(), 1e-5);
}

TEST_F(SlowSimulate, TellsTheForceThatMovesAClip) {
  folder.write("scene.yaml",
               "pliant: scene/1\n"
               "cloth: [{name: strip, mesh: {grid: 20 mm x 100 mm, nodes: 3x11}, "
               "material: " PLIANT_SOURCE_DIR
               "/materials/cotton.json}]\n"
               "clips:\n"
               "  - {name: held, cloth: strip, edges: [bottom], mass: 1 g}\n"
               "  - {name: moved, cloth: strip, edges: [top], mass: 1 g,\n"
               "     motion: {keyframes: [{time: 0 s}, {time: 1 s, translate: [0, 0.01, 0]}]}}\n"
               "gravity: [0, 0, 0]\n"
               "time: {kind: quasi-static, steps: 1, duration: 1 s, friction: none}\n");
  ASSERT_EQ(folder.simulate({"--no-report"}).status, 0);
  const CsvTable table = read_csv(folder.results() / "clips.csv");
  // Cotton's warp: (k1 + k2 strain) strain with the strain (l^2 - 1) / 2, d strain / d length = l /
  // L, at l = 1.1; 20 mm wide, 100 mm long.
  const double strain = (1.1 * 1.1 - 1) / 2;
  const double force = 0.02 * 1.1 * (135.6 + 64.03 * strain) * strain;
  const std::vector<double> forces = table.numbers("fy");
  EXPECT_NEAR(forces[2], -force, 1e-5 + 1e-9);
  EXPECT_NEAR(forces[3], force, 1e-5 + 1e-9);
}

TEST_F(SlowSimulate, WritesTheSameMeshForParaViewAndBlender) {
  simulate(kShort, "{every: 20 ms, formats: [ply, vtu, pc2], fields: [strain]}", {"--no-report"});
  const Pc2Cache cache = read_pc2(folder.results() / "cloth.pc2");
  ASSERT_EQ(cache.frames.size(), 4u);
  for (size_t f = 0; f < 4; ++f) {
    const PlyMesh mesh = frame(static_cast<int>(f));
    ASSERT_EQ(cache.frames[f].size(), mesh.positions.size());
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
      for (size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(cache.frames[f][i][axis], static_cast<float>(mesh.positions[i][axis]));
      }
    }
    // Points stand in the VTU file as they are in memory.
    const std::string vtu = bytes(fmt::format("frames/{:06}.vtu", f));
    const std::string points(reinterpret_cast<const char*>(mesh.positions.data()),
                             mesh.positions.size() * sizeof(Point3));
    EXPECT_NE(vtu.find(points), std::string::npos) << f;
    EXPECT_THAT(vtu, HasSubstr("strain.stretch.warp"));
    EXPECT_THAT(bytes("simulation.pvd"), HasSubstr(fmt::format("frames/{:06}.vtu", f)));
  }
  const ObjMesh obj = read_obj(folder.results() / "cloth.obj");
  EXPECT_EQ(obj.positions, frame(0).positions);
  EXPECT_EQ(obj.faces.corners, frame(0).faces.corners);
  EXPECT_EQ(obj.texture_corners.size(), obj.faces.corners.size());
}

TEST_F(Simulate, WritesNoPlyWhereNoneIsAskedFor) {
  simulate(kShort, "{every: 20 ms, formats: [pc2]}");
  EXPECT_FALSE(std::filesystem::exists(folder.results() / "frames"));
  EXPECT_EQ(read_pc2(folder.results() / "cloth.pc2").frames.size(), 4u);
}

TEST_F(SlowSimulate, GivesTheSameBitsEveryTime) {
  for (const char* time : {"{step: 5 ms, duration: 100 ms, integrator: bdf2}",
                           "{step: 5 ms, duration: 100 ms, solve: linearized}",
                           "{kind: quasi-static, steps: 10, duration: 100 ms}"}) {
    folder.write(
        "scene.yaml",
        small_scene(time, "{every: 20 ms, formats: [vtu, pc2], fields: [strain, friction]}"));
    ASSERT_EQ(folder.simulate({"--no-report"}, "first").status, 0) << time;
    ASSERT_EQ(folder.simulate({"--no-report"}, "second").status, 0) << time;
    expect_same_files(folder.computed_files("first"), folder.computed_files("second"));
  }
}

TEST_F(SlowSimulate, ReplacesAnEarlierSimulation) {
  simulate(kShort, "{every: 20 ms}", {"--no-report"});
  simulate(kShort, "{every: 60 ms}", {"--no-report"});
  EXPECT_EQ(names_in(folder.results() / "frames").size(), 2u);
}

}  // namespace
}  // namespace pliant::test
