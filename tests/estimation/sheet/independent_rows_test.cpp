// How many positions of a session are independent of each other.

#include "pliant/estimation/sheet/independent_rows.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

#include "support/virtual_sheets.h"

namespace pliant {
namespace {

class IndependentRows : public ::testing::Test {
 protected:
  Eigen::VectorXd noise() {
    RandomStream random(3);
    Eigen::VectorXd values(test_.rows());
    for (double& value : values) value = random.normal();
    return values;
  }

  SheetTest test_{"edge", test::virtual_bend(test::sheet_cloth(true), 0, 11, 12),
                  SheetObjective::positions};
};

TEST_F(IndependentRows, AreNearlyAllOfThoseWithNoiseOfTheirOwn) {
  const Eigen::VectorXd differences = noise();
  EXPECT_GT(independent_rows(test_, differences), 0.8 * test_.rows());
  EXPECT_NEAR(own_scatter(test_, differences), 1, 0.05);
}

TEST_F(IndependentRows, AreFewerThanFramesWhereShapesMissInOneWay) {
  const Eigen::VectorXd differences = test_.measured() + 0.001 * noise();
  EXPECT_LT(independent_rows(test_, differences), test_.frame_count());
  EXPECT_LT(own_scatter(test_, differences),
            0.3 * std::sqrt(differences.squaredNorm() / test_.rows()));
}

TEST_F(IndependentRows, CountThoseThatGoTogetherAlongFramesOnce) {
  // Noise that each node keeps.
  Eigen::VectorXd differences = noise();
  for (const std::vector<int>& rows : test_.series()) {
    for (const int row : rows) differences(row) = differences(rows.front());
  }
  EXPECT_LT(independent_rows(test_, differences), 0.3 * test_.rows());
}

}  // namespace
}  // namespace pliant
