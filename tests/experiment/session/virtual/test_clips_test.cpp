#include "pliant/experiment/session/virtual/test_clips.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant {
namespace {

using testing::DoubleEq;
using testing::Each;
using testing::ElementsAre;

VirtualSession session_of(const char* test, int frames, int cycles) {
  VirtualSession session = usual_session(test);
  session.frames = frames;
  session.cycles = cycles;
  return session;
}

TEST(FrameLoads, TurnInAFrame) {
  EXPECT_THAT(frame_loads(session_of("shear", 5, 1)), ElementsAre(0, 0.5, 1, 0.5, 0));
  EXPECT_THAT(frame_loads(session_of("shear", 6, 1)),
              ElementsAre(0, 0.5, 1, DoubleEq(2. / 3), DoubleEq(1. / 3), 0));
  EXPECT_THAT(frame_loads(session_of("stretch-weft", 5, 2)), ElementsAre(0, 1, 0, 1, 0));
}

TEST(FrameLoads, TakeThePairsOfCornersInTurn) {
  EXPECT_THAT(frame_loads(session_of("corner-pull", 9, 2)),
              ElementsAre(0, 1, 0, -1, 0, 1, 0, -1, 0));
}

TEST(FrameLoads, GoOneWayOverATable) {
  EXPECT_THAT(frame_loads(session_of("bend-warp", 3, 1)), ElementsAre(0, 0.5, 1));
}

TEST(TestClips, PullADiagonalByTheStrainOfWhatIsBetweenThem) {
  VirtualSession session = usual_session("corner-pull");
  session.amplitude = 0.1;
  const auto clips = test_clips(session);
  ASSERT_EQ(clips.size(), 4U);
  const auto distance = [&](int a, int b, double load) {
    const TestClip &one = clips[static_cast<std::size_t>(a)],
                   &other = clips[static_cast<std::size_t>(b)];
    return (one.pivot + one.motion(load).shift - other.pivot - other.motion(load).shift).norm();
  };
  const double diagonal = 0.09 * std::sqrt(2.);
  EXPECT_NEAR(distance(0, 2, 1), 1.1 * diagonal, 1e-15);
  EXPECT_NEAR(distance(1, 3, 1), 1.002 * diagonal, 1e-15);
  EXPECT_NEAR(distance(0, 2, -1), 1.002 * diagonal, 1e-15);
  EXPECT_NEAR(distance(1, 3, -1), 1.1 * diagonal, 1e-15);
}

TEST(TestClips, AreAPictureFrameWhoseSidesKeepTheirLength) {
  VirtualSession session = usual_session("shear");
  session.initial_strain = 0;
  const auto clips = test_clips(session);
  std::vector<double> lengths;
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(2, 3)}) {
    const TestClip &one = clips[static_cast<std::size_t>(a)],
                   &other = clips[static_cast<std::size_t>(b)];
    lengths.push_back(
        (one.pivot + one.motion(1).shift - other.pivot - other.motion(1).shift).norm());
  }
  EXPECT_THAT(lengths, Each(testing::DoubleNear(0.09, 1e-15)));
  EXPECT_DOUBLE_EQ(clips[2].motion(1).turn - clips[0].motion(1).turn, session.amplitude);
}

}  // namespace
}  // namespace pliant
