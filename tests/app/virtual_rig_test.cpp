// From a virtual session through the pictures that a rig of cameras takes of it to a law, by the
// program.

#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/geometry/triangle_mesh.h"
#include "pliant/measurement/session.h"

#include "app/run_program.h"
#include "support/asked_for.h"

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
  /// Root mean squares of a frame, the worst of all; the largest of vertices and of clips (m).
  double in_plane = 0, off_plane = 0, largest = 0, of_clips = 0;
  int vertices = 0, unseen = 0;  ///< of all frames, those unseen among them
};

/// Whether a place of the rest plane is in a clip, or 2 mm beside it.
bool is_beside_clip(const Session& session, const Eigen::Vector2d& rest) {
  constexpr double kBeside = 2e-3;
  return std::ranges::any_of(session.clips, [&](const SessionClip& clip) {
    Eigen::AlignedBox2d box;
    for (const int vertex : clip.clamped) {
      box.extend(session.rest.positions.col(vertex).head<2>());
    }
    return box.exteriorDistance(rest) < kBeside;
  });
}

/// By how much what was seen misses what was there, without 2 mm beside clips.
Misses misses_of(const Session& seen, const Session& truth) {
  Misses misses;
  for (int f = 0; f < seen.frame_count(); ++f) {
    const SessionFrame& frame = seen.frames[f];
    double in_plane = 0, off_plane = 0;
    int vertices = 0;
    for (int v = 0; v < seen.rest.vertex_count(); ++v) {
      const Eigen::Vector2d rest = seen.rest.positions.col(v).head<2>();
      const Eigen::Vector3d off = frame.positions.col(v) - place_in(truth, truth.frames[f], rest);
      const bool clamped = std::ranges::any_of(seen.clips, [&](const SessionClip& clip) {
        return std::ranges::find(clip.clamped, v) != clip.clamped.end();
      });
      if (clamped) misses.of_clips = std::max(misses.of_clips, off.norm());
      if (is_beside_clip(truth, rest)) continue;
      ++misses.vertices;
      if (std::ranges::binary_search(frame.unseen, v)) {
        ++misses.unseen;
        continue;
      }
      in_plane += off.head<2>().squaredNorm() / 2;
      off_plane += off.z() * off.z();
      misses.largest = std::max(misses.largest, off.norm());
      ++vertices;
    }
    misses.in_plane = std::max(misses.in_plane, std::sqrt(in_plane / vertices));
    misses.off_plane = std::max(misses.off_plane, std::sqrt(off_plane / vertices));
  }
  return misses;
}

void print_misses(const std::string& name, const Misses& misses) {
  fmt::print(
      "{}: in plane {:.4f} mm, off it {:.4f} mm (worst frame), {:.3f} mm at most; clips {:.4f} mm "
      "at most; {:.1f} % of the vertices seen\n",
      name, 1e3 * misses.in_plane, 1e3 * misses.off_plane, 1e3 * misses.largest,
      1e3 * misses.of_clips, 100.0 - 100.0 * misses.unseen / misses.vertices);
}

/// The largest angle between cords that were seen and those that pulled (rad).
double cord_misses(const Session& seen, const Session& truth) {
  double most = 0;
  for (int f = 0; f < seen.frame_count(); ++f) {
    for (std::size_t c = 0; c < seen.clips.size(); ++c) {
      EXPECT_EQ(seen.frames[f].cords[c].size(), truth.frames[f].cords[c].size());
      for (const CordForce& cord : truth.frames[f].cords[c]) {
        const auto found = std::ranges::find(seen.frames[f].cords[c], cord.cord, &CordForce::cord);
        if (found == seen.frames[f].cords[c].end()) return M_PI;
        most = std::max(most, std::asin(found->force.cross(cord.force).norm() /
                                        (found->force.norm() * cord.force.norm())));
        EXPECT_NEAR(found->force.norm(), cord.force.norm(), 3e-3) << cord.cord;
      }
    }
  }
  fmt::print("cords within {:.3f} deg\n", most * 180 / M_PI);
  return most;
}

ProgramRun run_on(const std::filesystem::path& folder, std::vector<std::string> arguments,
                  const std::string& out) {
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (arguments[i].front() != '-') arguments[i] = (folder / arguments[i]).string();
  }
  arguments.insert(arguments.end(), {"-o", (folder / out).string()});
  return run_program(arguments);
}

