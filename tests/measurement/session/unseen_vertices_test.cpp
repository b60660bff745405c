// Vertices that cameras did not see in some frames.

#include "pliant/measurement/session/unseen_vertices.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/experiment/session/sheet_test.h"
#include "pliant/io/ply.h"
#include "pliant/measurement/session/on_mesh.h"

#include "support/session_sheets.h"

namespace pliant::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Session read_without(Session session, int frame, const std::vector<int>& vertices) {
  session.frames[static_cast<std::size_t>(frame)].positions(Eigen::all, vertices).setConstant(kNan);
  return read_session(SessionFolder(session).path());
}

// A stretched and turned sheet is an affine image of the flat one: what continues it is exact, up
// to the faint pull of single edges.
TEST(UnseenVertices, ContinueAnAffineMap) {
  const Session session = stretch_session();
  // A hole, a corner with its neighbours, and a clamped vertex.
  const std::vector<int> unseen{9, 30, 31, 40, 41, 78, 79, 80};
  const Session read = read_without(session, 2, unseen);
  EXPECT_EQ(read.frames[2].unseen, unseen);
  EXPECT_THAT(read.frames[1].unseen, IsEmpty());
  const Eigen::Matrix3Xd error = read.frames[2].positions - session.frames[2].positions;
  EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_THAT(read.warnings, ElementsAre(HasSubstr(
                                 "in 1 of 3 frames vertices were not seen, most in frame 2: 8 of "
                                 "81 (vertex 9, 30, 31, 40, 41, ...)")));
}

// A bent sheet is smooth: of a hole of four cells the middle is wrong by less than its sag.
TEST(UnseenVertices, FollowACurve) {
  Session session = stretch_session(17, 1);
  const double radius = 0.1;
  for (auto point : session.frames[0].positions.colwise()) {
    const double y = point.y();
    point.y() = radius * std::sin(y / radius);
    point.z() = radius * (1 - std::cos(y / radius));
  }
  session.clips.clear();
  session.frames[0].poses.clear();
  session.frames[0].cords.clear();
  std::vector<int> hole;
  for (int i = 6; i <= 10; ++i) {
    for (int j = 6; j <= 10; ++j) hole.push_back(i * 17 + j);
  }
  const Session read = read_without(session, 0, hole);
  const double half = 3 * 0.1 / 16, sag = half * half / (2 * radius);
  const Eigen::Matrix3Xd error = read.frames[0].positions - session.frames[0].positions;
  EXPECT_LT(error.cwiseAbs().maxCoeff(), sag / 4);
}

TEST(UnseenVertices, LieOnTheTableWhereItHoldsThem) {
  const Session session = bend_session();
  const Session read = read_without(session, 1, {0, 1, 2, 3, 4, 5});
  EXPECT_EQ(read.frames[1].positions.leftCols(6), session.rest.positions.leftCols(6));
}

TEST(UnseenVertices, AreWrittenAsSuch) {
  const Session read = read_without(stretch_session(), 2, {40});
  const SessionFolder again(read);
  const PlyMesh ply = read_ply(again.path() / "frames/0002.ply", PlyPositions::any);
  EXPECT_TRUE(std::isnan(ply.positions[40][0]));
  EXPECT_FALSE(std::isnan(ply.positions[41][0]));
  EXPECT_THAT(read_session(again.path()).frames[2].unseen, ElementsAre(40));
}

TEST(UnseenVertices, AreNotCompared) {
  const Session read = read_without(stretch_session(), 2, {39, 40});
  const SheetTest test("stretch", read, SheetObjective::positions);
  // 7 of 9 columns are free, of 9 vertices each.
  EXPECT_EQ(test.compared(1), 63);
  EXPECT_EQ(test.compared(2), 61);
}

TEST(UnseenVertices, MakeTheNodesOfTheirTrianglesUnseen) {
  Session session = stretch_session(9, 1);
  session.frames[0].unseen = {40};  // the middle
  const Session coarse = on_mesh(session, regular_grid(0.1, 0.1, 5, 5));
  EXPECT_THAT(coarse.frames[0].unseen, ElementsAre(12)) << "every other vertex is a node";
  const Session fine = on_mesh(session, regular_grid(0.1, 0.1, 17, 17));
  // The node itself and those half-way to its neighbours.
  EXPECT_GE(fine.frames[0].unseen.size(), 5U);
  for (const int node : fine.frames[0].unseen) {
    EXPECT_LT((fine.rest.positions.col(node).head<2>() - Eigen::Vector2d(0.05, 0.05))
                  .cwiseAbs()
                  .maxCoeff(),
              0.1 / 8);
  }
}

}  // namespace
}  // namespace pliant::test
