// From a virtual session through the pictures that a rig of cameras takes of it to a law, by the
// program.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/geometry/triangle_mesh.h"
#include "pliant/measurement/session.h"

#include "app/run_program.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// Where a place of the rest plane is in a frame, between the vertices around it.
Eigen::Vector3d place_in(const Session& session, const SessionFrame& frame,
                         const Eigen::Vector2d& rest) {
  constexpr double kOutside = 1e-6;
  for (const auto& corners : session.rest.triangles.colwise()) {
    const Eigen::Matrix3d own = session.rest.positions(Eigen::all, corners);
    Eigen::Matrix2d edges;
    edges << own.col(1).head<2>() - own.col(0).head<2>(),
        own.col(2).head<2>() - own.col(0).head<2>();
    const Eigen::Vector2d weights = edges.inverse() * (rest - own.col(0).head<2>());
    if (weights.minCoeff() < -kOutside || weights.sum() > 1 + kOutside) continue;
    return frame.positions(Eigen::all, corners) *
           Eigen::Vector3d(1 - weights.sum(), weights.x(), weights.y());
  }
  return Eigen::Vector3d::Constant(NAN);
}

struct Misses {
  double in_plane = 0, off_plane = 0, of_clips = 0;  ///< root mean squares; the largest (m)
  int vertices = 0;
};

/// By how much what was seen misses what was there, without 2 mm beside clips.
Misses misses_of(const Session& seen, const Session& truth) {
  constexpr double kBeside = 2e-3;
  Misses misses;
  double in_plane = 0, off_plane = 0;
  const double low = truth.rest.positions(1, truth.clips[0].clamped).maxCoeff() + kBeside;
  const double high = truth.rest.positions(1, truth.clips[1].clamped).minCoeff() - kBeside;
  for (int f = 0; f < seen.frame_count(); ++f) {
    const SessionFrame& frame = seen.frames[f];
    for (int v = 0; v < seen.rest.vertex_count(); ++v) {
      const Eigen::Vector2d rest = seen.rest.positions.col(v).head<2>();
      const Eigen::Vector3d off = frame.positions.col(v) - place_in(truth, truth.frames[f], rest);
      const bool clamped = std::ranges::any_of(seen.clips, [&](const SessionClip& clip) {
        return std::ranges::find(clip.clamped, v) != clip.clamped.end();
      });
      if (clamped) misses.of_clips = std::max(misses.of_clips, off.norm());
      const bool free = rest.y() > low && rest.y() < high;
      if (!free || std::ranges::binary_search(frame.unseen, v)) continue;
      in_plane += off.head<2>().squaredNorm() / 2;
      off_plane += off.z() * off.z();
      ++misses.vertices;
    }
  }
  misses.in_plane = std::sqrt(in_plane / misses.vertices);
  misses.off_plane = std::sqrt(off_plane / misses.vertices);
  return misses;
}

ProgramRun run_on(const std::filesystem::path& folder, std::vector<std::string> arguments,
                  const std::string& out) {
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (arguments[i].front() != '-') arguments[i] = (folder / arguments[i]).string();
  }
  arguments.insert(arguments.end(), {"-o", (folder / out).string()});
  return run_program(arguments);
}

TEST(SlowVirtualRig, SeesASheetAsItIsAndTellsItsLaw) {
  const TemporaryFolder folder;
  const std::string lab = PLIANT_SOURCE_DIR "/examples/virtual-rig/lab.yaml";
  ASSERT_EQ(run_program({"lab", lab, "-o", (folder.path() / "lab").string()}).status, 0);
  const auto seen = folder.path() / "lab" / "stretch-seen";
  const ProgramRun calibrated = run_on(seen, {"calibrate", "rig.yaml"}, "calibration");
  ASSERT_EQ(calibrated.status, 0) << calibrated.err;
  const ProgramRun imported = run_on(seen, {"import", "--dic", "capture.yaml"}, "made");
  ASSERT_EQ(imported.status, 0) << imported.err;
  EXPECT_THAT(imported.err, HasSubstr("lines of sight miss each other by 0.0"));

  const Session truth = read_session(folder.path() / "lab" / "stretch");
  const Session session = read_session(seen / "made" / "sheet");
  ASSERT_EQ(session.frame_count(), truth.frame_count());
  EXPECT_NEAR((session.gravity - truth.gravity).norm(), 0, 0.01);
  const Misses misses = misses_of(session, truth);
  fmt::print("in plane {:.4f} mm, off it {:.4f} mm, clips {:.4f} mm at most\n",
             1e3 * misses.in_plane, 1e3 * misses.off_plane, 1e3 * misses.of_clips);
  EXPECT_GT(misses.vertices, 250);
  EXPECT_LT(misses.in_plane, 0.02e-3);
  EXPECT_LT(misses.off_plane, 0.04e-3);
  EXPECT_LT(misses.of_clips, 0.06e-3);

  const auto stiffness = [&](const std::filesystem::path& study, const std::string& out) {
    const ProgramRun fit = run_program(
        {"fit", study.string(), "-o", (folder.path() / out).string(), "--json", "--quiet"});
    EXPECT_EQ(fit.status, 0) << fit.err;
    const json parameter = json::parse(fit.out)["parameters"][0];
    fmt::print("{} = {} +- {}\n", parameter["name"].dump(), parameter["value"].dump(),
               parameter["std_error"].dump());
    return parameter["value"].get<double>();
  };
  const double found = stiffness(seen / "made" / "study.yaml", "fit-seen");
  const double known = stiffness(folder.path() / "lab" / "study.yaml", "fit-truth");
  EXPECT_NEAR(found, known, 0.03 * known);
}

// The same pictures, but for one that the second camera took a frame later.
TEST(SlowVirtualRig, NamesAFrameWhosePicturesAreOfDifferentMoments) {
  const TemporaryFolder folder;
  const std::string lab = PLIANT_SOURCE_DIR "/examples/virtual-rig/lab.yaml";
  ASSERT_EQ(run_program({"lab", lab, "-o", (folder.path() / "lab").string()}).status, 0);
  const auto seen = folder.path() / "lab" / "stretch-seen";
  ASSERT_EQ(run_on(seen, {"calibrate", "rig.yaml"}, "calibration").status, 0);
  const auto pictures = seen / "pictures" / "camera2";
  std::filesystem::copy_file(pictures / "001.png", pictures / "002.png",
                             std::filesystem::copy_options::overwrite_existing);
  const ProgramRun imported = run_on(seen, {"import", "--dic", "capture.yaml"}, "made");
  ASSERT_EQ(imported.status, 0) << imported.err;
  EXPECT_THAT(imported.err, HasSubstr("1 frames are to be distrusted, first frame 2"));
  EXPECT_TRUE(std::filesystem::exists(seen / "made" / "frames.csv"));
}

TEST(VirtualRig, IsNotDrawnOfATestOverATable) {
  const TemporaryFolder folder;
  folder.write("lab.yaml", fmt::format(R"(pliant: lab/1
material: {}/examples/assumed-cloth.json
cameras: {{}}
experiments:
  - {{name: table, type: session, test: bend-weft}}
)",
                                       PLIANT_SOURCE_DIR));
  const ProgramRun run = run_on(folder.path(), {"lab", "lab.yaml"}, "lab");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("bend-weft"));
}

}  // namespace
}  // namespace pliant::test
