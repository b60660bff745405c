#include "pliant/measurement/session/clip_grid.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "pliant/geometry/grid_pattern.h"
#include "pliant/geometry/hinges.h"
#include "pliant/measurement/session/on_mesh.h"

#include "support/session_sheets.h"

namespace pliant::test {
namespace {

/// The places of a grid's lines that cross an axis, to a nanometre.
std::vector<double> lines_of(const TriangleMesh& mesh, int axis) {
  std::vector<double> lines;
  for (int i = 0; i < mesh.vertex_count(); ++i) lines.push_back(mesh.positions(axis, i));
  std::ranges::sort(lines);
  const auto repeated =
      std::ranges::unique(lines, [](double a, double b) { return std::abs(a - b) < 1e-9; });
  lines.erase(repeated.begin(), repeated.end());
  return lines;
}

bool has_line(const TriangleMesh& mesh, int axis, double at) {
  return std::ranges::any_of(lines_of(mesh, axis),
                             [&](double line) { return std::abs(line - at) < 1e-9; });
}

std::vector<int> vertices_in(const TriangleMesh& rest, double u0, double u1, double v0, double v1) {
  std::vector<int> found;
  for (int i = 0; i < rest.vertex_count(); ++i) {
    const Eigen::Vector3d p = rest.positions.col(i);
    if (p.x() > u0 - 1e-9 && p.x() < u1 + 1e-9 && p.y() > v0 - 1e-9 && p.y() < v1 + 1e-9) {
      found.push_back(i);
    }
  }
  return found;
}

/// Bars 7 mm deep at all sides of 100 mm x 100 mm, from 13 to 87 mm, measured every millimetre.
Session framed_session() {
  Session session = stretch_session(101, 1);
  const auto& rest = session.rest;
  session.clips = {{"left", 0.01, vertices_in(rest, 0, 0.007, 0.013, 0.087)},
                   {"right", 0.01, vertices_in(rest, 0.093, 0.1, 0.013, 0.087)},
                   {"bottom", 0.01, vertices_in(rest, 0.013, 0.087, 0, 0.007)},
                   {"top", 0.01, vertices_in(rest, 0.013, 0.087, 0.093, 0.1)}};
  return session;
}

TEST(ClipGrid, HasLinesOnTheEdgesOfClips) {
  const TriangleMesh grid = grid_on_clips(framed_session(), 0.1 / 24);
  for (const int axis : {0, 1}) {
    for (const double edge : {0.0, 0.007, 0.013, 0.087, 0.093, 0.1}) {
      EXPECT_TRUE(has_line(grid, axis, edge)) << edge;
    }
  }
  EXPECT_TRUE(is_cut_from_rectangles(grid));
  EXPECT_NEAR(rest_area(grid), 0.01, 1e-15);
}

TEST(ClipGrid, LetsClipsHoldTheClothThatTheyHold) {
  const Session session = framed_session();
  for (const double edge : {0.1 / 24, 0.0005}) {  // coarser and finer than what was measured
    const Session moved = on_mesh(session, grid_on_clips(session, edge));
    for (std::size_t c = 0; c < session.clips.size(); ++c) {
      for (const int axis : {0, 1}) {
        const auto was = session.rest.positions(axis, session.clips[c].clamped);
        const auto is = moved.rest.positions(axis, moved.clips[c].clamped);
        EXPECT_NEAR(is.minCoeff(), was.minCoeff(), 1e-12);
        EXPECT_NEAR(is.maxCoeff(), was.maxCoeff(), 1e-12);
      }
    }
  }
}

TEST(ClipGrid, HasEqualCellsWhereThereAreNoClips) {
  const TriangleMesh grid = grid_on_clips(bend_session(), 0.1 / 24);
  EXPECT_EQ(grid.vertex_count(), 25 * 25);
  const auto pattern = grid_pattern(grid, find_hinges(grid));
  ASSERT_TRUE(pattern.has_value());
  EXPECT_EQ(pattern->diagonals, Diagonals::alternating);
}

TEST(ClipGrid, HasNoLinesCloseTogether) {
  Session session = framed_session();
  // 0.5 mm deep, and a neighbour that ends 1 mm from another: less than a quarter of 5 mm.
  session.clips[0].clamped = vertices_in(session.rest, 0, 0.001, 0.013, 0.087);
  session.clips[2].clamped = vertices_in(session.rest, 0.014, 0.087, 0, 0.007);
  session.clips[3].clamped = vertices_in(session.rest, 0.015, 0.087, 0.093, 0.1);
  const TriangleMesh grid = grid_on_clips(session, 0.005);
  const std::vector<double> lines = lines_of(grid, 0);
  for (std::size_t i = 1; i < lines.size(); ++i) EXPECT_GT(lines[i] - lines[i - 1], 0.00125);
  EXPECT_TRUE(has_line(grid, 0, 0.0145));  // their mean
  EXPECT_FALSE(has_line(grid, 0, 0.001));  // the side of the sample is near
}

TEST(ClipGrid, LiesInTheMiddleOfTheRestMeshWithTheSizeOfTheSample) {
  Session session = bend_session();
  session.rest.positions.topRows<2>().array() -= 0.05;
  session.rest.rest_corners.array() -= 0.05;
  session.sample.width = 0.102;
  const TriangleMesh grid = grid_on_clips(session, 0.005);
  EXPECT_NEAR(grid.positions.row(0).minCoeff(), -0.051, 1e-15);
  EXPECT_NEAR(grid.positions.row(0).maxCoeff(), 0.051, 1e-15);
  EXPECT_NEAR(grid.positions.row(1).maxCoeff(), 0.05, 1e-15);
}

TEST(ClipGrid, HasTwoCellsAcrossAtLeast) {
  EXPECT_EQ(grid_on_clips(bend_session(), 1).vertex_count(), 9);
}

}  // namespace
}  // namespace pliant::test