/// The same pictures, but for one that the second camera took a frame later.
void expect_pictures_of_different_moments_named(const std::filesystem::path& seen) {
  const auto pictures = seen / "pictures" / "camera2";
  std::filesystem::copy_file(pictures / "001.png", pictures / "002.png",
                             std::filesystem::copy_options::overwrite_existing);
  const ProgramRun imported = run_on(seen, {"import", "--dic", "capture.yaml"}, "remade");
  ASSERT_EQ(imported.status, 0) << imported.err;
  EXPECT_THAT(imported.err, HasSubstr("1 frames are to be distrusted, first frame 2"));
  EXPECT_TRUE(std::filesystem::exists(seen / "remade" / "frames.csv"));
  const std::string report = content_of(seen / "remade" / "quality.html");
  EXPECT_THAT(report,
              HasSubstr("3 of 4 frames are in the session. 1 of them are to be distrusted"));
  EXPECT_THAT(report, HasSubstr("camera2, frame 3"));
  EXPECT_THAT(report, HasSubstr("Cameras against each other"));
  EXPECT_THAT(report, HasSubstr("the sample lies on something"));
  EXPECT_THAT(report, HasSubstr("pictures were of different moments"));
}

/// The same, but for the second cell of the file, which points where the first does.
void expect_cells_of_one_cord_refused(const std::filesystem::path& seen) {
  std::string text = content_of(seen / "capture.yaml");
  const std::size_t first = text.find("picture: ", text.find("cells:"));
  const std::size_t second = text.find("picture: ", first + 1);
  const std::string pointed = text.substr(first, text.find('}', first) - first);
  text.replace(second, text.find('}', second) - second, pointed);
  std::ofstream(seen / "one-cord.yaml") << text;
  const ProgramRun imported = run_on(seen, {"import", "--dic", "one-cord.yaml"}, "one-cord");
  EXPECT_EQ(imported.status, 2);
  EXPECT_THAT(imported.err,
              HasSubstr("points to the cord of another cell, the cord 1 of the clip bottom"));
}

TEST(SlowVirtualRig, SeesASheetAsItIsTellsItsLawAndNamesAFrameOfDifferentMoments) {
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
  print_misses("stretch", misses);
  EXPECT_GT(misses.vertices, 250);
  EXPECT_LT(misses.in_plane, 0.02e-3);
  EXPECT_LT(misses.off_plane, 0.04e-3);
  EXPECT_LT(misses.of_clips, 0.05e-3);
  EXPECT_LT(cord_misses(session, truth), 0.1 * M_PI / 180);
  ASSERT_TRUE(session.noise.force);
  EXPECT_LT(*session.noise.force, 5e-3);

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
  expect_cells_of_one_cord_refused(seen);
  expect_pictures_of_different_moments_named(seen);
}

/// A copy of a lab's study whose sessions are those that were seen.
void write_study_of_seen(const std::filesystem::path& lab) {
  std::string text = content_of(lab / "study.yaml");
  const std::string data = "data: \"";
  for (std::size_t at = text.find(data); at != std::string::npos; at = text.find(data, at + 1)) {
    text.insert(text.find('"', at + data.size()), "-seen/made/sheet");
  }
  std::ofstream(lab / "seen.yaml") << text;
}

void print_law(const std::filesystem::path& study, const std::filesystem::path& out) {
  const ProgramRun fit =
      run_program({"fit", study.string(), "-o", out.string(), "--json", "--quiet"});
  ASSERT_EQ(fit.status, 0) << fit.err;
  fmt::print("{}:\n", study.filename().string());
  const json result = json::parse(fit.out);
  for (const json& parameter : result["parameters"]) {
    fmt::print("  {} = {} +- {}\n", parameter["name"].dump(), parameter["value"].dump(),
               parameter["std_error"].dump());
  }
}

