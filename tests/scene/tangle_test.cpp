// Whatever sheets are made to do, they do not pass through each other: told by an exact test that
// knows nothing of contact.

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/geometry/crossings.h"
#include "pliant/solver/free_change.h"

#include "contact/touching_sheets.h"
#include "support/asked_for.h"

namespace pliant {
namespace {

using test::random_ways;
using test::stacked_sheets;
using test::TouchingSheets;

// Sheets are thrown about at random, ever again from where they ended, into whatever tangles.
void throw_about(int times) {
  const TouchingSheets sheets(stacked_sheets(3, 6, 4e-3), 0);
  if (!crossing_triangles(sheets.sheets.positions, sheets.sheets.faces)) {
    GTEST_SKIP() << "built without CGAL";
  }
  const Objective objective(*sheets.system, {.from = sheets.state});
  RandomStream random(5);
  Configuration at = sheets.state.configuration;
  int shortened = 0;
  for (int i = 0; i < times; ++i) {
    const double size = std::pow(10, random.uniform(-4, -1.5));
    // Towards the middle, or they would fly apart.
    const Eigen::Matrix3Xd ways =
        random_ways(random, at.positions.cols(), size) - 0.1 * at.positions;
    const FreeChange free = free_change(objective, at, ways.reshaped());
    shortened += free.whole ? 0 : 1;
    const Eigen::VectorXd& change = i % 3 == 0 ? free.alike : free.each;
    at = sheets.system->coordinates().moved(at, random.uniform(0.5, 1) * change);
    ASSERT_TRUE(crossing_triangles(at.positions, sheets.sheets.faces)->empty()) << i;
  }
  EXPECT_GT(shortened, times / 2);
}

// A step that goes astray sends all points to all sides, by metres.
TEST(SlowTangle, IsNotMadeByAStepThatGoesAstray) {
  const TouchingSheets sheets(stacked_sheets(2, 36, 4e-3), 0);
  const Objective objective(*sheets.system, {.from = sheets.state});
  const Configuration& at = sheets.state.configuration;
  RandomStream random(7);
  const Eigen::Matrix3Xd ways = random_ways(random, at.positions.cols(), 1);
  const FreeChange free = free_change(objective, at, ways.reshaped());
  EXPECT_FALSE(free.whole);
  EXPECT_GT(free.lost, 0.5);
  EXPECT_GT(free.each.norm(), 0);
  const Configuration end = sheets.system->coordinates().moved(at, free.each);
  const auto crossings = crossing_triangles(end.positions, sheets.sheets.faces);
  EXPECT_TRUE(!crossings || crossings->empty());
}

TEST(Tangle, HasNoWayThroughASurface) { throw_about(30); }

// PLIANT_THROWS asks for more.
TEST(SlowTangle, HasNoWayThroughASurface) { throw_about(test::asked_for("PLIANT_THROWS", 60)); }

}  // namespace
}  // namespace pliant
