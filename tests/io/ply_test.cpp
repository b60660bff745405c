#include "pliant/io/ply.h"

#include <bit>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/assert.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr PlyFormat kFormats[] = {PlyFormat::ascii, PlyFormat::binary_little_endian,
                                  PlyFormat::binary_big_endian};

std::string ascii(const std::string& header, const std::string& body = {}) {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

const std::string kTriangleHeader =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\n";

/// A pentagon and a triangle with numbers that have no short decimal form.
PlyMesh sample_mesh() {
  PlyMesh mesh;
  mesh.positions = {{1.0 / 3, -0.0, 1e-310},
                    {std::sqrt(2.0), 1e300, -1.0 / 7},
                    {0, 0.1, 0.2},
                    {5, 6, 7},
                    {8, 9, 10}};
  mesh.faces.add(std::vector{0, 1, 2, 3, 4});
  mesh.faces.add(std::vector{2, 1, 0});
  mesh.vertex_columns = {
      {"strain", {1.0 / 3, -2.0 / 7, 0, std::numeric_limits<double>::quiet_NaN(), 1e-9}},
      {"heat", {0.1f, -1.5f, 3e38f, 1e-40f, 0}, PlyType::float32},
      {"red", {0, 255, 1, 2, 3}, PlyType::uint8}};
  mesh.face_columns = {{"region", {-1, 70000}, PlyType::int32}};
  mesh.comments = {"made for a test"};
  return mesh;
}

void expect_same_bits(const std::vector<double>& read, const std::vector<double>& written) {
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (std::isnan(written[i])) {
      EXPECT_TRUE(std::isnan(read[i]));
    } else {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(read[i]), std::bit_cast<std::uint64_t>(written[i]));
    }
  }
}

void expect_same_columns(const std::vector<PlyColumn>& read, const std::vector<PlyColumn>& mesh) {
  ASSERT_EQ(read.size(), mesh.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].name, mesh[i].name);
    EXPECT_EQ(read[i].type, mesh[i].type);
    expect_same_bits(read[i].values, mesh[i].values);
  }
}

TEST(Ply, ComesBackToTheBitInEveryFormat) {
  const PlyMesh mesh = sample_mesh();
  for (const PlyFormat format : kFormats) {
    const PlyMesh read = parse_ply(write_ply(mesh, {format}), "a.ply");
    ASSERT_EQ(read.positions.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      expect_same_bits({read.positions[i].begin(), read.positions[i].end()},
                       {mesh.positions[i].begin(), mesh.positions[i].end()});
    }
    EXPECT_EQ(read.faces, mesh.faces);
    expect_same_columns(read.vertex_columns, mesh.vertex_columns);
    expect_same_columns(read.face_columns, mesh.face_columns);
    EXPECT_EQ(read.comments, mesh.comments);
    EXPECT_THAT(read.ignored, IsEmpty());
  }
}

TEST(Ply, RoundsCoordinatesToFloatOnRequest) {
  PlyMesh mesh = sample_mesh();
  mesh.positions[1][1] = 1e30;
  for (const PlyFormat format : kFormats) {
    const PlyMesh read = parse_ply(write_ply(mesh, {format, PlyType::float32}), "a.ply");
    EXPECT_EQ(read.positions[0][0], static_cast<double>(1.0f / 3));
    EXPECT_EQ(read.positions[1][0], static_cast<double>(std::sqrt(2.0f)));
  }
}

