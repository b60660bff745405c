// What load cells and the cords that they pull make of a frame.
#include "pliant/capture/frame_forces.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"

#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::TemporaryFolder;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A clip that one cord pulls, a row of the log a frame.
class PulledClip {
 public:
  /// @param more      of the forces, a line each
  /// @param pictures  their numbers
  explicit PulledClip(const std::string& log = "time_s,F1_N\n0,0.1\n2,1.1\n4,2.1\n",
                      const std::string& more = "", const std::vector<int>& pictures = {0, 1, 2}) {
    for (const int number : pictures) {
      for (const char* camera : {"left", "right"}) {
        folder_.write(fmt::format("{}/{:02}.png", camera, number), "");
      }
    }
    folder_.write("cells.csv", log);
    dic_ = dic_of(read_yaml(folder_.write(
        "capture.yaml",
        "pliant: dic/1\ntest: pull\nsample: {width: 40 mm, height: 80 mm, density: 0.1 kg/m^2}\n"
        "views:\n  calibration: c.json\n  pictures: {left: \"left/*.png\", right: "
        "\"right/*.png\"}\n  corners: [[0, 0], [1, 0], [1, 1], [0, 1]]\n"
        "clips: [{name: upper, side: top, labels: [0]}]\n"
        "forces:\n  data: cells.csv\n" +
            more +
            "  cells:\n    - {clip: upper, cord: front, column: F1, "
            "tare: 0.1 N, slope: 1.5, picture: left/00.png, along: [[10, 10], [90, 10]]}\n")));
    forces_ = frame_forces(dic_, {{"upper", 0, {}}});
  }

  FrameForces& forces() { return *forces_; }

 private:
  TemporaryFolder folder_;
  DicFile dic_;
  std::unique_ptr<FrameForces> forces_;
};

/// Of the one clip.
const std::vector<HeldPlace> kHeld(1);
const CordLine kLine{{0.02, 0.085, 0}, {0, 0.6, 0.8}, 0.05, 1e-3, 0.1, 2};

TEST(FrameForces, PullAlongACordAsItsCellReads) {
  PulledClip pulled;
  pulled.forces().see_cords(2, {kLine});
  SessionFrame frame;
  EXPECT_EQ(pulled.forces().add_to(frame, 2, kHeld), "");
  ASSERT_EQ(frame.cords.size(), 1U);
  ASSERT_EQ(frame.cords[0].size(), 1U);
  EXPECT_EQ(frame.cords[0][0].cord, "front");
  EXPECT_LT((frame.cords[0][0].point - kLine.from).norm(), 1e-12);
  EXPECT_LT((frame.cords[0][0].force - Eigen::Vector3d(0, 1.8, 2.4)).norm(), 1e-12);
  EXPECT_EQ(frame.time, 4);
}

// A twentieth of the largest pull; of heavy cloth what the friction of cords may take.
TEST(FrameForces, AreOutOfBalanceByAShareOfWhatPulls) {
  PulledClip pulled("time_s,F1_N\n0,0.1\n2,0.2\n4,0.3\n"),
      heavy("time_s,F1_N\n0,0.1\n2,3.1\n4,6.1\n");
  for (PulledClip* clip : {&pulled, &heavy}) clip->forces().see_cords(2, {kLine});
  EXPECT_NEAR(pulled.forces().balance_bound(), 0.05 * 0.3, 1e-12);
  EXPECT_EQ(heavy.forces().balance_bound(), kCordFriction);
}

// The first frame, in which nothing pulls, is free; one in which the cell reads a force is not.
TEST(FrameForces, AreNotKnownOfACordThatIsPointedAtLater) {
  PulledClip pulled;
  for (const int frame : {0, 1}) pulled.forces().see_cords(frame, {std::nullopt});
  pulled.forces().see_cords(2, {kLine});
  EXPECT_TRUE(pulled.forces().is_free(0));
  SessionFrame free, early;
  EXPECT_EQ(pulled.forces().add_to(free, 0, kHeld), "");
  EXPECT_TRUE(free.cords[0].empty());
  EXPECT_THAT(pulled.forces().add_to(early, 1, kHeld), HasSubstr("which is pointed at later"));
}

