#include "pliant/report/drawn_rows.h"

#include <cmath>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant::report {
namespace {

using ::testing::ElementsAre;
using ::testing::IsNan;

Prediction cycle() {
  Prediction p;
  p.strain = {0.0, 0.1, 0.2, 0.1, 0.0, 0.1};
  p.branch = {Branch::load,   Branch::load,   Branch::load,
              Branch::unload, Branch::unload, Branch::load};
  p.specimen.assign(p.strain.size(), "1");
  p.used.assign(p.strain.size(), 1);
  return p;
}

std::vector<std::size_t> all_rows(const Prediction& p) {
  std::vector<std::size_t> rows(p.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

TEST(ReversalRows, AreTheRowsOnBothSidesOfAReversal) {
  EXPECT_THAT(reversal_rows(cycle()), ElementsAre(2, 3, 4, 5));
}

TEST(LineOfBranch, UnloadingStartsAtThePeakOfLoading) {
  const Prediction p = cycle();
  const auto line = line_of_branch(p, all_rows(p), Branch::unload, p.strain, p.strain);
  EXPECT_THAT(line.x, ElementsAre(0.2, 0.1, 0.0));
}

TEST(LineOfBranch, HasAGapBetweenTwoStretches) {
  const Prediction p = cycle();
  const auto line = line_of_branch(p, all_rows(p), Branch::load, p.strain, p.strain);
  EXPECT_THAT(line.x, ElementsAre(0.0, 0.1, 0.2, IsNan(), 0.0, 0.1));
}

TEST(LineOfBranch, DoesNotJoinTwoSpecimens) {
  Prediction p = cycle();
  p.branch.assign(p.rows(), Branch::load);
  for (std::size_t row = 3; row < p.rows(); ++row) p.specimen[row].front() = '2';
  const auto line = line_of_branch(p, all_rows(p), Branch::load, p.strain, p.strain);
  EXPECT_THAT(line.x, ElementsAre(0.0, 0.1, 0.2, IsNan(), 0.1, 0.0, 0.1));
}

}  // namespace
}  // namespace pliant::report
