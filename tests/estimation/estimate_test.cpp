#include "pliant/estimation/estimate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Of one experiment of 100 rows, one of which does not count.
Uncertainty of_hundred_rows(double effective) {
  Uncertainty uncertainty;
  ExperimentNoise noise;
  noise.rows = 99;
  noise.effective_rows = effective;
  uncertainty.noise.of = {noise};
  uncertainty.noise.row_sd = {Eigen::VectorXd::Constant(100, 0.2)};
  uncertainty.noise.row_sd[0](0) = 5;
  uncertainty.noise.weight = {Eigen::VectorXd::Ones(100)};
  uncertainty.noise.weight[0](0) = 0;
  return uncertainty;
}

TEST(TakeNoise, GivesAnExperimentItsNoiseAndWhatItsRowsCountFor) {
  ExperimentResult row;
  StudyResult result;
  take_noise(of_hundred_rows(80), 0, row, result);
  EXPECT_DOUBLE_EQ(row.noise, 0.2);
  EXPECT_EQ(row.effective_rows, 80);
  EXPECT_THAT(result.assumptions, IsEmpty());
}

TEST(TakeNoise, SaysWhereNeighbouringResidualsGoTogether) {
  ExperimentResult row;
  row.name = "pull";
  StudyResult result;
  take_noise(of_hundred_rows(40), 0, row, result);
  EXPECT_THAT(result.assumptions,
              ElementsAre("pull: neighbouring residuals go together; its 99 rows count as 40"));
}

}  // namespace
}  // namespace pliant
