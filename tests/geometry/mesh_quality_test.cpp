#include "pliant/geometry/mesh_quality.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"

#include "io/input_error_of.h"

namespace pliant {
namespace {

using test::input_error_of;
using testing::AllOf;
using testing::AnyOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<std::string> problems_of(const TriangleMesh& mesh,
                                     const MeshNumbering& numbering = {}) {
  std::vector<std::string> texts;
  for (const MeshProblem& problem : find_mesh_problems(mesh, numbering)) {
    texts.push_back(problem.text);
  }
  return texts;
}

TriangleMesh grid() { return regular_grid(0.4, 0.3, 5, 4); }

TEST(MeshProblems, OfAGoodMeshAreNone) {
  for (const Diagonals diagonals : {Diagonals::alternating, Diagonals::rising}) {
    EXPECT_THAT(problems_of(regular_grid(0.4, 0.3, 5, 4, diagonals)), IsEmpty());
  }
  // In any size: thresholds are relative.
  EXPECT_THAT(problems_of(regular_grid(4e-9, 3e-9, 5, 4)), IsEmpty());
  EXPECT_NO_THROW(require_good_mesh(grid()));
}

TEST(MeshProblems, OfNoMeshAreOne) {
  EXPECT_THAT(problems_of(TriangleMesh{}), ElementsAre("the mesh has no triangles"));
}

TEST(MeshProblems, NameAVertexThatIsNotThere) {
  TriangleMesh mesh = grid();
  mesh.triangles(1, 7) = 20;
  mesh.triangles(2, 9) = -1;
  const auto problems = problems_of(mesh);
  ASSERT_THAT(problems, SizeIs(2));
  EXPECT_THAT(problems[0], AllOf(HasSubstr("face 7 "), HasSubstr("not there (there are 20)")));
  EXPECT_THAT(problems[1], HasSubstr("face 9 "));
}

TEST(MeshProblems, NameATriangleWithAVertexTwice) {
  TriangleMesh mesh = grid();
  mesh.triangles(1, 7) = mesh.triangles(0, 7);
  EXPECT_THAT(problems_of(mesh), ElementsAre(AllOf(HasSubstr("face 7 "), HasSubstr("twice"))));
}

TEST(MeshProblems, NameDuplicateTriangles) {
  TriangleMesh mesh = grid();
  mesh.triangles.col(9) << mesh.triangles(1, 4), mesh.triangles(2, 4), mesh.triangles(0, 4);
  EXPECT_THAT(problems_of(mesh),
              Contains(AllOf(HasSubstr("face 9 "), HasSubstr("has the vertices of face 4"))));
}

TEST(MeshProblems, NameATriangleWithoutAreaAtRest) {
  TriangleMesh mesh = grid();
  mesh.rest_corners.col(3 * 7 + 2) = (mesh.rest_corners.col(21) + mesh.rest_corners.col(22)) / 2;
  EXPECT_THAT(problems_of(mesh), ElementsAre(AllOf(HasSubstr("face 7 "), HasSubstr("at rest"))));
}

TEST(MeshProblems, NameATriangleThatIsSmallerThanTheMeshCanResolve) {
  TriangleMesh mesh = grid();
  mesh.rest_corners.middleCols<3>(21) *= 1e-11;
  EXPECT_THAT(problems_of(mesh), ElementsAre(HasSubstr("face 7 ")));
}

TEST(MeshProblems, NameATriangleWithoutAreaInSpace) {
  TriangleMesh mesh = grid();
  mesh.positions.col(mesh.triangles(0, 0)) = mesh.positions.col(mesh.triangles(1, 0));
  EXPECT_THAT(problems_of(mesh), Contains(AllOf(HasSubstr("face 0 "), HasSubstr("in space"))));
}

TEST(MeshProblems, NameAnInvertedRestTriangle) {
  TriangleMesh mesh = grid();
  mesh.rest_corners.col(22).swap(mesh.rest_corners.col(23));
  EXPECT_THAT(problems_of(mesh), ElementsAre(AllOf(HasSubstr("face 7 "), HasSubstr("inverted"))));
}

TEST(MeshProblems, NameAnEdgeWithThreeTriangles) {
  Eigen::Matrix2Xd vertices(2, 5);
  vertices << 0, 1, 0.5, 0.5, 0.4, 0, 0, 1, -1, 0.8;
  Eigen::Matrix3Xi triangles(3, 3);
  triangles << 0, 1, 0, 1, 0, 1, 2, 3, 4;
  EXPECT_THAT(problems_of(flat_mesh(vertices, triangles)),
              ElementsAre(AllOf(HasSubstr("between vertices 0 and 1"), HasSubstr("3 triangles"),
                                HasSubstr("faces 0, 1, 2"))));
}

TEST(MeshProblems, NameNeighboursThatFaceOppositeSides) {
  TriangleMesh mesh = grid();
  // Turned over with its rest shape: in order for itself, but not beside its neighbours.
  std::swap(mesh.triangles(1, 7), mesh.triangles(2, 7));
  const auto problems = problems_of(mesh);
  EXPECT_THAT(problems, SizeIs(AnyOf(2, 3)));
  EXPECT_THAT(problems, Each(AllOf(HasSubstr("same way"), HasSubstr("7"))));
}

TEST(MeshProblems, NameAVertexWithoutTriangles) {
  TriangleMesh mesh = grid();
  mesh.positions.conservativeResize(3, 21);
  mesh.positions.col(20).setZero();
  EXPECT_THAT(problems_of(mesh), ElementsAre("vertex 20 belongs to no triangle"));
  mesh.positions.conservativeResize(Eigen::NoChange, mesh.vertex_count() + 2);
  mesh.positions.rightCols<2>().setZero();
  EXPECT_THAT(problems_of(mesh), ElementsAre("vertex 20 belongs to no triangle, nor do 2 others"));
}

TEST(MeshProblems, HaveTheLineOfAVertexWithoutTriangles) {
  TriangleMesh mesh = grid();
  mesh.positions.conservativeResize(3, 21);
  mesh.positions.col(20).setZero();
  MeshNumbering numbering{"grid.obj", 1, {}, {}, {}};
  for (int i = 0; i < 21; ++i) numbering.vertex_lines.push_back(3 + i);
  const InputError error = input_error_of([&] { require_good_mesh(mesh, numbering); });
  EXPECT_STREQ(error.what(),
               "grid.obj:23: vertex 21 belongs to no triangle; expected only vertices of faces: "
               "others would have no mass");
}

TEST(MeshProblems, SayWhatIsExpected) {
  TriangleMesh mesh = grid();
  mesh.triangles.col(9) = mesh.triangles.col(4);
  mesh.positions.col(0).setConstant(std::numeric_limits<double>::infinity());
  mesh.rest_corners.col(23) = mesh.rest_corners.col(22);
  for (const MeshProblem& problem : find_mesh_problems(mesh)) {
    EXPECT_FALSE(problem.expected.empty()) << problem.text;
  }
  mesh.triangles(1, 7) = mesh.triangles(0, 7);
  EXPECT_EQ(input_error_of([&] { require_good_mesh(mesh); }).expected(),
            "three different vertices");
}

TEST(MeshProblems, NameWhatIsNotFinite) {
  TriangleMesh mesh = grid();
  mesh.positions(1, 3) = std::numeric_limits<double>::quiet_NaN();
  mesh.rest_corners(0, 20) = std::numeric_limits<double>::infinity();
  EXPECT_THAT(problems_of(mesh), Contains("the position of vertex 3 is not finite"));
  EXPECT_THAT(problems_of(mesh), Contains(AllOf(HasSubstr("face 6 "), HasSubstr("finite"))));
}

TEST(MeshProblems, AreNumberedAsInTheFile) {
  TriangleMesh mesh = grid();
  mesh.triangles(1, 7) = mesh.triangles(0, 7);
  MeshNumbering numbering{"shirt.obj", 1, {}, {}};
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    numbering.faces.push_back(t / 2);
    if (t % 2 == 0) numbering.face_lines.push_back(100 + t);
  }
  const InputError error = input_error_of([&] { require_good_mesh(mesh, numbering); });
  EXPECT_EQ(error.where().file, "shirt.obj");
  EXPECT_EQ(error.where().line, 106);
  EXPECT_THAT(error.problem(), HasSubstr("face 4 "));  // triangle 7 is of the fourth face
}

TEST(MeshProblems, AreCountedInTheError) {
  TriangleMesh mesh = grid();
  mesh.triangles(1, 7) = 99;
  mesh.triangles(1, 8) = 99;
  EXPECT_THAT(input_error_of([&] { require_good_mesh(mesh); }).problem(),
              HasSubstr("(and 1 more problem)"));
  mesh = regular_grid(1, 1, 30, 30);
  mesh.triangles.array() += 5000;
  EXPECT_THAT(find_mesh_problems(mesh), SizeIs(kMaxMeshProblems));
}

TEST(MeshQuality, OfEquilateralTrianglesIsPerfect) {
  Eigen::Matrix2Xd vertices(2, 3);
  vertices << 0, 2, 1, 0, 0, std::sqrt(3.0);
  const MeshQuality quality = mesh_quality(flat_mesh(vertices, Eigen::Vector3i(0, 1, 2)));
  EXPECT_NEAR(quality.smallest_angle, std::numbers::pi / 3, 1e-15);  // rounding
  EXPECT_NEAR(quality.largest_angle, std::numbers::pi / 3, 1e-15);
  EXPECT_NEAR(quality.largest_aspect_ratio, 1, 1e-15);
  EXPECT_NEAR(quality.mean_edge, 2, 1e-15);
}

TEST(MeshQuality, FindsTheWorstTriangle) {
  TriangleMesh mesh = regular_grid(1, 1, 5, 5);
  const MeshQuality even = mesh_quality(mesh);
  EXPECT_NEAR(even.smallest_angle, std::numbers::pi / 4, 1e-14);
  EXPECT_NEAR(even.largest_angle, std::numbers::pi / 2, 1e-14);
  EXPECT_NEAR(even.longest_edge / even.shortest_edge, std::sqrt(2.0), 1e-14);
  mesh.rest_corners.block<1, 3>(0, 3 * 13) *= 0.1;
  const MeshQuality uneven = mesh_quality(mesh);
  EXPECT_EQ(uneven.smallest_angle_triangle, 13);
  EXPECT_EQ(uneven.largest_aspect_ratio_triangle, 13);
  EXPECT_NEAR(uneven.smallest_angle, std::atan(0.1), 1e-14);
}

}  // namespace
}  // namespace pliant
