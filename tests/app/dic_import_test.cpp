// What image correlation sees of a virtual pull, and a tester writes beside it, becomes a session
// and a strip that give back the cloth's law.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/base/random.h"
#include "pliant/measurement/session.h"

#include "app/picture_png.h"
#include "app/run_program.h"
#include "capture/texture.h"

namespace pliant::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

constexpr double kNoise = 5e-6;  // of a coordinate of a point (m)

/// The virtual pull of a sheet of 100 mm x 100 mm between clips that are 5 mm deep.
Session virtual_pull(const TemporaryFolder& folder, int cycles, int frames) {
  const auto lab = folder.write(
      "lab.yaml", "pliant: lab/1\nmaterial: " PLIANT_SOURCE_DIR
                  "/examples/assumed-cloth.json\n"
                  "experiments:\n  - {name: pull, type: session, test: stretch-warp, strain: 8 %, "
                  "mesh: {nodes: 41x41},\n" +
                      fmt::format("     cycles: {}, frames: {}}}\n", cycles, frames));
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

/// The tester's log of the sheet at rest and of each frame.
std::string tester_log(const Session& session) {
  std::string log = "force_N,extension_mm\n0,0\n";
  for (const SessionFrame& frame : session.frames) {
    double force = 0;
    for (const CordForce& cord : frame.cords[1]) force += cord.force.y();
    const double way = frame.poses[1].translation.y() - frame.poses[0].translation.y();
    log += fmt::format("{},{}\n", force, 1e3 * way);
  }
  return log;
}

/// What the lower jaw has moved by in a frame of an export, the first of which is at rest (m).
double lower_jaw(const Session& session, int frame) {
  if (frame == 0) return 0;
  return session.frames[static_cast<std::size_t>(frame - 1)].poses[0].translation.y();
}

const Eigen::Matrix3Xd& shape(const Session& session, int frame) {
  if (frame == 0) return session.rest.positions;
  return session.frames[static_cast<std::size_t>(frame - 1)].positions;
}

void write_tables(const TemporaryFolder& folder, const Session& session) {
  RandomStream random(3);
  for (int f = 0; f <= session.frame_count(); ++f) {
    folder.write(fmt::format("points/{:03}.csv", f),
                 point_table(session, shape(session, f), lower_jaw(session, f), random));
  }
  folder.write("tester.csv", tester_log(session));
}

constexpr const char* kPoints =
    "points: {file: \"points/*.csv\", columns: {x: \"X[mm]\", y: \"Y[mm]\", u: \"U[mm]\", "
    "v: \"V[mm]\"}}\norigin: [0 mm, 5 mm]\n";

/// @param seen  where the points come from, and where the sample is
fs::path described(const TemporaryFolder& folder, const std::string& seen = kPoints) {
  return folder.write("pull.yaml",
                      "pliant: dic/1\ntest: stretch-warp\n"
                      "sample: {width: 100 mm, height: 90 mm, density: 150 g/m^2}\n" +
                          seen +
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
// constant stiffness is told, and which the values at both ends of a line are about.
void expect_law(const std::map<std::string, double>& found) {
  for (const auto& [name, value] : found) fmt::print("{} = {:.4g}\n", name, value);
  const double least = found.at("stretch.warp.k[0]");
  const auto most = found.find("stretch.warp.k[1]");
  EXPECT_NEAR(most == found.end() ? least : (least + most->second) / 2, 138, 0.03 * 138);
  EXPECT_NEAR(found.at("stretch.warp.friction.a"), 2.22, 0.1 * 2.22);
  EXPECT_NEAR(found.at("stretch.warp.friction.tau"), 0.006, 0.2 * 0.006);
}

TEST(SlowDicImport, OfAVirtualPullGivesBackItsLaw) {
  const TemporaryFolder folder;
  write_tables(folder, virtual_pull(folder, 2, 41));
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

/// Draws a sheet with a texture as a camera straight in front of it sees it, 0.25 mm a pixel, with
/// the noise of its pixels.
class Drawing {
 public:
  static constexpr double kPixel = 0.25e-3;
  static constexpr int kColumns = 480, kRows = 500;

  static Eigen::Vector2d pixel(const Eigen::Vector2d& place) {
    return {40 + place.x() / kPixel, kRows - 40 - place.y() / kPixel};
  }

  explicit Drawing(const Session& session) : session_(session) {}

  std::string png(int frame) const {
    GreyPicture picture = GreyPicture::Constant(kRows, kColumns, 30);
    const Eigen::Matrix3Xd& now = shape(session_, frame);
    const Eigen::Vector2d lower(0, lower_jaw(session_, frame));
    for (const auto& corners : session_.rest.triangles.colwise()) {
      Eigen::Matrix<double, 2, 3> rest, moved;
      for (int k = 0; k < 3; ++k) {
        rest.col(k) = pixel(session_.rest.positions.col(corners(k)).head<2>());
        moved.col(k) = pixel(now.col(corners(k)).head<2>() - lower);
      }
      draw(rest, moved, picture);
    }
    RandomStream random(static_cast<std::uint64_t>(frame));
    add_noise(picture, 2.55, random);
    return png_of(picture, 255);
  }

 private:
  void draw(const Eigen::Matrix<double, 2, 3>& rest, const Eigen::Matrix<double, 2, 3>& moved,
            GreyPicture& picture) const {
    Eigen::Matrix2d edges;
    edges << moved.col(1) - moved.col(0), moved.col(2) - moved.col(0);
    const Eigen::Matrix2d inverse = edges.inverse();
    const Eigen::Vector2i least = moved.rowwise().minCoeff().array().floor().cast<int>();
    const Eigen::Vector2i most = moved.rowwise().maxCoeff().array().ceil().cast<int>();
    for (int row = std::max(least.y(), 0); row <= std::min(most.y(), kRows - 1); ++row) {
      for (int column = std::max(least.x(), 0); column <= std::min(most.x(), kColumns - 1);
           ++column) {
        const Eigen::Vector2d share = inverse * (Eigen::Vector2d(column, row) - moved.col(0));
        if (share.minCoeff() < -1e-9 || share.sum() > 1 + 1e-9) continue;
        const Eigen::Vector2d place = rest.col(0) + share.x() * (rest.col(1) - rest.col(0)) +
                                      share.y() * (rest.col(2) - rest.col(0));
        picture(row, column) = static_cast<float>(texture_.at(place));
      }
    }
  }

  const Session& session_;
  Texture texture_{21};
};

TEST(SlowDicImport, OfPicturesOfAVirtualPullGivesBackItsLaw) {
  const TemporaryFolder folder;
  const Session session = virtual_pull(folder, 1, 25);
  const Drawing drawing(session);
  for (int f = 0; f <= session.frame_count(); ++f) {
    folder.write(fmt::format("pictures/{:03}.png", f), drawing.png(f));
  }
  folder.write("tester.csv", tester_log(session));
  const Eigen::Vector2d corner = Drawing::pixel({0, 5e-3});
  const fs::path file =
      described(folder, fmt::format("pictures: pictures/*.png\nscale: 0.25 mm\norigin: [{}, {}]\n",
                                    corner.x(), corner.y()));
  const fs::path out = folder.path() / "imported";
  const ProgramRun run = run_program({"import", "--dic", file.string(), "-o", out.string()});
  EXPECT_EQ(run.status, 0) << run.err;
  fmt::print("{}{:.1f} s\n", run.err, run.seconds);
  EXPECT_THAT(run.err, HasSubstr("26 frames of points 2.5 mm apart"));
  fmt::print("strip:\n");
  expect_law(parameters_of(folder, out / "strip.yaml"));
  fmt::print("sheet:\n");
  expect_law(parameters_of(folder, out / "study.yaml"));
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
