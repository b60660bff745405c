#include "pliant/measurement/session/frame_measures.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/session_sheets.h"

namespace pliant::test {
namespace {

constexpr double kRounding = 1e-13;

const Eigen::Quaterniond kTurn = Eigen::Quaterniond(1, 0.3, -0.4, 0.7).normalized();

/// A sheet with one frame, in which the rest plane is mapped by (w_u, w_v) and then turned.
Session mapped_session(const Eigen::Vector2d& weft, const Eigen::Vector2d& warp) {
  Session session;
  session.sample = {"", 0.1, 0.1, {}, 0.2};
  session.gravity.setZero();
  session.rest = regular_grid(0.1, 0.1, 9, 9);
  SessionFrame frame;
  Eigen::Matrix2d map;
  map << weft, warp;
  frame.positions = session.rest.positions;
  frame.positions.topRows<2>() = map * session.rest.positions.topRows<2>();
  frame.positions = posed({kTurn, {0.3, 0.1, -0.2}}, frame.positions);
  session.frames = {frame};
  return session;
}

/// Adds a clip that is pulled with a force (N), in the sheet's own axes before it was turned, at
/// the middle of its vertices and `offset` (m) from there.
void add_clip(Session& session, const std::string& name, const std::vector<int>& clamped,
              const Eigen::Vector3d& force, const Eigen::Vector3d& offset = {0, 0, 0}) {
  session.clips.push_back({name, 0, clamped});
  SessionFrame& frame = session.frames[0];
  const Eigen::Vector3d middle = frame.positions(Eigen::all, clamped).rowwise().mean();
  frame.cords.push_back({{"", middle + kTurn * offset, kTurn * force}});
  frame.poses.push_back({});
}

Session session_with_four_sides(const Eigen::Vector2d& weft, const Eigen::Vector2d& warp,
                                double pull) {
  Session session = mapped_session(weft, warp);
  const TriangleMesh& rest = session.rest;
  // Tangential forces of a simple shear, in another order than around the sheet.
  add_clip(session, "right", vertices_at(rest, 0, 0.1), {0, pull, 0});
  add_clip(session, "left", vertices_at(rest, 0, 0), {0, -pull, 0});
  add_clip(session, "top", vertices_at(rest, 1, 0.1), {pull, 0, 0});
  add_clip(session, "bottom", vertices_at(rest, 1, 0), {-pull, 0, 0});
  return session;
}

TEST(EffectiveShear, IsTheAngleOfAPureShear) {
  for (const double angle : {-0.3, 0.0, 0.1, 0.7}) {
    const Session session = session_with_four_sides({1, 0}, {std::sin(angle), std::cos(angle)}, 0);
    EXPECT_NEAR(*effective_shear(session, 0), angle, kRounding);
  }
}

TEST(EffectiveShear, DoesNotDependOnStretch) {
  const Session session =
      session_with_four_sides({1.5, 0}, {0.8 * std::sin(0.2), 0.8 * std::cos(0.2)}, 0);
  EXPECT_NEAR(*effective_shear(session, 0), 0.2, kRounding);
}

TEST(EffectiveShear, SeesClampedVerticesOnly) {
  Session session = session_with_four_sides({1, 0}, {std::sin(0.2), std::cos(0.2)}, 0);
  session.frames[0].positions.col(40) += Eigen::Vector3d(0.01, 0.02, 0.03);  // in the middle
  EXPECT_NEAR(*effective_shear(session, 0), 0.2, kRounding);
}

TEST(EffectiveShear, IsNotKnownFromVerticesOnALine) {
  Session session = mapped_session({1, 0}, {0, 1});
  EXPECT_FALSE(effective_shear(session, 0).has_value()) << "without clips";
  add_clip(session, "left", vertices_at(session.rest, 0, 0), {0, 0, 0});
  EXPECT_FALSE(effective_shear(session, 0).has_value());
}

TEST(AggregatedTorque, OfASimpleShearIsThatOfAllFourSides) {
  // Four forces of 2 N, each 50 mm from the centre: those at the right and left turn one way,
  // those at the top and bottom the other.
  const Session session = session_with_four_sides({1, 0}, {0, 1}, 2);
  EXPECT_NEAR(aggregated_torque(session, 0), 4 * 2 * 0.05, kRounding);
}

TEST(AggregatedTorque, VanishesForARigidTorque) {
  Session session = session_with_four_sides({1, 0}, {0, 1}, 2);
  // The top and bottom the other way: all turn the sheet the same way.
  for (const std::size_t clip : {2U, 3U}) session.frames[0].cords[clip][0].force *= -1;
  EXPECT_NEAR(aggregated_torque(session, 0), 0, kRounding);
}

TEST(AggregatedTorque, CountsCouplesOfTwoClipsTwice) {
  // Two clips that pull past each other: in balance their torques are opposite.
  Session session = mapped_session({1, 0}, {0, 1});
  add_clip(session, "right", vertices_at(session.rest, 0, 0.1), {1, 0, 0}, {0, -0.02, 0});
  add_clip(session, "left", vertices_at(session.rest, 0, 0), {-1, 0, 0}, {0, -0.02, 0});
  EXPECT_NEAR(aggregated_torque(session, 0), 2 * 0.02, kRounding);
}

TEST(AggregatedTorque, KeepsItsSignsWhereClipsAreNotQuiteInTheMiddle) {
  for (const double v : {0.0, 0.1}) {
    Session session = mapped_session({1, 0}, {0, 1});
    // The right clip holds all but one end of its side.
    std::vector<int> right = vertices_at(session.rest, 0, 0.1);
    std::erase_if(right, [&](int i) { return std::abs(session.rest.positions(1, i) - v) < 1e-9; });
    add_clip(session, "left", vertices_at(session.rest, 0, 0), {0, 0, 0});
    add_clip(session, "right", right, {0, 1, 0});
    EXPECT_NEAR(aggregated_torque(session, 0), 0.05, kRounding) << v;
  }
}

/// Clips at the corners, pulled outwards along the diagonals.
Session corner_session(double rising, double falling) {
  Session session = mapped_session({1, 0}, {0, 1});
  const double part = std::sqrt(0.5);
  add_clip(session, "d", {80}, rising * Eigen::Vector3d(part, part, 0));
  add_clip(session, "b", {8}, falling * Eigen::Vector3d(part, -part, 0));
  add_clip(session, "a", {0}, rising * Eigen::Vector3d(-part, -part, 0));
  add_clip(session, "c", {72}, falling * Eigen::Vector3d(-part, part, 0));
  return session;
}

TEST(StretchingForceDifference, IsThatOfTheTwoDiagonals) {
  EXPECT_NEAR(*stretching_force_difference(corner_session(3, 1), 0), 2, kRounding);
  EXPECT_NEAR(*stretching_force_difference(corner_session(1, 4), 0), -3, kRounding);
}

TEST(StretchingForceDifference, TakesTheMeanOfTwoOppositeClips) {
  Session session = corner_session(3, 1);
  // 1 N more outwards at one clip: half a newton more tension.
  session.frames[0].cords[2][0].force += kTurn * Eigen::Vector3d(-1, -1, 0).normalized();
  EXPECT_NEAR(*stretching_force_difference(session, 0), 2.5, kRounding);
}

TEST(StretchingForceDifference, DoesNotSeeForcesAcross) {
  Session session = corner_session(3, 1);
  session.frames[0].cords[0][0].force += kTurn * Eigen::Vector3d(1, -1, 5);
  EXPECT_NEAR(*stretching_force_difference(session, 0), 2, kRounding);
}

TEST(StretchingForceDifference, NeedsFourCorners) {
  EXPECT_FALSE(stretching_force_difference(session_with_four_sides({1, 0}, {0, 1}, 1), 0));
  Session session = corner_session(3, 1);
  session.clips.pop_back();
  EXPECT_FALSE(stretching_force_difference(session, 0));
}

TEST(ClipExtension, AndPullAreThoseOfAStretch) {
  const Session session = stretch_session(9, 3);
  for (int f = 0; f < 3; ++f) {
    // 10 % of 100 mm and two cords of 2 N a frame; the vertical parts carry weights.
    EXPECT_NEAR(*clip_extension(session, f), 0.01 * f, kRounding);
    EXPECT_NEAR(*clip_pull(session, f), 4 * f, 1e-12);
  }
}

TEST(ClipExtension, NeedsTwoClips) {
  const Session corners = corner_session(3, 1);
  EXPECT_FALSE(clip_extension(corners, 0).has_value());
  EXPECT_FALSE(clip_pull(corners, 0).has_value());
}

}  // namespace
}  // namespace pliant::test
