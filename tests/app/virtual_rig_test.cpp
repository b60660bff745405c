// From a virtual session through the pictures that a rig of cameras takes of it to a law, by the
// program.

#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/seen_session.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

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
  const CalibrationMisses calibration = calibration_misses(seen);
  EXPECT_LT(calibration.focal, 2);  // of 2,000 pixels
  // The numbers of a rig lean on each other: an interval that misses is seldom alone.
  EXPECT_GE(calibration.held, 0.75 * calibration.numbers);
  EXPECT_LT(calibration.worst, 3.5);

  const Session truth = read_session(folder.path() / "lab" / "stretch");
  const Session session = read_session(seen / "made" / "sheet");
  ASSERT_EQ(session.frame_count(), truth.frame_count());
  EXPECT_NEAR((session.gravity - truth.gravity).norm(), 0, 0.01);
  const Misses misses = misses_of(session, truth);
  print_misses("stretch", misses);
  EXPECT_GT(misses.vertices, 250);
  EXPECT_LT(misses.in_plane, 0.02e-3);
  EXPECT_LT(misses.off_plane, 0.04e-3);
  EXPECT_EQ(misses.wrong, 0);
  EXPECT_LT(misses.of_clamped, 0.03e-3);
  EXPECT_LT(misses.of_turns, 0.1 * M_PI / 180);
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
}

TEST(SlowVirtualRig, IsCalibratedToItsErrors) {
  int held = 0, numbers = 0;
  for (const char* seed : {"1", "2", "3"}) {
    const TemporaryFolder folder;
    const std::string lab = PLIANT_SOURCE_DIR "/examples/virtual-rig/lab.yaml";
    const std::string out = (folder.path() / "lab").string();
    ASSERT_EQ(run_program({"lab", lab, "-o", out, "--seed", seed}).status, 0);
    const auto seen = folder.path() / "lab" / "stretch-seen";
    ASSERT_EQ(run_on(seen, {"calibrate", "rig.yaml"}, "calibration").status, 0);
    const CalibrationMisses calibration = calibration_misses(seen);
    held += calibration.held;
    numbers += calibration.numbers;
  }
  EXPECT_GE(held, 0.92 * numbers);
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

/// A capture.yaml with the columns of two cells exchanged.
std::string with_exchanged_cells(std::string text, const std::string& one,
                                 const std::string& other) {
  const auto column = [](const std::string& name) { return "column: \"" + name + "\""; };
  const std::size_t first = text.find(column(one)), second = text.find(column(other));
  EXPECT_LT(first, second);
  text.replace(second, column(other).size(), column(one));
  text.replace(first, column(one).size(), column(other));
  return text;
}

// The bars of a complex shear are pulled by cords of different force, there and back. Cloth with
// friction pulls less on the way back, which tells no clock.
TEST(SlowVirtualRig, TellsTheClockOfItsCellsByMotionAndExchangedOnesByTheirBalance) {
  constexpr double kFirst = 2.37, kFrame = 2;  // s, of the first picture and from one to the next
  const TemporaryFolder folder;
  folder.write("lab.yaml", fmt::format(R"(pliant: lab/1
material: {}/examples/sheet-figures/cloth.json
cameras: {{count: 3, picture: 480x520, boards: 6, log_start: {} s}}
experiments:
  - {{name: pull, type: session, test: complex-shear, displacement: 10 mm, size: 60 mm x 60 mm, frames: 7, mesh: {{edge: 3 mm}}}}
)",
                                       PLIANT_SOURCE_DIR, kFirst));
  ASSERT_EQ(run_on(folder.path(), {"lab", "lab.yaml"}, "lab").status, 0);
  const auto seen = folder.path() / "lab" / "pull-seen";
  ASSERT_EQ(run_on(seen, {"calibrate", "rig.yaml"}, "calibration").status, 0);
  const std::string text = content_of(seen / "capture.yaml");

  std::string by_motion = text;
  const std::string stated = fmt::format("start: {} s", kFirst);
  const std::size_t at = by_motion.find(stated);
  ASSERT_NE(at, std::string::npos);
  std::ofstream(seen / "by-motion.yaml")
      << by_motion.replace(at, stated.size(), "start: by motion");
  const ProgramRun imported = run_on(seen, {"import", "--dic", "by-motion.yaml"}, "by-motion");
  ASSERT_EQ(imported.status, 0) << imported.err;
  EXPECT_THAT(imported.err, HasSubstr("by the ways of the cords the first frame was taken at"));
  EXPECT_THAT(imported.err, Not(HasSubstr("out of balance")));
  const Session session = read_session(seen / "by-motion" / "sheet");
  const Session truth = read_session(folder.path() / "lab" / "pull");
  ASSERT_EQ(session.frame_count(), 7);
  // Nothing pulls in the first picture.
  const double first = *session.frames.front().time - kFrame;
  fmt::print("the first picture was taken at {:.3f} s of {:.3f} s\n", first, kFirst);
  EXPECT_NEAR(first, kFirst, 0.05);
  EXPECT_LT(cord_misses(session, truth), 0.1 * M_PI / 180);

  std::ofstream(seen / "exchanged.yaml") << with_exchanged_cells(text, "bottom-1", "top-1");
  const ProgramRun exchanged = run_on(seen, {"import", "--dic", "exchanged.yaml"}, "exchanged");
  EXPECT_EQ(exchanged.status, 0) << exchanged.err;
  EXPECT_THAT(exchanged.err,
              HasSubstr("warning: the forces on sheet and clips are out of balance"));
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