// The rig of the thesis, [T] 3.2.1.
TEST(SlowVirtualRig, SeesTheTestsOfTheThesis) {
  if (!makes_figures()) GTEST_SKIP() << "makes a table of docs/results.md: ./dev figures";
  const TemporaryFolder folder;
  std::string lab = fmt::format(
      "pliant: lab/1\nname: rig\nmaterial: {}/examples/assumed-cloth.json\ncameras: {{}}\n"
      "experiments:\n",
      PLIANT_SOURCE_DIR);
  const std::vector<std::pair<std::string, std::string>> tests{
      {"stretch-weft", "strain: 8 %, frames: 9, noise: {force: 3 mN}"},
      {"stretch-warp", "strain: 8 %, frames: 9, noise: {force: 3 mN}"},
      {"shear", "angle: 15 deg, frames: 9, noise: {force: 3 mN}"},
      {"bend-weft", "overhang: 70 mm, frames: 7"},
      {"bend-warp", "overhang: 70 mm, frames: 7"},
      {"corner-pull", "frames: 6"},
      {"complex-shear", "frames: 6"}};
  for (const auto& [test, options] : tests) {
    lab += fmt::format(
        "  - {{name: {0}, type: session, test: {0}, size: 100 mm x 100 mm, {1}, "
        "mesh: {{edge: 1.5 mm}}}}\n",
        test, options);
  }
  lab += "validate: [complex-shear, corner-pull]\n";
  folder.write("lab.yaml", lab);
  ASSERT_EQ(run_on(folder.path(), {"lab", "lab.yaml"}, "lab").status, 0);
  for (const auto& [test, options] : tests) {
    const auto seen = folder.path() / "lab" / (test + "-seen");
    ASSERT_EQ(run_on(seen, {"calibrate", "rig.yaml"}, "calibration").status, 0);
    const ProgramRun imported = run_on(seen, {"import", "--dic", "capture.yaml"}, "made");
    ASSERT_EQ(imported.status, 0) << imported.err;
    const Session session = read_session(seen / "made" / "sheet");
    const Session truth = read_session(folder.path() / "lab" / test);
    print_misses(test, misses_of(session, truth));
    if (!session.table) cord_misses(session, truth);
  }
  write_study_of_seen(folder.path() / "lab");
  print_law(folder.path() / "lab" / "seen.yaml", folder.path() / "fit-seen");
  print_law(folder.path() / "lab" / "study.yaml", folder.path() / "fit-truth");
}

TEST(SlowVirtualRig, SeesASheetThatHangsOverATable) {
  const TemporaryFolder folder;
  folder.write("lab.yaml", fmt::format(R"(pliant: lab/1
material: {}/examples/assumed-cloth.json
cameras: {{count: 3, picture: 640x480, boards: 8, bits: 12}}
experiments:
  - {{name: bend, type: session, test: bend-weft, size: 60 mm x 40 mm, overhang: 30 mm, frames: 3, mesh: {{edge: 2 mm}}}}
)",
                                       PLIANT_SOURCE_DIR));
  ASSERT_EQ(run_on(folder.path(), {"lab", "lab.yaml"}, "lab").status, 0);
  const auto seen = folder.path() / "lab" / "bend-seen";
  ASSERT_EQ(run_on(seen, {"calibrate", "rig.yaml"}, "calibration").status, 0);
  const ProgramRun imported = run_on(seen, {"import", "--dic", "capture.yaml"}, "made");
  ASSERT_EQ(imported.status, 0) << imported.err;
  const Session session = read_session(seen / "made" / "sheet");
  const Session truth = read_session(folder.path() / "lab" / "bend");
  ASSERT_EQ(session.frame_count(), 3);
  for (std::size_t f = 0; f < 3; ++f) {
    EXPECT_NEAR(*session.frames[f].table_edge, *truth.frames[f].table_edge, 0.02e-3) << f;
  }
  const Misses misses = misses_of(session, truth);
  print_misses("bend", misses);
  EXPECT_LT(misses.in_plane, 0.02e-3);
  EXPECT_LT(misses.off_plane, 0.06e-3);  // facets of 2 mm are drawn
  EXPECT_LT(misses.unseen, 0.15 * misses.vertices);
}

TEST(VirtualRig, IsNotDrawnOfASheetThatIsCutAskew) {
  const TemporaryFolder folder;
  folder.write("lab.yaml", fmt::format(R"(pliant: lab/1
material: {}/examples/assumed-cloth.json
cameras: {{}}
experiments:
  - {{name: bias, type: session, test: bias-extension}}
)",
                                       PLIANT_SOURCE_DIR));
  const ProgramRun run = run_on(folder.path(), {"lab", "lab.yaml"}, "lab");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("bias-extension"));
}

}  // namespace
}  // namespace pliant::test
