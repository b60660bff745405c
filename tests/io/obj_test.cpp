#include "pliant/io/obj.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/input_error_of.h"

namespace pliant {
namespace {

using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, ReadsVerticesTexturePointsAndFaces) {
  const ObjMesh mesh = parse_obj(kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1 3 4\n", "a");
  EXPECT_THAT(mesh.positions, SizeIs(4));
  EXPECT_EQ(mesh.positions[2], (Point3{1, 1, 0}));
  EXPECT_THAT(mesh.texture_points, SizeIs(3));
  EXPECT_THAT(mesh.faces.corners, ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_THAT(mesh.texture_corners, ElementsAre(0, 1, 2, -1, -1, -1));
  EXPECT_THAT(mesh.face_lines, ElementsAre(8, 9));
  EXPECT_THAT(mesh.vertex_lines, ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(mesh.ignored, IsEmpty());
}

TEST(Obj, TakesEveryFormOfACorner) {
  const std::string points = kSquare + "vt 0 0\nvt 1 1\nvn 0 0 1\n";
  EXPECT_THAT(parse_obj(points + "f 1 2 3 4\n", "a").faces.corners, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(parse_obj(points + "f -4 -3 -2\n", "a").faces.corners, ElementsAre(0, 1, 2));
  EXPECT_THAT(parse_obj(points + "f 1//1 2//1 3//1\n", "a").texture_corners, IsEmpty());
  EXPECT_THAT(parse_obj(points + "f 1/2/1 2/-2/1 3/1\n", "a").texture_corners,
              ElementsAre(1, 0, 0));
  // Negative numbers count back from where they stand.
  EXPECT_THAT(parse_obj(kSquare + "f -1 -2 -3\nv 5 5 5\n", "a").faces.corners,
              ElementsAre(3, 2, 1));
}

TEST(Obj, LeavesOutWhatItDoesNotKnowAndSaysSo) {
  const ObjMesh mesh =
      parse_obj("\xEF\xBB\xBF# a comment\r\nmtllib a.mtl\r\no cloth\r\n" + kSquare +
                    "v 2 2 2 1.0\nv 3 3 3 0.5 0.5 0.5 # colour\n" +
                    "vn 0 0 1\nvn 0 0 1\nvt 0.5\nvt 0.5 0.5 0\ng front\n" + "f 1 2 \\\n 3 4\n",
                "a.obj");
  EXPECT_THAT(mesh.positions, SizeIs(6));
  EXPECT_THAT(mesh.texture_points, SizeIs(2));
  EXPECT_THAT(mesh.faces.corners, SizeIs(4));
  EXPECT_THAT(mesh.face_lines, ElementsAre(15));
  EXPECT_THAT(mesh.ignored, ElementsAre(Pair("mtllib", 1), Pair("o", 1), Pair("vn", 2)));
}

TEST(Obj, TellsTheVerticesOfItsGroups) {
  const ObjMesh mesh = parse_obj(kSquare +
                                     "f 1 2 3\ng collar front\nf 1 3 4\np 2\n"
                                     "g hem\np -1 1\ng\nf 1 2 4\n",
                                 "a.obj");
  EXPECT_THAT(mesh.groups,
              ElementsAre(Pair("collar", ElementsAre(0, 1, 2, 3)),
                          Pair("front", ElementsAre(0, 1, 2, 3)), Pair("hem", ElementsAre(0, 3))));
}

TEST(Obj, RefusesPointsThatAreNotThereWithTheirLine) {
  for (const char* point : {"0", "5", "-5", "x"}) {
    const InputError error =
        input_error_of([&] { parse_obj(kSquare + "g a\np " + point + "\n", "a.obj"); });
    EXPECT_EQ(error.where().line, 6) << point;
  }
}

TEST(Obj, ComesBackToTheBit) {
  ObjMesh mesh;
  mesh.positions = {{1.0 / 3, -0.0, 1e-310}, {std::sqrt(2.0), 1e300, 0.1}, {1, 2, 3}, {4, 5, 6}};
  mesh.texture_points = {{1.0 / 7, 0.3}, {-2e-9, 1}, {5, 5}};
  mesh.faces.add(std::vector{0, 1, 2});
  mesh.faces.add(std::vector{3, 2, 1, 0});
  mesh.texture_corners = {0, 1, 2, -1, 1, 0, 2};
  const ObjMesh read = parse_obj(write_obj(mesh), "a.obj");
  EXPECT_EQ(read.positions, mesh.positions);
  EXPECT_TRUE(std::signbit(read.positions[0][1]));
  EXPECT_EQ(read.texture_points, mesh.texture_points);
  EXPECT_EQ(read.faces, mesh.faces);
  EXPECT_EQ(read.texture_corners, mesh.texture_corners);
}

TEST(Obj, RefusesABadLineByItsNumber) {
  struct Bad {
    std::string text;
    int line;
    std::string problem;
  };
  const Bad cases[] = {
      {"", 0, "no vertices"},
      {"solid a\nfacet normal 0 0 1\n", 0, "no vertices"},
      {"v 0 0\n", 1, "not a finite number"},
      {"v 0 0 nan\n", 1, "\"nan\" is not a finite number"},
      {"v 0 0 0 1 1 1 1 1\n", 1, "too many numbers"},
      {"v 0 0 0\nvt 0 0 0 0\n", 2, "too many numbers"},
      {kSquare + "f 1 2\n", 5, "2 corners"},
      {kSquare + "f 1 2 0\n", 5, "corner \"0\""},
      {kSquare + "f 1 2 three\n", 5, "corner \"three\""},
      {kSquare + "f 1 2 3/\\\n/x\n", 5, "corner \"/x\""},
      {kSquare + "f 1 2 3/1/1/1\n", 5, "corner \"3/1/1/1\""},
      {kSquare + "f 1 2 5\nf 1 2 3\n", 5, "no vertex 5"},
      {kSquare + "f 1/1 2/1 3/1\n", 5, "no texture point 1"},
      {kSquare + "f 1 2 -5\n", 5, "counts back beyond"},
      {kSquare + "f 1 2 99999999999\n", 5, "corner"},
  };
  for (const Bad& bad : cases) {
    SCOPED_TRACE(bad.text);
    const InputError error = input_error_of([&] { parse_obj(bad.text, "a.obj"); });
    EXPECT_EQ(error.where().line, bad.line);
    EXPECT_THAT(error.problem(), HasSubstr(bad.problem));
  }
}

TEST(Obj, RefusesAFileOfSomethingElse) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "word" + std::to_string(i) + " 1 2 3\n";
  EXPECT_THAT(input_error_of([&] { parse_obj(text, "a.obj"); }).problem(),
              HasSubstr("no OBJ file"));
}

}  // namespace
}  // namespace pliant
