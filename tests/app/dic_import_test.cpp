// What image correlation sees of a virtual pull, and a tester writes beside it, becomes a session
// and a strip that give back the cloth's law.

#include <filesystem>
#include <map>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/base/random.h"
#include "pliant/measurement/session.h"

#include "app/run_program.h"

namespace pliant::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

constexpr double kNoise = 5e-6;  // of a coordinate of a point (m)

/// The virtual pull of a sheet of 100 mm x 100 mm between clips that are 5 mm deep.
Session virtual_pull(const TemporaryFolder& folder) {
  const auto lab = folder.write(
      "lab.yaml",
      "pliant: lab/1\nmaterial: " PLIANT_SOURCE_DIR
      "/examples/assumed-cloth.json\n"
      "experiments:\n  - {name: pull, type: session, test: stretch-warp, strain: 8 %, cycles: 2,\n"
      "     frames: 41, mesh: {nodes: 41x41}}\n");
  EXPECT_EQ(run_program({"lab", lab.string(), "-o", (folder.path() / "lab").string()}).status, 0);
  return read_session(folder.path() / "lab" / "pull");
}

/// A frame's table: points that are 2 mm off the clips and 1 mm off the free edges, their
/// displacements counted from where the lower clip is.
std::string point_table(const Session& session, const Eigen::Matrix3Xd& positions, double lower,
                        RandomStream& random) {
  std::string text = "X[mm],Y[mm],U[mm],V[mm]\n";
  for (int v = 0; v < session.rest.vertex_count(); ++v) {
    const Eigen::Vector3d rest = session.rest.positions.col(v);
    const bool inside = rest.x() > 1e-3 && rest.x() < 0.099 && rest.y() > 7e-3 && rest.y() < 0.093;
    if (!inside) continue;
    const Eigen::Vector3d by = positions.col(v) - rest - Eigen::Vector3d(0, lower, 0);
    text += fmt::format("{:.6f},{:.6f},{:.6f},{:.6f}\n", 1e3 * rest.x(), 1e3 * rest.y(),
                        1e3 * (by.x() + kNoise * random.normal()),
                        1e3 * (by.y() + kNoise * random.normal()));
  }
  return text;
}

/// The tables of the sheet at rest and of each frame, and the tester's log.
void write_export(const TemporaryFolder& folder, const Session& session) {
  RandomStream random(3);
  folder.write("points/000.csv", point_table(session, session.rest.positions, 0, random));
  std::string log = "force_N,extension_mm\n0,0\n";
  for (int f = 0; f < session.frame_count(); ++f) {
    const SessionFrame& frame = session.frames[static_cast<std::size_t>(f)];
    const double lower = frame.poses[0].translation.y(), upper = frame.poses[1].translation.y();
    folder.write(fmt::format("points/{:03}.csv", f + 1),
                 point_table(session, frame.positions, lower, random));
    double force = 0;
    for (const CordForce& cord : frame.cords[1]) force += cord.force.y();
    log += fmt::format("{},{}\n", force, 1e3 * (upper - lower));
  }
  folder.write("tester.csv", log);
}

fs::path described(const TemporaryFolder& folder) {
  return folder.write("pull.yaml",
                      "pliant: dic/1\ntest: stretch-warp\n"
                      "sample: {width: 100 mm, height: 90 mm, density: 150 g/m^2}\n"
                      "points: {file: \"points/*.csv\", columns: {x: \"X[mm]\", y: \"Y[mm]\", "
                      "u: \"U[mm]\", v: \"V[mm]\"}}\n"
                      "origin: [0 mm, 5 mm]\n"
                      "clips:\n  - {name: lower, side: bottom, motion: held}\n"
                      "  - {name: upper, side: top, motion: extension}\n"
                      "forces: {data: tester.csv, on: upper}\n");
}

std::map<std::string, double> parameters_of(const TemporaryFolder& folder, const fs::path& study) {
  const ProgramRun run =
      run_program({"fit", study.string(), "-o",
                   (folder.path() / ("fit-" + study.stem().string())).string(), "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  std::map<std::string, double> values;
  const json fit = json::parse(run.out);
  for (const json& p : fit["parameters"]) values[p["name"]] = p["value"];
  return values;
}

// The cloth has k(0) = 135.6 N/m, which grows by 64 a unit of strain: 138 N/m half way, where a
// constant stiffness is told.
void expect_law(const std::map<std::string, double>& found) {
  for (const auto& [name, value] : found) fmt::print("{} = {:.4g}\n", name, value);
  EXPECT_NEAR(found.at("stretch.warp.k[0]"), 138, 0.03 * 138);
  EXPECT_NEAR(found.at("stretch.warp.friction.a"), 2.22, 0.1 * 2.22);
  EXPECT_NEAR(found.at("stretch.warp.friction.tau"), 0.006, 0.2 * 0.006);
}

TEST(SlowDicImport, OfAVirtualPullGivesBackItsLaw) {
  const TemporaryFolder folder;
  write_export(folder, virtual_pull(folder));
  const fs::path out = folder.path() / "imported";
  const ProgramRun run =
      run_program({"import", "--dic", described(folder).string(), "-o", out.string()});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("42 frames of points 2.5 mm apart"));
  EXPECT_THAT(run.err, HasSubstr("frames in which the sample hung slack are not in the session"));
  EXPECT_THAT(run.err, HasSubstr("across the pull it hardly narrows"));
  fmt::print("strip:\n");
  expect_law(parameters_of(folder, out / "strip.yaml"));
  fmt::print("sheet:\n");
  expect_law(parameters_of(folder, out / "study.yaml"));
  EXPECT_THAT(run_program({"info", described(folder).string()}).out, HasSubstr("42 frames"));
}

TEST(DicImportCommand, LeavesNothingWhereTheSessionCannotBeUsed) {
  const TemporaryFolder folder;
  std::string rows = "x_mm,y_mm,u_mm,v_mm\n", mirrored = rows;
  for (int i = 0; i < 36; ++i) {
    const int x = i % 6, y = i / 6;
    rows += fmt::format("{},{},0,0\n", 2 * x, 2 * y);
    mirrored += fmt::format("{},{},{},0\n", 2 * x, 2 * y, 500);
  }
  folder.write("points/0.csv", rows);
  folder.write("points/1.csv", mirrored);
  const auto file = folder.write("d.yaml",
                                 "pliant: dic/1\ntest: t\npoints: points/*.csv\n"
                                 "sample: {width: 10 mm, height: 10 mm, mass: 1 g}\n"
                                 "clips: [{name: a, side: left, motion: held}]\n");
  const fs::path out = folder.path() / "out";
  const ProgramRun run = run_program({"import", "--dic", file.string(), "-o", out.string()});
  EXPECT_EQ(run.status, 2) << run.out;
  EXPECT_THAT(run.err, HasSubstr("gives a session that cannot be used"));
  EXPECT_FALSE(fs::exists(out / "study.yaml"));
}

TEST(DicImportCommand, TakesOneFile) {
  const ProgramRun run = run_program({"import", "--dic", "a.yaml", "b.yaml", "-o", "out"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("one dic/1 file"));
}

}  // namespace
}  // namespace pliant::test
