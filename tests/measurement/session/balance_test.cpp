#include "pliant/measurement/session/balance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/measurement/session/table_edges.h"

#include "support/session_sheets.h"

namespace pliant::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Sums of some hundred forces of up to 6 N at distances of up to 0.1 m.
constexpr double kRounding = 1e-13;

TEST(SessionMasses, AddUpToTheSamples) {
  Session session = stretch_session();
  EXPECT_NEAR(vertex_masses(session).sum(), 0.0031, 1e-17);
  EXPECT_NEAR(area_density(session), 0.31, 1e-14);
  // A vertex inside stands for a square of the grid on average, one in a corner for a third or a
  // sixth of that.
  EXPECT_NEAR(vertex_masses(session)[40], 0.0031 / 64 * 4 / 3, 1e-17);

  session.sample.density = 0.2;
  EXPECT_EQ(area_density(session), 0.2) << "what is stated goes before what follows from the mass";
}

TEST(SessionBalance, IsZeroWhereCordsCarryTheWeights) {
  const Session session = stretch_session();
  for (int frame = 0; frame < session.frame_count(); ++frame) {
    const Imbalance left = imbalance(session, frame);
    EXPECT_LT(left.force.norm(), kRounding);
    EXPECT_LT(left.moment.norm(), kRounding);
  }
  EXPECT_THAT(balance_warnings(session), IsEmpty());
}

TEST(SessionBalance, IsTheForceThatACordHasTooMuch) {
  Session session = stretch_session();
  const Eigen::Vector3d more(0.1, -0.2, 0.4);
  CordForce& cord = session.frames[1].cords[1][0];
  cord.force += more;
  const Imbalance left = imbalance(session, 1);
  EXPECT_LT((left.force - more).norm(), kRounding);
  EXPECT_LT((left.moment - (cord.point - sheet_centre(session, 1)).cross(more)).norm(), kRounding);
  EXPECT_NEAR(left.force_bound, 0.4, 1e-15) << "0.1 N for each of four cords";
}

TEST(SessionBalance, HasAClipsWeightAtTheMiddleOfItsVertices) {
  Session session = stretch_session();
  session.clips[1].mass += 0.01;
  const Eigen::Vector3d more = 0.01 * session.gravity;
  const Imbalance left = imbalance(session, 1);
  EXPECT_LT((left.force - more).norm(), kRounding);
  // In frame 1 the sheet is 110 mm long, and turned.
  const Eigen::Vector3d arm = session.frames[1].poses[1].rotation * Eigen::Vector3d(0.055, 0, 0);
  EXPECT_LT((left.moment - arm.cross(more)).norm(), kRounding);
}

TEST(SessionBalance, OfMomentsSeesAPairOfForces) {
  Session session = stretch_session();
  // A couple about the vertical: 1 N at a distance of 110 mm.
  session.frames[1].cords[0][0].force += Eigen::Vector3d(0, 1, 0);
  session.frames[1].cords[1][0].force -= Eigen::Vector3d(0, 1, 0);
  const Eigen::Vector3d arm =
      session.frames[1].cords[0][0].point - session.frames[1].cords[1][0].point;
  const Imbalance left = imbalance(session, 1);
  EXPECT_LT(left.force.norm(), kRounding);
  EXPECT_NEAR(left.moment.z(), arm.x(), kRounding);
  EXPECT_FALSE(left.is_within_bounds());
}

TEST(SessionBalance, WarnsOfTheWorstFrameWithItsSize) {
  Session session = stretch_session();
  session.frames[0].cords[0][0].force.x() += 0.39;  // within the friction of four cords
  session.frames[1].cords[0][0].force.x() += 0.5;
  session.frames[2].cords[1][1].force.x() += 0.7;
  const std::vector<std::string> warnings = balance_warnings(session);
  ASSERT_FALSE(warnings.empty());
  EXPECT_THAT(warnings[0],
              HasSubstr("forces on sheet and clips are out of balance in 2 of 3 frames, "
                        "most in frame 2: 0.7 N"));
  EXPECT_THAT(warnings[0], HasSubstr("at most 0.4 N"));
}

TEST(SessionBalance, IsNotJudgedOnATable) {
  EXPECT_THAT(balance_warnings(bend_session()), IsEmpty());
}

TEST(SessionBalance, WarnsOfAMassThatIsNotTheDensitys) {
  Session session = stretch_session();
  session.sample.density = 0.62;
  EXPECT_THAT(balance_warnings(session),
              testing::Contains(HasSubstr("6.2 g by its density and 3.1 g by its mass")));
}

TEST(SessionTable, HoldsWhatIsBelowItsEdge) {
  const Session session = bend_session();
  // 11 rows of 6 vertices, 10 mm apart; edges at 78, 68 and 58 mm.
  EXPECT_EQ(held_by_table(session, 0).size(), 8 * 6U);
  EXPECT_EQ(held_by_table(session, 1).size(), 7 * 6U);
  EXPECT_EQ(held_by_table(session, 2).back(), 35);
  EXPECT_THAT(held_by_table(stretch_session(), 0), IsEmpty());
}

TEST(SessionTable, WarnsOfVerticesThatLeaveIt) {
  Session session = bend_session();
  EXPECT_THAT(table_warnings(session), IsEmpty());
  session.frames[1].positions(2, 12) += 2e-3;
  EXPECT_THAT(
      table_warnings(session),
      ElementsAre(HasSubstr("in 1 of 3 frames vertices on the table are not at rest, most in "
                            "frame 1: vertex 12 is 2 mm")));
}

}  // namespace
}  // namespace pliant::test
