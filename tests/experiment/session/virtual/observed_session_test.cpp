#include "pliant/experiment/session/virtual/observed_session.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/session_sheets.h"

namespace pliant::test {
namespace {

/// Frame f is 10 % longer than f - 1, then shorter again; clips do not turn.
Session there_and_back(int nodes = 9, int far = 3) {
  Session session = stretch_session(nodes, far);
  for (SessionFrame& frame : session.frames) {
    const Eigen::Quaterniond back = frame.poses[0].rotation.conjugate();
    frame.positions = back.toRotationMatrix() * frame.positions;
    for (Pose& pose : frame.poses) pose = {Eigen::Quaterniond::Identity(), back * pose.translation};
    for (auto& cords : frame.cords) {
      for (CordForce& cord : cords) cord = {cord.cord, back * cord.point, back * cord.force};
    }
  }
  for (int f = far - 2; f >= 0; --f) {
    session.frames.push_back(session.frames[static_cast<std::size_t>(f)]);
  }
  return session;
}

/// Of each cord's pull, frame by frame.
std::vector<double> pulls(const Session& session) {
  std::vector<double> result;
  for (const SessionFrame& frame : session.frames) {
    for (const auto& cords : frame.cords) {
      for (const CordForce& cord : cords) result.push_back(cord.force.norm());
    }
  }
  return result;
}

TEST(ObservedSession, ShowsTheDragOfCordsByTheWayTheyMove) {
  const Session truth = there_and_back();
  Session seen = truth;
  RandomStream random(1);
  observe({.cord_friction = 0.1}, random, seen);
  const std::vector<double> before = pulls(truth), after = pulls(seen);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::size_t frame = i / 4;
    const double drag = frame <= 2 ? 0.05 : -0.05;
    EXPECT_NEAR(after[i] - before[i], drag, 1e-15) << "frame " << frame;
  }
}

TEST(ObservedSession, KeepsTheDragOfCordsThatStop) {
  Session session = there_and_back();
  session.frames.resize(4);  // there, and a step back
  session.frames.push_back(session.frames.back());
  const double pull = session.frames[4].cords[0][0].force.norm();
  RandomStream random(1);
  observe({.cord_friction = 0.1}, random, session);
  EXPECT_NEAR(session.frames[4].cords[0][0].force.norm(), pull - 0.05, 1e-15);
}

TEST(ObservedSession, HasWhiteNoiseOfTheStatedSize) {
  const Session truth = there_and_back(31, 5);
  Session seen = truth;
  RandomStream random(7);
  observe({.position = 75e-6, .force = 3e-3}, random, seen);
  double squares = 0, count = 0;
  for (std::size_t f = 0; f < truth.frames.size(); ++f) {
    squares += (seen.frames[f].positions - truth.frames[f].positions).squaredNorm();
    count += static_cast<double>(truth.frames[f].positions.size());
  }
  // The estimate of a deviation from n numbers has the deviation 1 / sqrt(2 n): 0.4 % and 12 %.
  EXPECT_NEAR(std::sqrt(squares / count), 75e-6, 3 * 0.0045 * 75e-6);
  const std::vector<double> before = pulls(truth), after = pulls(seen);
  double force_squares = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    force_squares += std::pow(after[i] - before[i], 2);
  }
  const double forces = static_cast<double>(before.size());
  EXPECT_NEAR(std::sqrt(force_squares / forces), 3e-3, 3 * 3e-3 / std::sqrt(2 * forces));
}

TEST(ObservedSession, FitsThePosesOfClips) {
  const Session truth = there_and_back(31, 5);
  Session seen = truth;
  RandomStream random(7);
  observe({.position = 75e-6}, random, seen);
  for (std::size_t f = 0; f < truth.frames.size(); ++f) {
    for (std::size_t c = 0; c < truth.clips.size(); ++c) {
      const Pose &fitted = seen.frames[f].poses[c], &right = truth.frames[f].poses[c];
      const Eigen::Vector3d middle =
          truth.rest.positions(Eigen::all, truth.clips[c].clamped).rowwise().mean();
      // A mean of 33 points: 13 um; six such deviations.
      const double off = (fitted.apply(middle) - right.apply(middle)).norm();
      EXPECT_LT(off, 6 * 75e-6 / std::sqrt(33.));
      EXPECT_GT(off, 0);
      // About the vertical, of points that lie 29 mm from it in the mean of squares.
      const Eigen::Vector3d along =
          fitted.rotation.conjugate() * right.rotation * Eigen::Vector3d::UnitY();
      EXPECT_LT(std::abs(along.x()), 6 * 75e-6 / (0.029 * std::sqrt(33.)));
    }
  }
}

TEST(ObservedSession, IsTheTruthToIdealInstruments) {
  const Session truth = there_and_back();
  Session seen = truth;
  RandomStream random(7);
  observe({}, random, seen);
  EXPECT_TRUE(session_files(seen) == session_files(truth));
}

}  // namespace
}  // namespace pliant::test
