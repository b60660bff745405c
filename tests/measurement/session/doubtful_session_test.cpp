// What is doubtful in a session is told with the frame, clip or vertex, and what was expected.

#include <functional>
#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/measurement/session.h"

#include "support/session_sheets.h"

namespace pliant::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A change of a session, and what is said of it.
struct Doubt {
  std::string what;  ///< name of the test
  std::function<void(Session&)> change;
  std::string says, expects;  ///< parts of the warning
};

void PrintTo(const Doubt& doubt, std::ostream* out) { *out << doubt.what; }

/// All that is said of a session when it is read.
std::vector<std::string> remarks(const Session& session) {
  const Session read = read_session(SessionFolder(session).path());
  std::vector<std::string> all = read.questions;
  all.insert(all.end(), read.warnings.begin(), read.warnings.end());
  return all;
}

void expect_warning(const Doubt& doubt, Session session) {
  EXPECT_THAT(remarks(session), IsEmpty());
  doubt.change(session);
  EXPECT_THAT(remarks(session), Contains(AllOf(HasSubstr(doubt.says), HasSubstr(doubt.expects))));
}

auto each_cord(const std::function<void(CordForce&)>& change) {
  return [=](Session& session) {
    for (SessionFrame& frame : session.frames) {
      for (std::vector<CordForce>& cords : frame.cords) std::ranges::for_each(cords, change);
    }
  };
}

class DoubtfulStretch : public testing::TestWithParam<Doubt> {};

TEST_P(DoubtfulStretch, IsTold) { expect_warning(GetParam(), stretch_session()); }

const Doubt kStretchDoubts[] = {
    {"LengthsInMillimetres",
     [](Session& session) {
       session.sample.width = session.sample.height = 100;
       session.rest.positions *= 1000;
       for (SessionFrame& frame : session.frames) {
         frame.positions *= 1000;
         for (Pose& pose : frame.poses) pose.translation *= 1000;
         for (auto& cords : frame.cords) {
           for (CordForce& cord : cords) cord.point *= 1000;
         }
       }
     },
     "a side of the sheet measures 100 m: is `rest` and its frames, `width` and `height` in mm, "
     "not "
     "m",
     "(fabrics: 5 mm to 5 m)"},
    {"MassInGrams", [](Session& session) { session.sample.mass = 3.1; }, "`mass` 3.1 g, not 3.1 kg",
     "(fabrics: 8 g/m^2 to 2000 g/m^2)"},
    {"TestThatIsASlip", [](Session& session) { session.test = "strech-weft"; },
     "the test \"strech-weft\" is a name of its own", "did you mean \"stretch-weft\"?"},
    {"GravityThatIsWeak", [](Session& session) { session.gravity.z() = -1; }, "gravity is 1 m/s^2",
     "expected: 9.7 to 9.9"},
    {"GravityUpwards", [](Session& session) { session.gravity.z() *= -1; },
     "as if gravity were 9.807 m/s^2 along -z", "expected: [0, 0, 9.807]"},
    {"GravityAlongY",
     [](Session& session) {
       session.gravity = {0, -kStandardGravity, 0};
     },
     "as if gravity were 9.807 m/s^2 along -z", "expected: [0, -9.807, 0]"},
    {"ForcesWithYUp", each_cord([](CordForce& cord) {
       cord.force = Eigen::Vector3d(cord.force.x(), cord.force.z(), -cord.force.y());
     }),
     "as if gravity were 9.807 m/s^2 along -y", "in the axes of the frames"},
    {"ForcesWithoutWeights", each_cord([](CordForce& cord) { cord.force.z() = 0; }),
     "N on average, but sheet and clips weigh 0.228 N", "cords carry the weights"},
    {"ForcesInGrams", each_cord([](CordForce& cord) { cord.force *= 1000 / kStandardGravity; }),
     "out of balance in 3 of 3 frames", "at most 0.4 N, `balance_bound` of 0.1 N a cord"},
    {"ForcesInGramsAllOverTheWeight",
     each_cord([](CordForce& cord) { cord.force *= 1000 / kStandardGravity; }),
     "of the weight of sheet and clips: is `fx`, `fy`, `fz` in gf, not N", "(fabrics: 10 % to"},
    {"ForcesOfTheClipOnTheCord", each_cord([](CordForce& cord) { cord.force.head<2>() *= -1; }),
     "cords push the clips together in 2 of 3 frames, most in frame 2: by 16 N",
     "expected: forces on the clips, which pull them apart"},
    {"ForcesOfAnotherClip",
     [](Session& session) {
       for (SessionFrame& frame : session.frames) frame.cords[0].swap(frame.cords[1]);
     },
     "frame 0, clip left: a cord is attached 100 mm from this clip and 0 m from clip right",
     "expected: next to its own clip"},
    {"CordThatJumps", [](Session& session) { session.frames[1].cords[1][0].point.z() += 0.02; },
     "frame 1, clip right: cord front is attached 20 mm from its place on the clip",
     "expected: at most 5 mm"},
    {"CordThatIsMissing", [](Session& session) { session.frames[1].cords[1].pop_back(); },
     "clip right has fewer than its 2 cords in 1 of 3 frames, first in frame 1", "not known there"},
    {"VertexTakenForAnother",
     [](Session& session) { session.frames[2].positions.col(40).setZero(); },
     "in 1 of 3 frames edges are more than 3 times as long as at rest, most in frame 2: between "
     "the "
     "vertices",
     "nan for vertices that were not seen"},
    {"NothingThatHolds",
     [](Session& session) {
       session.clips.clear();
       for (SessionFrame& frame : session.frames) {
         frame.poses.clear();
         frame.cords.clear();
       }
     },
     "nothing holds the sheet", "expected: `clips` or a `table`"},
};