TEST(Ply, OfAnotherProgramIsUnderstood) {
  // CRLF, sized type names, vertex_index, faces before vertices, other elements, extra spaces.
  const std::string text =
      "ply\r\nformat ascii 1.0\r\ncomment by hand\r\nobj_info nothing\r\n"
      "element face 1\r\nproperty list uint8 int32 vertex_index\r\nproperty list uchar float uv\r\n"
      "element vertex 3\r\nproperty float32 x\r\nproperty float32 y\r\nproperty uint8 red\r\n"
      "property float32 z\r\nelement edge 1\r\nproperty int a\r\nend_header\r\n"
      "3 0 1 2 2 0.5 0.5\r\n0 0 7 0\r\n  1\t0 8 0\r\n0 1 9 +0.5\r\n4\r\n\r\n";
  const PlyMesh mesh = parse_ply(text, "a.ply");
  EXPECT_THAT(mesh.positions, SizeIs(3));
  EXPECT_EQ(mesh.positions[2], (Point3{0, 1, 0.5}));
  EXPECT_THAT(mesh.faces.corners, ElementsAre(0, 1, 2));
  ASSERT_THAT(mesh.vertex_columns, SizeIs(1));
  EXPECT_THAT(mesh.vertex_columns[0].values, ElementsAre(7, 8, 9));
  EXPECT_THAT(mesh.comments, ElementsAre("by hand"));
  EXPECT_THAT(mesh.ignored, ElementsAre(HasSubstr("\"uv\""), HasSubstr("\"edge\"")));
}

TEST(Ply, MayHaveNoFaces) {
  const PlyMesh mesh = parse_ply(
      ascii("element vertex 1\nproperty int x\nproperty int y\nproperty int z\n", "1 2 3"),
      "a.ply");
  EXPECT_EQ(mesh.positions[0], (Point3{1, 2, 3}));
  EXPECT_EQ(mesh.faces.size(), 0u);
}

TEST(Ply, IsReadFromAFile) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("a.ply", write_ply(sample_mesh()));
  EXPECT_EQ(read_ply(path).faces, sample_mesh().faces);
  EXPECT_EQ(input_error_of([&] { read_ply(folder.path() / "none.ply"); }).where().file,
            (folder.path() / "none.ply").string());
}

TEST(Ply, NamesALengthOfABinaryTail) {
  const PlyMesh mesh = parse_ply(write_ply(sample_mesh()) + "xy", "a.ply");
  EXPECT_THAT(mesh.ignored, ElementsAre("2 bytes behind the last element"));
}

struct BadPly {
  std::string text;
  int line;
  std::string problem;
};

