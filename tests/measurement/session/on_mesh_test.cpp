#include "pliant/measurement/session/on_mesh.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/measurement/session/balance.h"

#include "io/input_error_of.h"
#include "support/irregular_sheet.h"
#include "support/session_sheets.h"

namespace pliant::test {
namespace {

using testing::HasSubstr;

/// A session of one frame without clips: 100 mm x 100 mm of irregular mesh, mapped to space.
template <typename Map>
Session mapped_session(const TriangleMesh& rest, const Map& map) {
  Session session;
  session.sample = {"", 0.1, 0.1, 0.0031, {}};
  session.rest = rest;
  SessionFrame frame;
  frame.positions = rest.positions;
  for (auto point : frame.positions.colwise()) point = map(Eigen::Vector3d(point));
  session.frames = {frame};
  return session;
}

template <typename Map>
double largest_error(const Session& session, const Map& map) {
  double largest = 0;
  for (int i = 0; i < session.rest.vertex_count(); ++i) {
    const Eigen::Vector3d exact = map(Eigen::Vector3d(session.rest.positions.col(i)));
    largest = std::max(largest, (session.frames[0].positions.col(i) - exact).norm());
  }
  return largest;
}

Eigen::Vector3d affine(const Eigen::Vector3d& rest) {
  Eigen::Matrix3d map;
  map << 1.2, 0.3, 0, -0.1, 0.9, 0, 0.2, 0.5, 0;
  return map * rest + Eigen::Vector3d(0.1, 0.2, 0.3);
}

Eigen::Vector3d on_cylinder(const Eigen::Vector3d& rest) {
  const double radius = 0.05;
  const double angle = rest.x() / radius;
  return {radius * std::sin(angle), rest.y(), radius * (1 - std::cos(angle))};
}

TEST(SessionOnMesh, KeepsAnAffineMap) {
  const Session session = mapped_session(irregular_sheet(30, 0.1 / 30, 7), affine);
  for (const TriangleMesh& mesh :
       {regular_grid(0.1, 0.1, 25, 25), irregular_sheet(17, 0.1 / 17, 3)}) {
    // Coordinates of 0.1 m, and weights of irregular triangles.
    EXPECT_LT(largest_error(on_mesh(session, mesh), affine), 1e-14);
  }
}

TEST(SessionOnMesh, KeepsAnAffineMapBeyondTheRim) {
  // 1 mm of the sheet was not seen on each side.
  TriangleMesh rest = regular_grid(0.098, 0.098, 30, 30);
  rest = flat_mesh((rest.positions.topRows<2>().array() + 0.001).matrix(), rest.triangles);
  const Session session = mapped_session(rest, affine);
  EXPECT_LT(largest_error(on_mesh(session, regular_grid(0.1, 0.1, 25, 25)), affine), 1e-14);
}

TEST(SessionOnMesh, MeetsACylinderToSecondOrder) {
  const TriangleMesh mesh = regular_grid(0.1, 0.1, 25, 25);
  double errors[2];
  for (int i = 0; i < 2; ++i) {
    // Side lengths that share no vertices with the mesh.
    const int cells = i == 0 ? 29 : 58;
    const Session session =
        mapped_session(regular_grid(0.1, 0.1, cells + 1, cells + 1), on_cylinder);
    errors[i] = largest_error(on_mesh(session, mesh), on_cylinder);
  }
  // A chord misses its arc by h^2 / (8 radius).
  const double h = 0.1 / 29;
  EXPECT_NEAR(errors[0], h * h / (8 * 0.05), 0.05 * errors[0]);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.1);
}

TEST(SessionOnMesh, KeepsPosesCordsAndTheWeight) {
  const Session session = stretch_session(100, 2);
  const Session moved = on_mesh(session, regular_grid(0.1, 0.1, 25, 25));
  EXPECT_EQ(moved.frames[1].poses[1].translation, session.frames[1].poses[1].translation);
  EXPECT_EQ(moved.frames[1].cords[1].size(), 2U);
  EXPECT_NEAR(vertex_masses(moved).sum(), 0.0031, 1e-16);
  EXPECT_LT(imbalance(moved, 1).force.norm(), 1e-13);
  EXPECT_LT(imbalance(moved, 1).moment.norm(), 1e-13);
}

TEST(SessionOnMesh, GivesAClipTheNodesInItsRegion) {
  Session session = stretch_session(101, 1);  // vertices 1 mm apart
  // A clip on the right that holds a strip of 9 mm, and one vertex of a round one on the left.
  session.clips[1].clamped.clear();
  for (int i = 0; i < session.rest.vertex_count(); ++i) {
    if (session.rest.positions(0, i) > 0.0905) session.clips[1].clamped.push_back(i);
  }
  session.clips[0].clamped = {50 * 101};
  const Session moved = on_mesh(session, regular_grid(0.1, 0.1, 25, 25));
  // Columns 22, 23 and 24 of 25 are at 91.67, 95.83 and 100 mm; row 12 is at 50 mm.
  EXPECT_EQ(moved.clips[1].clamped.size(), 3 * 25U);
  for (const int node : moved.clips[1].clamped) EXPECT_GE(node % 25, 22);
  EXPECT_THAT(moved.clips[0].clamped, testing::ElementsAre(12 * 25));
}

TEST(SessionOnMesh, RefusesAClipWithoutNodes) {
  Session session = stretch_session(101, 1);
  session.clips[0].clamped = {30 * 101 + 2};  // at 2, 30 mm
  const InputError error = input_error_of([&] { on_mesh(session, regular_grid(0.1, 0.1, 5, 5)); });
  EXPECT_THAT(error.problem(), HasSubstr("no node of the mesh lies in clip left"));
}

TEST(SessionOnMesh, RefusesAMeshThatIsElsewhere) {
  const Session session = stretch_session(9, 1);
  const InputError error =
      input_error_of([&] { on_mesh(session, regular_grid(0.105, 0.1, 5, 5)); });
  EXPECT_THAT(error.problem(), HasSubstr("node 4 of the mesh lies 5 mm outside"));
  EXPECT_THAT(error.expected(), HasSubstr("2 mm"));
}

}  // namespace
}  // namespace pliant::test
