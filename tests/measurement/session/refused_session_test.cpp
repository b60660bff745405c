// What is wrong with a session is refused with its file and line, and the frame, clip or vertex.

#include <cmath>
#include <functional>
#include <limits>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/measurement/session.h"

#include "io/input_error_of.h"
#include "support/session_sheets.h"

namespace pliant::test {
namespace {

using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A session with a fault, and what is said of it.
struct Fault {
  std::string what;  ///< name of the test
  std::string file;  ///< that is at fault
  int line = 0;
  std::string message;                                  ///< part of the error's line
  std::function<void(Session&)> change = {};            ///< before it is written
  std::function<void(const SessionFolder&)> edit = {};  ///< afterwards
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.what; }

void expect_refused(const Fault& fault, Session session) {
  if (fault.change) fault.change(session);
  const SessionFolder folder(session);
  if (fault.edit) fault.edit(folder);
  const InputError error = input_error_of([&] { read_session(folder.path()); });
  EXPECT_EQ(error.where().file, folder.file(fault.file)) << error.what();
  EXPECT_EQ(error.where().line, fault.line) << error.what();
  EXPECT_THAT(std::string(error.what()), HasSubstr(fault.message));
}

/// An edit of a text in a file.
auto edited(std::string file, std::string from, std::string to) {
  return [=](const SessionFolder& folder) { folder.edit(file, from, to); };
}

const auto kScaled = [](double scale) {
  return [scale](Session& session) {
    session.rest.positions *= scale;
    session.rest.rest_corners *= scale;
  };
};

class RefusedStretch : public testing::TestWithParam<Fault> {};

TEST_P(RefusedStretch, NamesWhatIsAtFault) { expect_refused(GetParam(), stretch_session()); }

const Fault kStretchFaults[] = {
    {"RestInMillimetres", "rest.ply", 0,
     "the rest mesh measures 100 m x 100 m, the sample 100 mm x 100 mm (it would fit in "
     "millimetres)",
     kScaled(1000)},
    {"RestTooLarge", "rest.ply", 0, "the rest mesh measures 106 mm x 106 mm, the sample 100 mm",
     kScaled(1.06)},
    {"RestTurned", "rest.ply", 0, "(it would fit with u and v exchanged)",
     [](Session& session) {
       session.sample.width = 0.08;
       session.rest.positions.row(1) *= 0.8;
     }},
    {"RestNotFlat", "rest.ply", 0, "not flat: vertex 40 is at z = 1 mm",
     [](Session& session) { session.rest.positions(2, 40) = 1e-3; }},
    {"RestMirrored", "rest.ply", 0, "an axis is mirrored",
     [](Session& session) { session.rest.positions.row(0) *= -1; }},
    {"RestWithATurnedFace", "rest.ply", 0, "face 1 (vertices 0, 9, 10) is inverted at rest",
     [](Session& session) { session.rest.triangles.col(1).tail<2>().reverseInPlace(); }},
    {"RestMissing",
     "session.yaml",
     12,
     "does not exist",
     {},
     [](const SessionFolder& folder) { folder.remove("rest.ply"); }},
    {"OtherVertexCount",
     "frames/0001.ply",
     0,
     "frame 1 has 81 vertices; expected the 100",
     {},
     [](const SessionFolder& folder) {
       // The session of another mesh lends its rest mesh.
       const SessionFolder other(stretch_session(10));
       folder.write("rest.ply", other.content("rest.ply"));
       folder.write("frames/0000.ply", other.content("frames/0000.ply"));
     }},
    {"FewVerticesSeen", "frames/0002.ply", 0,
     "frame 2: 63 of 81 vertices have no position (vertex 18, 19, 20, 21, 22, ...); expected "
     "finite "
     "coordinates of 50 % of them at least",
     [](Session& session) { session.frames[2].positions.rightCols(63).setConstant(kNan); }},
    {"NothingSeen", "frames/0001.ply", 0, "frame 1: no edge between vertices that were seen",
     [](Session& session) { session.frames[1].positions.setConstant(kNan); }},
    {"OtherFaces",
     "frames/0001.ply",
     0,
     "frame 1: its faces are not those of the rest mesh, first face 2",
     {},
     [](const SessionFolder& folder) {
       Session other = stretch_session();
       other.rest.triangles.col(2).swap(other.rest.triangles.col(3));
       folder.write("frames/0001.ply", SessionFolder(other).content("frames/0001.ply"));
     }},
    {"FrameInMillimetres", "frames/0002.ply", 0, "frame 2: edges are",
     [](Session& session) { session.frames[2].positions *= 1000; }},
    {"FrameMissing",
     "frames/0001.ply",
     0,
     "frame 1 is missing, frame 2 is there",
     {},
     [](const SessionFolder& folder) { folder.remove("frames/0001.ply"); }},
    {"FramesFromOne",
     "frames/0000.ply",
     0,
     "frame 0 is missing, frame 1 is there",
     {},
     [](const SessionFolder& folder) { folder.remove("frames/0000.ply"); }},
    {"NoFrames",
     "session.yaml",
     13,
     "there is no file",
     {},
     edited("session.yaml", "frames/%04d.ply", "frames/%05d.ply")},
    {"ClipNeverTracked",
     "clips.csv",
     0,
     "clip right is never tracked",
     {},
     [](const SessionFolder& folder) {
       folder.write("clips.csv",
                    "frame,clip,tx,ty,tz,qw,qx,qy,qz\n0,left,0,0,0,1,0,0,0\n"
                    "1,left,0,0,0,1,0,0,0\n2,left,0,0,0,1,0,0,0\n");
     }},
    {"ClipLost",
     "clips.csv",
     0,
     "clip left has no pose in frame 1",
     {},
     edited("clips.csv", "\n1,left,", "\n# 1,left,")},
    {"PoseTwice",
     "clips.csv",
     4,
     "clip left has a pose in frame 0 already, on line 2",
     {},
     edited("clips.csv", "\n1,left,", "\n0,left,")},
    {"UnknownClip",
     "clips.csv",
     4,
     "there is no clip \"lefft\" (did you mean \"left\"?)",
     {},
     edited("clips.csv", "\n1,left,", "\n1,lefft,")},
    {"UnknownFrame",
     "clips.csv",
     4,
     "there is no frame 3; expected numbers from 0 to 2",
     {},
     edited("clips.csv", "\n1,left,", "\n3,left,")},
    {"QuaternionOfNoUnitLength", "clips.csv", 4,
     "frame 1, clip left: the quaternion has the length 1.01",
     [](Session& session) { session.frames[1].poses[0].rotation.coeffs() *= 1.01; }},
    {"ClampedOutOfRange",
     "session.yaml",
     17,
     "there is no vertex 81",
     {},
     edited("session.yaml", "clamped: [0,", "clamped: [81,")},
    {"ClampedTwice", "session.yaml", 20, "vertex 8 is in the clips left and right",
     [](Session& session) { session.clips[0].clamped.push_back(8); }},
    {"ClampedTwiceInAClip", "session.yaml", 17, "vertex 9 is listed twice in clip left",
     [](Session& session) { session.clips[0].clamped.push_back(9); }},
    {"ClampedElsewhere", "clips.csv", 6, "frame 2, clip left: vertex 36 is 3 mm from where",
     [](Session& session) { session.frames[2].positions(2, 36) += 3e-3; }},
    {"ClipMirrored", "clips.csv", 5, "frame 1, clip right: vertex 80 is",
     [](Session& session) {
       Pose& pose = session.frames[1].poses[1];
       pose.translation.y() *= -1;
       pose.rotation.z() *= -1;
     }},
    {"ClipMirroredIsExplained", "clips.csv", 4, "(the pose would fit with the x axis mirrored)",
     [](Session& session) {
       Pose& pose = session.frames[1].poses[0];
       pose.translation.x() *= -1;
       pose.rotation.y() *= -1;
       pose.rotation.z() *= -1;
     }},
    {"ClipThatStandsStill", "clips.csv", 5, "(its pose is the same in all frames: was it tracked?)",
     [](Session& session) {
       for (SessionFrame& frame : session.frames) frame.poses[1] = session.frames[0].poses[1];
     }},
    {"FramesWithExchangedAxes", "clips.csv", 2,
     "(it would fit with y, x, z of the frame as x, y, z)",
     [](Session& session) {
       for (SessionFrame& frame : session.frames)
         frame.positions.row(0).swap(frame.positions.row(1));
     }},
    {"FramesWithYUp", "clips.csv", 2, "(it would fit with x, -z, y of the frame as x, y, z)",
     [](Session& session) {
       for (SessionFrame& frame : session.frames) {
         frame.positions.row(2) *= -1;
         frame.positions.row(1).swap(frame.positions.row(2));
         frame.positions.row(2) *= -1;
       }
     }},
    {"PoseInverted", "clips.csv", 6, "(the inverse of the pose would fit)",
     [](Session& session) {
       // A turn about an axis of no particular direction, which no mirror imitates.
       const Pose turn{Eigen::Quaterniond(1, 0.2, 0.3, 0.4).normalized(), {0.01, 0.02, 0.03}};
       SessionFrame& frame = session.frames[2];
       frame.positions = posed(turn, session.rest.positions);
       const Eigen::Quaterniond back = turn.rotation.conjugate();
       for (Pose& pose : frame.poses) pose = {back, -(back * turn.translation)};
     }},
    {"CordFarAway", "cords.csv", 2, "frame 0, clip left: a cord is attached 5",
     [](Session& session) {
       session.frames[0].cords[0][0].point = {-10, 50, 0};
     }},
    {"ForceOfNoCord", "cords.csv", 5, "frame 0, clip right: a force of 1e+200 N; expected newtons",
     [](Session& session) { session.frames[0].cords[1][1].force.z() = 1e200; }},
    {"RowTwice", "cords.csv", 3, "frame 0, clip left: the same row twice",
     [](Session& session) {
       for (SessionFrame& frame : session.frames) {
         for (std::vector<CordForce>& cords : frame.cords) {
           for (CordForce& cord : cords) cord.cord.clear();
           cords[1] = cords[0];
         }
       }
     }},
    {"CordTwice", "cords.csv", 3, "frame 0, clip left: a second row of the cord \"front\"",
     [](Session& session) { session.frames[0].cords[0][1].cord = "front"; }},
    {"NoCordTable",
     "cords.csv",
     0,
     "cannot be read",
     {},
     [](const SessionFolder& folder) { folder.remove("cords.csv"); }},
    {"TwoTimes",
     "cords.csv",
     6,
     "frame 1 is at 3 s, and at 2 s in",
     {},
     [](const SessionFolder& folder) {
       std::string text = folder.content("cords.csv");
       const std::size_t row = text.find("\n1,left");
       const std::size_t end = text.find('\n', row + 1);
       text.replace(text.rfind(',', end), 2, ",3");
       folder.write("cords.csv", text);
     }},
    {"TimesThatFall", "clips.csv", 6, "frame 2 is at 1 s, not after the frame before it (2 s)",
     [](Session& session) { session.frames[2].time = 1; }},
    {"AnotherTypeOfDocument",
     "session.yaml",
     1,
     "this is a \"scene/1\" document",
     {},
     edited("session.yaml", "session/1", "scene/1")},
    {"UnknownKey",
     "session.yaml",
     2,
     "unknown key (did you mean \"kind\"?)",
     {},
     edited("session.yaml", "kind:", "kinds:")},
    {"SolidKind", "session.yaml", 2, "solid", {}, edited("session.yaml", "sheet", "solid")},
    {"NoWeight", "session.yaml", 6, "weighs nothing; expected `mass` or `density`",
     [](Session& session) { session.sample.mass.reset(); }},
    {"TableInAStretch",
     "session.yaml",
     21,
     "the test stretch-weft has no table",
     {},
     [](const SessionFolder& folder) {
       folder.write("session.yaml", folder.content("session.yaml") + "table: {edge_x: 1 mm}\n");
     }},
};

INSTANTIATE_TEST_SUITE_P(Faults, RefusedStretch, testing::ValuesIn(kStretchFaults),
                         [](const auto& instance) { return instance.param.what; });

class RefusedBend : public testing::TestWithParam<Fault> {};

TEST_P(RefusedBend, NamesWhatIsAtFault) { expect_refused(GetParam(), bend_session()); }

const Fault kBendFaults[] = {
    {"NoTable", "session.yaml", 1, "table: is missing; expected the edge of the table, `edge_y`",
     [](Session& session) {
       session.table.reset();
       for (SessionFrame& frame : session.frames) frame.table_edge.reset();
     }},
    {"TableAlongWhatIsBent", "session.yaml", 11, "has its edge along what is bent",
     [](Session& session) { session.table = RestAxis::u; }},
    {"FrameWithoutEdge",
     "table.csv",
     0,
     "frame 2 has no row",
     {},
     edited("table.csv", "\n2,", "\n# 2,")},
    {"FrameWithTwoEdges",
     "table.csv",
     4,
     "a second row of frame 1",
     {},
     edited("table.csv", "\n2,", "\n1,")},
    {"EdgeThatHoldsNothing", "table.csv", 3, "frame 1: the table holds no vertex",
     [](Session& session) { session.frames[1].table_edge = 0; }},
    {"EdgeInAnotherUnit",
     "table.csv",
     1,
     "is no unit of length",
     {},
     edited("table.csv", "edge_mm", "edge_g")},
    {"OtherFirstEdge",
     "session.yaml",
     11,
     "the edge is at 70 mm in frame 0, at 78 mm in",
     {},
     edited("session.yaml", "0.078 m", "70 mm")},
};

INSTANTIATE_TEST_SUITE_P(Faults, RefusedBend, testing::ValuesIn(kBendFaults),
                         [](const auto& instance) { return instance.param.what; });

}  // namespace
}  // namespace pliant::test