TEST(Ply, RefusesABadTextWithItsLine) {
  const std::string good = "0 0 0\n1 0 0\n0 1 0\n";
  const BadPly cases[] = {
      {"", 1, "not a PLY file"},
      {"solid cube\n", 1, "not a PLY file"},
      {"ply\nformat ascii 2.0\n", 2, "unknown format"},
      {"ply\nformat ascii 1.0\nelement vertex 3\n", 4, "does not end"},
      {ascii("elements vertex 3\n"), 3, "unknown header line"},
      {ascii("element vertex -1\n"), 3, "count"},
      {ascii("element vertex 3 4\n"), 3, "unknown header line"},
      {ascii("property float x\n"), 3, "before the first element"},
      {ascii("element vertex 1\nproperty half x\n"), 4, "unknown type"},
      {ascii("element vertex 1\nproperty float x\nproperty float x\n"), 5, "second property"},
      {ascii("element vertex 0\nelement vertex 0\n"), 4, "second element"},
      {ascii("element face 0\nproperty list float int vertex_indices\n"), 4, "whole number"},
      {ascii("element face 0\n"), 0, "no element vertex"},
      {ascii("element vertex 0\nproperty int x\nproperty int y\nproperty int z\n"
             "element face 1\nproperty int region\n",
             "7\n"),
       7, "corners"},
      {ascii("element vertex 0\nproperty int x\nproperty int y\nproperty int z\n"
             "element face 0\nproperty int vertex_indices\n"),
       7, "corners"},
      {ascii("element vertex 1\nproperty float x\nproperty float y\n", "0 0\n"), 3,
       "no property z"},
      {ascii(kTriangleHeader, "0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), 11, "too few numbers"},
      {ascii(kTriangleHeader, "0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n"), 11, "more than the header"},
      {ascii(kTriangleHeader, "0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n"), 11, "\"zero\" is no float"},
      {ascii(kTriangleHeader, "0 0 0\n1 0 1e40\n0 1 0\n3 0 1 2\n"), 11, "\"1e40\" is no float"},
      {ascii(kTriangleHeader, "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"), 11, "not finite"},
      {ascii(kTriangleHeader, good + "3 0 1 3\n"), 13, "no vertex 3"},
      {ascii(kTriangleHeader, good + "3 0 1 -1\n"), 13, "no vertex -1"},
      {ascii(kTriangleHeader, good + "3 0 1 1.5\n"), 13, "\"1.5\" is no int"},
      {ascii(kTriangleHeader, good + "2 0 1\n"), 13, "2 corners"},
      {ascii(kTriangleHeader, good + "-1\n"), 13, "\"-1\" is no uchar"},
      {ascii(kTriangleHeader, good + "255 0 1 2\n"), 13, "does not fit"},
      {ascii(kTriangleHeader, good), 7, "too small for the 1 it claims"},
      {ascii(kTriangleHeader, "0 0 0\n1 0 0\n0 1.0 0\n"), 13, "too few numbers"},
  };
  for (const BadPly& bad : cases) {
    SCOPED_TRACE(bad.text);
    const InputError error = input_error_of([&] { parse_ply(bad.text, "a.ply"); });
    EXPECT_EQ(error.where().file, "a.ply");
    EXPECT_EQ(error.where().line, bad.line);
    EXPECT_THAT(error.problem(), HasSubstr(bad.problem));
  }
}

TEST(Ply, RefusesACountThatTheFileCannotHoldBeforeItMakesRoom) {
  const std::string properties = "property double x\nproperty double y\nproperty double z\n";
  for (const char* format : {"ascii", "binary_little_endian"}) {
    for (const char* count : {"1000000000000", "2147483647", "99999999999999999999"}) {
      const std::string text = std::string("ply\nformat ") + format + " 1.0\nelement vertex " +
                               count + "\n" + properties + "end_header\n0 0 0\n";
      EXPECT_EQ(input_error_of([&] { parse_ply(text, "a.ply"); }).where().line, 3);
    }
  }
  // Rows without bytes would never end.
  EXPECT_THAT(
      input_error_of([&] { parse_ply(ascii("element nothing 2000000000\n"), "a.ply"); }).problem(),
      HasSubstr("too small"));
}

TEST(Ply, RefusesATruncatedBinaryFileWithTheNumberOfTheRow) {
  PlyMesh mesh = sample_mesh();
  const std::string bytes = write_ply(mesh);
  const InputError error =
      input_error_of([&] { parse_ply(bytes.substr(0, bytes.size() - 5), "a.ply"); });
  EXPECT_EQ(error.where().field, "face 1");
  mesh.positions[2][0] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(input_error_of([&] { parse_ply(write_ply(mesh), "a.ply"); }).where().field, "vertex 2");
}

TEST(Ply, WriterRefusesWhatNoFileCanSay) {
  PlyMesh mesh = sample_mesh();
  mesh.vertex_columns[2].values[0] = 256;  // no uchar
  EXPECT_THROW(write_ply(mesh), AssertionError);
  mesh = sample_mesh();
  mesh.vertex_columns[0].name = "two words";
  EXPECT_THROW(write_ply(mesh), AssertionError);
  mesh = sample_mesh();
  mesh.face_columns[0].values.pop_back();
  EXPECT_THROW(write_ply(mesh), AssertionError);
}

TEST(Ply, KeepsPositionsThatAreNotFiniteWhereAsked) {
  const std::string text = ascii(kTriangleHeader, "0 0 0\n1 0 nan\n0 -inf 0\n3 0 1 2\n");
  const PlyMesh mesh = parse_ply(text, "a.ply", PlyPositions::any);
  EXPECT_TRUE(std::isnan(mesh.positions[1][2]));
  EXPECT_TRUE(std::isinf(mesh.positions[2][1]));
}

}  // namespace
}  // namespace pliant