// Nothing pulls in the first frame, and there the cell reads a tenth of its largest force.
TEST(FrameForces, WarnOfACellThatPullsBeforeItsCordIsPointedAt) {
  PulledClip right, wrong("time_s,F1_N\n0,0.3\n2,1.1\n4,2.1\n");
  for (PulledClip* clip : {&right, &wrong}) {
    clip->forces().see_cords(0, {std::nullopt});
    for (const int frame : {1, 2}) clip->forces().see_cords(frame, {kLine});
  }
  EXPECT_THAT(right.forces().warnings({}), IsEmpty());
  EXPECT_THAT(wrong.forces().warnings({}),
              ElementsAre(AllOf(HasSubstr("the cell of the cord front of the clip upper reads"),
                                HasSubstr("in frame 0, before its cord was pointed at: is its "
                                          "tare right?"))));
}

// Steps of 2 s, photographed in their middle; the cell reads 1.5 N at most.
TEST(FrameForces, AreNotKnownWhereTheirCellIsAtItsLimit) {
  RandomStream random(1);
  std::string log = "time_s,F1_N\n";
  for (int row = 0; row <= 60; ++row) {
    const double step = std::floor(row / 20.0);
    log += fmt::format("{},{}\n", 0.1 * row, std::min(step + 2e-3 * random.normal(), 1.5));
  }
  PulledClip pulled(log, "  rate: 0.5 Hz\n  start: 1 s\n  still: 0.8 s\n");
  FrameForces& forces = pulled.forces();
  for (const int frame : {0, 1, 2}) forces.see_cords(frame, {kLine});
  SessionFrame below, beyond;
  EXPECT_EQ(forces.add_to(below, 1, kHeld), "");
  EXPECT_NEAR(below.cords[0][0].force.norm(), 1.5 * 0.9, 4e-3);  // four errors of 9 rows
  EXPECT_THAT(forces.add_to(beyond, 2, kHeld),
              HasSubstr("the cell of the cord front of the clip upper at its limit"));
  EXPECT_THAT(forces.warnings({}), ElementsAre(HasSubstr("again and again")));
  ASSERT_TRUE(forces.noise());
  EXPECT_LT(*forces.noise(), 0.1);
}

// No camera took the picture 2.
TEST(FrameForces, AreThoseOfTheMomentsThatNumbersOfPicturesTell) {
  PulledClip pulled("time_s,F1_N\n0,0.1\n3,3.1\n", "  rate: 1 Hz\n", {0, 1, 3});
  pulled.forces().see_cords(2, {kLine});
  SessionFrame frame;
  EXPECT_EQ(pulled.forces().add_to(frame, 2, kHeld), "");
  EXPECT_EQ(frame.time, 3);
  EXPECT_NEAR(frame.cords[0][0].force.norm(), 1.5 * 3, 1e-12);
}

// The log was running for 3 s when the first frame was taken. The cord pulls by 0.2 N a millimetre,
// out and back; the picture 5 is missing.
TEST(FrameForces, AreReadByTheClockThatTheWaysOfTheCordsTell) {
  const std::vector<int> numbers{0, 1, 2, 3, 4, 6, 7, 8, 9, 10, 11, 12};
  constexpr double kStart = 3;
  const auto way = [](double time) { return 1e-3 * std::max(6 - std::abs(time - 6), 0.0); };
  std::string log = "time_s,F1_N\n";
  for (int row = 0; row < 200; ++row) {
    const double time = 0.1 * row;
    log += fmt::format("{},{}\n", time, 0.1 + 200 * way(time - kStart) / 1.5);
  }
  PulledClip pulled(log, "  rate: 1 Hz\n  start: by motion\n", numbers);
  FrameForces& forces = pulled.forces();
  ASSERT_TRUE(forces.needs_clock());
  EXPECT_FALSE(forces.needs_way());
  for (std::size_t f = 0; f < numbers.size(); ++f) {
    CordLine line = kLine;
    line.from += way(numbers[f]) * line.direction;
    forces.see_cords(static_cast<int>(f), {line});
  }
  EXPECT_THAT(forces.find_clock({}), HasSubstr("by the ways of the cords"));
  EXPECT_FALSE(forces.needs_clock());
  SessionFrame frame;
  EXPECT_EQ(forces.add_to(frame, 7, kHeld), "");
  EXPECT_NEAR(*frame.time, kStart + 8, 0.01);
  EXPECT_NEAR(frame.cords[0][0].force.norm(), 200 * way(8), 2e-3);
}

}  // namespace
}  // namespace pliant