INSTANTIATE_TEST_SUITE_P(Doubts, DoubtfulStretch, testing::ValuesIn(kStretchDoubts),
                         [](const auto& instance) { return instance.param.what; });

class DoubtfulBend : public testing::TestWithParam<Doubt> {};

TEST_P(DoubtfulBend, IsTold) { expect_warning(GetParam(), bend_session()); }

const Doubt kBendDoubts[] = {
    {"GravityUpwards", [](Session& session) { session.gravity.z() *= -1; },
     "the sheet rises over the edge of the table in 3 of 3 frames, most in frame 2",
     "expected: it hangs down along gravity, [0, 0, 9.807]"},
    {"FramesWithZMirrored",
     [](Session& session) {
       for (SessionFrame& frame : session.frames) frame.positions.row(2) *= -1;
     },
     "the sheet rises over the edge of the table in 3 of 3 frames", "along gravity"},
    {"FramesWithExchangedAxes",
     [](Session& session) {
       for (SessionFrame& frame : session.frames) {
         frame.positions.row(0).swap(frame.positions.row(1));
       }
     },
     "vertices on the table are not at rest",
     "(it would fit with y, x, z of the frame as x, y, z)"},
    {"EdgeBeyondTheSheet", [](Session& session) { session.frames[1].table_edge = 0.78; },
     "the edge of the table is beyond the sheet in 1 of 3 frames, first in frame 1: at 780 mm",
     "expected: at most 100 mm"},
};

INSTANTIATE_TEST_SUITE_P(Doubts, DoubtfulBend, testing::ValuesIn(kBendDoubts),
                         [](const auto& instance) { return instance.param.what; });

TEST(DoubtfulSession, IsJudgedByItsOwnBoundOfBalance) {
  Session session = stretch_session();
  session.frames[1].cords[0][0].force.x() += 0.39;  // within the friction of four cords
  EXPECT_THAT(read_session(SessionFolder(session).path()).warnings, IsEmpty());
  session.balance_bound = 0.02;
  const Session read = read_session(SessionFolder(session).path());
  EXPECT_EQ(read.balance_bound, 0.02);
  EXPECT_THAT(read.warnings,
              Contains(AllOf(HasSubstr("most in frame 1: 0.39 N"),
                             HasSubstr("at most 0.08 N, `balance_bound` of 0.02 N a cord"))));
}

TEST(DoubtfulSession, WithoutCordsIsNotOutOfBalanceButSaysSo) {
  Session session = stretch_session();
  for (SessionFrame& frame : session.frames) {
    for (auto& cords : frame.cords) cords.clear();
  }
  EXPECT_THAT(read_session(SessionFolder(session).path()).warnings,
              ElementsAre(HasSubstr("no cord pulls at any clip")));
}

}  // namespace
}  // namespace pliant::test
