#include "pliant/report/histogram.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant::report {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

TEST(Histogram, CountsEachValueOnce) {
  const std::vector<double> values = {0.0, 0.1, 0.3, 0.9, 1.0};
  const Histogram histogram = make_histogram(values, 0.0, 1.0, 2);
  EXPECT_THAT(histogram.counts, ElementsAre(3.0, 2.0));
  // Rounding of one addition and one product.
  EXPECT_THAT(histogram.centres, ElementsAre(DoubleNear(0.25, 1e-15), DoubleNear(0.75, 1e-15)));
}

TEST(Histogram, CountsOutliersInTheEndBins) {
  const std::vector<double> values = {-1e300, 1e300};
  EXPECT_THAT(make_histogram(values, 0.0, 1.0, 3).counts, ElementsAre(1.0, 0.0, 1.0));
}

TEST(Histogram, IsEmptyWithoutARange) {
  const std::vector<double> values = {1.0};
  EXPECT_TRUE(make_histogram(values, 1.0, 1.0, 3).counts.empty());
  EXPECT_TRUE(make_histogram({}, 0.0, 1.0, 3).counts.empty());
}

}  // namespace
}  // namespace pliant::report
