// Sessions are read as they were written, and as people and other programs write them.

#include "pliant/measurement/session.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/input_error_of.h"
#include "support/session_sheets.h"

namespace pliant::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

void expect_same_frame(const SessionFrame& read, const SessionFrame& written) {
  EXPECT_EQ(read.positions, written.positions);
  EXPECT_EQ(read.deviations, written.deviations);
  EXPECT_EQ(read.time, written.time);
  ASSERT_EQ(read.poses.size(), written.poses.size());
  for (std::size_t c = 0; c < read.poses.size(); ++c) {
    EXPECT_EQ(read.poses[c].translation, written.poses[c].translation);
    EXPECT_EQ(read.poses[c].rotation.coeffs(), written.poses[c].rotation.coeffs());
    ASSERT_EQ(read.cords[c].size(), written.cords[c].size());
    for (std::size_t i = 0; i < read.cords[c].size(); ++i) {
      EXPECT_EQ(read.cords[c][i].cord, written.cords[c][i].cord);
      EXPECT_EQ(read.cords[c][i].point, written.cords[c][i].point);
      EXPECT_EQ(read.cords[c][i].force, written.cords[c][i].force);
    }
  }
}

void expect_same(const Session& read, const Session& written) {
  EXPECT_EQ(read.test, written.test);
  EXPECT_EQ(read.info, written.info);
  EXPECT_EQ(read.sample.id, written.sample.id);
  EXPECT_EQ(read.sample.width, written.sample.width);
  EXPECT_EQ(read.sample.height, written.sample.height);
  EXPECT_EQ(read.sample.mass, written.sample.mass);
  EXPECT_EQ(read.sample.density, written.sample.density);
  EXPECT_EQ(read.gravity, written.gravity);
  EXPECT_EQ(read.rest.positions, written.rest.positions);
  EXPECT_EQ(read.rest.triangles, written.rest.triangles);
  EXPECT_EQ(read.rest.rest_corners, written.rest.rest_corners);
  EXPECT_EQ(read.table, written.table);
  ASSERT_EQ(read.clips.size(), written.clips.size());
  for (std::size_t c = 0; c < read.clips.size(); ++c) {
    EXPECT_EQ(read.clips[c].name, written.clips[c].name);
    EXPECT_EQ(read.clips[c].mass, written.clips[c].mass);
    EXPECT_EQ(read.clips[c].clamped, written.clips[c].clamped);
  }
  ASSERT_EQ(read.frame_count(), written.frame_count());
  for (int f = 0; f < read.frame_count(); ++f) {
    SCOPED_TRACE(f);
    expect_same_frame(read.frames[f], written.frames[f]);
  }
}

TEST(Session, ComesBackBitForBit) {
  Session session = stretch_session();
  session.gravity = {0.1, 1.0 / 3, -9.81};
  session.frames[1].cords[0].pop_back();
  const SessionFolder folder(session);
  expect_same(read_session(folder.path()), session);
}

TEST(Session, WithoutNamesOfCordsAndTimesComesBackBitForBit) {
  Session session = stretch_session();
  for (SessionFrame& frame : session.frames) {
    frame.time.reset();
    for (auto& cords : frame.cords) {
      for (CordForce& cord : cords) cord.cord.clear();
    }
  }
  const SessionFolder folder(session);
  EXPECT_EQ(folder.content("cords.csv").substr(0, 29), "frame,clip,px,py,pz,fx,fy,fz\n");
  expect_same(read_session(folder.path()), session);
}

TEST(Session, KeepsTheNoiseThatItStates) {
  Session session = stretch_session();
  session.noise = {7.5e-5, {}};
  EXPECT_EQ(read_session(SessionFolder(session).path()).noise.position, 7.5e-5);
  EXPECT_FALSE(read_session(SessionFolder(session).path()).noise.force.has_value());
}

TEST(Session, KeepsHowSureItsPositionsAre) {
  Session session = stretch_session();
  for (SessionFrame& frame : session.frames) {
    frame.deviations = Eigen::Matrix3Xd::Constant(3, frame.positions.cols(), 2e-5);
    frame.deviations(2, 3) = 7e-5;
  }
  expect_same(read_session(SessionFolder(session).path()), session);
  session.frames[1].deviations(0, 4) = 0;
  const SessionFolder unsure(session);
  const InputError error = input_error_of([&] { read_session(unsure.path()); });
  EXPECT_THAT(error.what(), HasSubstr("frame 1: vertex 4 was seen, with a deviation of 0"));
}

TEST(Session, OfABendTestComesBack) {
  const Session session = bend_session();
  const SessionFolder folder(session);
  const Session read = read_session(folder.path());
  expect_same(read, session);
  EXPECT_THAT(read.warnings, IsEmpty());
  for (int f = 0; f < session.frame_count(); ++f) {
    // A product with 1e-3 does not reach every double.
    EXPECT_DOUBLE_EQ(*read.frames[f].table_edge, *session.frames[f].table_edge);
  }
  EXPECT_EQ(folder.content("cords.csv"), "frame,clip,px,py,pz,fx,fy,fz\n");
  EXPECT_EQ(folder.content("clips.csv"), "frame,clip,tx,ty,tz,qw,qx,qy,qz\n");
}

