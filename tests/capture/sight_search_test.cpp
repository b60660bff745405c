#include "pliant/capture/sight_search.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "capture/drawn_rig.h"

namespace pliant {
namespace {

/// A plane that both cameras see moves from picture to picture as one of the candidates does, to
/// what a search in reduced pictures can bear.
TEST(SightSearch, KnowsHowAPlaneMovesFromCameraToCamera) {
  const test::DrawnRig rig(2, 480, 420, 0.06);
  const Eigen::Vector3d place(0.02, 0.035, 0);
  const auto from = rig.cameras[0].project(rig.to_rig() * place);
  const auto to = rig.cameras[1].project(rig.to_rig() * place);
  const auto candidates = sight_candidates(rig.cameras[0], rig.cameras[1], *from, 4);
  ASSERT_FALSE(candidates.empty());
  double least = INFINITY;
  for (const PatchMotion& motion : candidates) {
    const double off = (motion.shift - (*to - *from)).norm();
    least = std::min(least, off + 32 * motion.slope.norm());  // at the rim of a reduced patch
  }
  EXPECT_LT(least, 12);
}

TEST(SightSearch, LooksNowhereOutsideOfThePicture) {
  const test::DrawnRig rig(2, 480, 420, 0.06);
  for (const PatchMotion& motion :
       sight_candidates(rig.cameras[0], rig.cameras[1], Eigen::Vector2d(240, 210), 4)) {
    const Eigen::Vector2d there = Eigen::Vector2d(240, 210) + motion.shift;
    EXPECT_GE(there.minCoeff(), 0);
    EXPECT_LT(there.x(), 480);
    EXPECT_LT(there.y(), 420);
  }
}

}  // namespace
}  // namespace pliant
