// The hanging-weights test of [T] 5.3.2 with a cloth in space against its one-dimensional model.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/experiment/hanging/weight_path.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/solver/static_path.h"

#include "support/cloth_sheet.h"

namespace pliant {
namespace {

constexpr double kWidth = 0.1, kLength = 0.1;

/// Cotton without shear; bending only keeps the slack sheet in its plane.
Material unsheared_cotton() {
  Material material = test::cotton();
  material.components["shear"] = test::component(ScalarCurve::constant(0));
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    material.components[name] = test::component(ScalarCurve::constant(1e-5));
  }
  return material;
}

/// A sheet without weight, held along its upper edge, whose lower edge is in a free clip that
/// carries the i-th weight (N) at time i + 1.
struct WeightedSheet : test::ClothSheet {
  std::vector<int> held = row_at(kLength), clip = row_at(0);
  std::vector<double> weights;

  WeightedSheet(const TriangleMesh& sheet, const std::vector<double>& hung)
      : ClothSheet(sheet, unsheared_cotton()), weights(hung) {
    prescribe(held);
    system.coordinates().add_clip(clip, false);
    Eigen::VectorXd shares = Eigen::VectorXd::Zero(system.points());
    shares(clip).setConstant(1.0 / static_cast<double>(clip.size()));
    system.add(std::make_shared<PointForces>(0, shares));
    system.finish();
  }

  Schedule schedule() const {
    return [this](double time) {
      Controls controls;
      controls.vectors =
          Eigen::Vector3d(0, -weights.at(static_cast<size_t>(std::lround(time)) - 1), 0);
      return controls;
    };
  }
};

/// Up and down twice, the second time higher, with unequal steps.
std::vector<double> up_and_down() {
  return {0.3, 1.3, 2.3, 3.3, 2.1, 0.8, 0.4, 1.7, 3.5, 5.3, 3.9, 2.5, 1.1, 0.2};
}

class HangingWeights3d : public testing::TestWithParam<Diagonals> {};

TEST_P(HangingWeights3d, HasTheLengthsOfTheOneDimensionalModelOverTheWholePath) {
  const std::vector<double> weights = up_and_down();
  std::vector<char> rested(weights.size(), 0);
  rested.front() = 1;
  const Material material = unsheared_cotton();
  const auto expected =
      hang_weights(*law_of(material, "stretch.warp"), {kLength, kWidth, MembraneMeasure::stvk},
                   weights, rested, true);
  ASSERT_TRUE(expected);

  WeightedSheet sheet(regular_grid(kWidth, kLength, 5, 5, GetParam()), weights);
  StaticPathOptions options;
  options.newton.tolerance = 1e-10;
  options.schedule = sheet.schedule();
  options.by = sheet.system.all_parameters();
  StaticPath path(sheet.system, options);
  const auto& names = sheet.system.parameters().names;
  const auto first = std::find(names.begin(), names.end(), "stretch.warp.k1") - names.begin();
  ASSERT_LT(first, std::ssize(names));
  for (Eigen::Index i = 0; i < std::ssize(weights); ++i) {
    const PathEquilibrium point = path.step(static_cast<double>(i + 1));
    const double y = path.state().configuration.positions(1, sheet.clip.front());
    EXPECT_NEAR(kLength - y, expected->length(i), 1e-6 * expected->length(i)) << i;

    // (k1, k2, a, b, tau) in both. The slope of saturated friction scales the derivatives.
    const Eigen::VectorXd lengths =
        -point.by_parameter.positions.row(3 * sheet.clip.front() + 1).segment<5>(first).transpose();
    const Eigen::VectorXd jacobian = expected->jacobian.row(i).transpose();
    EXPECT_LT((lengths - jacobian).norm(), 1e-6 * jacobian.norm()) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, HangingWeights3d,
                         testing::Values(Diagonals::alternating, Diagonals::rising));

}  // namespace
}  // namespace pliant