TEST(Session, KeepsEdgesThatWereReadInMillimetres) {
  const SessionFolder folder(bend_session());
  folder.write("table.csv", "frame,edge_mm\n0,78.01\n1,67.777\n2,57.9999\n");
  const Session read = read_session(folder.path());
  EXPECT_DOUBLE_EQ(*read.frames[1].table_edge, 0.067777);
  const SessionFolder again(read);
  for (int f = 0; f < read.frame_count(); ++f) {
    EXPECT_EQ(read_session(again.path()).frames[f].table_edge, read.frames[f].table_edge);
  }
}

/// A square of two triangles as people write it, in ASCII.
std::string ascii_square(double stretch, const std::string& faces) {
  return fmt::format(
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
             "property float z\n{}end_header\n0 0 0\n{} 0 0\n{} 0.1 0\n0 0.1 0\n",
             faces.empty() ? "" : "element face 1\nproperty list uchar int vertex_indices\n",
             0.1 * stretch, 0.1 * stretch) +
         faces;
}

TEST(Session, IsReadAsPeopleWriteIt) {
  const TemporaryFolder folder;
  folder.write("session.yaml",
               "pliant: session/1\ntest: my-pull\n"
               "sample: {width: 100 mm, height: 10 cm, mass: 3.1 g}\n"
               "rest: sheet.ply\nframes: shape%d.ply\n"
               "clips: [{name: left, mass: 1.9 g, clamped: left.txt}]\n");
  folder.write("left.txt", "0 # lower\n3\n");
  folder.write("sheet.ply", ascii_square(1, "4 0 1 2 3\n"));
  folder.write("shape0.ply", ascii_square(1, "4 0 1 2 3\n"));
  folder.write("shape1.ply", ascii_square(1.2, ""));
  folder.write("cords.csv", "fx;fy;fz;px;py;pz;clip;frame;gauge\n-1,5;0;0;-0,01;0,05;0;left;1;A\n");
  folder.write("clips.csv",
               "frame,time_s,clip,qw,qx,qy,qz,tx,ty,tz\n0,0.5,left,1,0,0,0,0,0,0\n"
               "1,2.5,left,0.9999,0,0,0,0,0,0\n");
  const Session session = read_session(folder.path());
  EXPECT_EQ(session.test, "my-pull");
  EXPECT_EQ(session.gravity, Eigen::Vector3d(0, 0, -kStandardGravity));
  EXPECT_EQ(session.rest.triangle_count(), 2);
  EXPECT_NEAR(rest_area(session.rest), 0.01, 1e-8);  // single precision
  EXPECT_THAT(session.clips[0].clamped, ElementsAre(0, 3));
  EXPECT_EQ(session.frames[1].positions(0, 1), double(0.12f));
  EXPECT_EQ(session.frames[0].time, 0.5);
  EXPECT_EQ(session.frames[1].time, 2.5);
  EXPECT_THAT(session.frames[0].cords[0], IsEmpty());
  EXPECT_EQ(session.frames[1].cords[0][0].force, Eigen::Vector3d(-1.5, 0, 0));
  EXPECT_DOUBLE_EQ(session.frames[1].poses[0].rotation.norm(), 1);
  EXPECT_THAT(session.warnings, Contains(HasSubstr("not used: \"gauge\"")));
}

TEST(Session, MayHaveNoClips) {
  Session session = bend_session(1);
  session.test = "drape";
  session.table.reset();
  session.frames[0].table_edge.reset();
  const SessionFolder folder(session);
  const Session read = read_session(folder.path());
  EXPECT_THAT(read.clips, IsEmpty());
  EXPECT_THAT(read.warnings, Contains(HasSubstr("nothing holds the sheet")));
}

TEST(Session, WarnsOfATableThatItsDocumentDoesNotKnow) {
  const SessionFolder folder(stretch_session());
  folder.write("table.csv", "frame,edge_mm\n0,78\n");
  EXPECT_THAT(read_session(folder.path()).warnings,
              ElementsAre(HasSubstr("table.csv is not used")));
}

TEST(Session, IsWrittenWholeAndOverItsOwnFilesOnly) {
  const TemporaryFolder folder;
  const std::filesystem::path directory = folder.path() / "session";
  write_session(directory, stretch_session(9, 3));
  write_session(directory, stretch_session(9, 2));
  EXPECT_EQ(read_session(directory).frame_count(), 2) << "frame 2 of before is gone";

  folder.write("mine/notes.txt", "mine");
  input_error_of([&] { write_session(folder.path() / "mine", stretch_session()); });
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "mine" / "session.yaml"));
  EXPECT_EQ(content_of(folder.path() / "mine" / "notes.txt"), "mine");
}

}  // namespace
}  // namespace pliant::test
