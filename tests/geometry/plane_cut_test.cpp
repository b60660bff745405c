// What planes leave of bodies: closed surfaces around as much volume as lies behind the plane.

#include "pliant/geometry/plane_cut.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "pliant/geometry/block_mesh.h"
#include "pliant/geometry/volume_mesh.h"

namespace pliant {
namespace {

constexpr double kLength = 0.3, kWidth = 0.1, kHeight = 0.2;

std::vector<VolumeMesh> blocks() {
  return {block_of_tetrahedra({kLength, kWidth, kHeight}, {5, 3, 4}),
          block_of_hexahedra({kLength, kWidth, kHeight}, {5, 3, 4})};
}

PlaneCut cut_of(const VolumeMesh& mesh, const Plane& plane) {
  return cut_by_plane(mesh.positions, boundary_surface(mesh).triangles, tetrahedra_of(mesh), plane);
}

/// That of a closed surface whose triangles face outwards.
double enclosed_volume(const PlaneCut& cut, const Eigen::Matrix3Xd& positions) {
  const Eigen::Matrix3Xd x = cut.values(positions);
  double volume = 0;
  for (const auto& t : cut.triangles.colwise()) {
    volume += x.col(t(0)).dot(x.col(t(1)).cross(x.col(t(2)))) / 6;
  }
  return volume;
}

TEST(PlaneCut, ClosesWhatIsBehindThePlane) {
  for (const VolumeMesh& mesh : blocks()) {
    for (const double at : {0.05, 0.12, 0.123456}) {  // 0.12: through nodes
      const PlaneCut cut = cut_of(mesh, {Eigen::Vector3d::UnitX(), at});
      EXPECT_NEAR(enclosed_volume(cut, mesh.positions), at * kWidth * kHeight, 1e-15) << at;
      const PlaneCut other = cut_of(mesh, {-Eigen::Vector3d::UnitX(), -at});
      EXPECT_NEAR(enclosed_volume(other, mesh.positions), (kLength - at) * kWidth * kHeight, 1e-15);
    }
  }
}

TEST(PlaneCut, IsOfAnyDirection) {
  for (const VolumeMesh& mesh : blocks()) {
    const Eigen::Vector3d middle = Eigen::Vector3d(kLength, kWidth, kHeight) / 2;
    const Eigen::Vector3d normal = Eigen::Vector3d(0.3, -1, 0.7).normalized();
    const PlaneCut cut = cut_of(mesh, {normal, normal.dot(middle)});
    EXPECT_NEAR(enclosed_volume(cut, mesh.positions), kLength * kWidth * kHeight / 2, 1e-15);
  }
}

TEST(PlaneCut, HasTheFieldOfItsPlaces) {
  const VolumeMesh mesh = blocks().front();
  const Plane plane{Eigen::Vector3d(0.6, 0, 0.8), 0.15};
  const PlaneCut cut = cut_of(mesh, plane);
  const Eigen::Matrix3Xd x = cut.values(mesh.positions);
  const Eigen::RowVector3d slope(2, -1, 5);
  EXPECT_LT((cut.values(slope * mesh.positions) - slope * x).cwiseAbs().maxCoeff(), 1e-14);
  double farthest = -INFINITY;
  for (const auto& place : x.colwise()) farthest = std::max(farthest, plane.distance(place));
  EXPECT_NEAR(farthest, 0, 1e-15);
}

TEST(PlaneCut, LeavesAllOrNothing) {
  const VolumeMesh mesh = blocks().back();
  const PlaneCut all = cut_of(mesh, {Eigen::Vector3d::UnitX(), 1});
  EXPECT_EQ(all.triangles.cols(), boundary_surface(mesh).triangles.cols());
  EXPECT_EQ(cut_of(mesh, {Eigen::Vector3d::UnitX(), -1}).triangles.cols(), 0);
}

}  // namespace
}  // namespace pliant
