#include "pliant/geometry/crossings.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/geometry/regular_grid.h"

namespace pliant {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Pairs = std::vector<std::array<int, 2>>;

/// Of a program with CGAL.
class Crossings : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!crossing_triangles(Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xi(3, 0))) {
      GTEST_SKIP() << "this build has no CGAL";
    }
  }

  /// Triangles of their own vertices, three columns each.
  static Pairs of(const Eigen::Matrix3Xd& corners) {
    Eigen::Matrix3Xi triangles(3, corners.cols() / 3);
    for (int i = 0; i < triangles.size(); ++i) triangles(i) = i;
    return *crossing_triangles(corners, triangles);
  }
};

/// A triangle in the plane z = 0 and one upright, shifted along z.
Eigen::Matrix3Xd upright_on_flat(double height) {
  Eigen::Matrix3Xd corners(3, 6);
  corners << 0, 1, 0, 0.2, 0.3, 0.2,  //
      0, 0, 1, 0.2, 0.2, 0.3,         //
      0, 0, 0, height, height, height + 1;
  return corners;
}

TEST_F(Crossings, AreWhereASidePassesThroughATriangle) {
  EXPECT_THAT(of(upright_on_flat(-0.5)), ElementsAre(std::array{0, 1}));
  EXPECT_THAT(of(upright_on_flat(0.01)), IsEmpty());
}

TEST_F(Crossings, AreNoneWhereTrianglesTouchOrLieOnEachOther) {
  EXPECT_THAT(of(upright_on_flat(0)), IsEmpty());
  Eigen::Matrix3Xd twice(3, 6);
  twice << upright_on_flat(0).leftCols<3>(), upright_on_flat(0).leftCols<3>();
  EXPECT_THAT(of(twice), IsEmpty());
}

TEST_F(Crossings, AreFoundBetweenTrianglesThatShareAVertex) {
  Eigen::Matrix3Xd positions(3, 5);
  positions << 0, 1, 0, 0.5, 0.5,  //
      0, 0, 1, 0.2, 0.3,           //
      0, 0, 0, -1, 1;
  Eigen::Matrix3Xi triangles(3, 2);
  triangles << 0, 0, 1, 3, 2, 4;
  EXPECT_THAT(*crossing_triangles(positions, triangles), ElementsAre(std::array{0, 1}));
  positions(2, 3) = 0.5;
  EXPECT_THAT(*crossing_triangles(positions, triangles), IsEmpty());
}

TEST_F(Crossings, AreNoneInASheetThatIsFlatOrRolledWithoutMeetingItself) {
  TriangleMesh sheet = regular_grid(1, 1, 21, 21);
  EXPECT_THAT(*crossing_triangles(sheet.positions, sheet.triangles), IsEmpty());
  for (auto position : sheet.positions.colwise()) {
    const double radius = 0.2 + 0.02 * position.x(), angle = 5 * position.x();
    position = Eigen::Vector3d(radius * std::cos(angle), position.y(), radius * std::sin(angle));
  }
  EXPECT_THAT(*crossing_triangles(sheet.positions, sheet.triangles), IsEmpty());
}

// Whether a segment meets a triangle, solved in floating point.
bool meets(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Matrix3d& t) {
  Eigen::Matrix3d system;
  system << from - to, t.col(1) - t.col(0), t.col(2) - t.col(0);
  const Eigen::Vector3d x = system.inverse() * (from - t.col(0));
  return x.minCoeff() > 0 && x.x() < 1 && x.y() + x.z() < 1;
}

bool side_meets(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  for (int k = 0; k < 3; ++k) {
    if (meets(a.col(k), a.col((k + 1) % 3), b)) return true;
  }
  return false;
}

TEST_F(Crossings, OfATangleAreThoseOfTryingEveryPair) {
  constexpr int kTriangles = 120;
  RandomStream random(7);
  Eigen::Matrix3Xd corners(3, 3 * kTriangles);
  for (Eigen::Index i = 0; i < corners.size(); ++i) corners(i) = random.uniform(0, 1);
  Pairs expected;
  for (int a = 0; a < kTriangles; ++a) {
    for (int b = a + 1; b < kTriangles; ++b) {
      const Eigen::Matrix3d one = corners.middleCols<3>(3 * a),
                            other = corners.middleCols<3>(3 * b);
      if (side_meets(one, other) || side_meets(other, one)) expected.push_back({a, b});
    }
  }
  EXPECT_GT(expected.size(), 100u);
  EXPECT_EQ(of(corners), expected);
}

}  // namespace
}  // namespace pliant
