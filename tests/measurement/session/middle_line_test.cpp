#include "pliant/measurement/session/middle_line.h"

#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"

namespace pliant {
namespace {

TEST(MiddleLine, IsOneLineOfAGridWithAnyNumberOfCells) {
  for (const int nodes : {2, 3, 6, 7}) {
    for (const int along : {0, 1}) {
      const TriangleMesh rest = regular_grid(0.1, 0.1, nodes, nodes);
      const std::vector<int> line = middle_line(rest, along);
      ASSERT_EQ(line.size(), static_cast<std::size_t>(nodes)) << nodes;
      for (const int vertex : line) {
        // Half of a cell away at most.
        EXPECT_NEAR(rest.positions(1 - along, vertex), 0.05, 0.05 / (nodes - 1) + 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace pliant
