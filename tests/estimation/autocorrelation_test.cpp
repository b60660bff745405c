#include "pliant/estimation/autocorrelation.h"

#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

/// Noise, each number of it so many times.
std::vector<double> repeated_noise(int numbers, int times) {
  RandomStream random(1);
  std::vector<double> series;
  for (int i = 0; i < numbers; ++i) {
    series.insert(series.end(), static_cast<std::size_t>(times), random.normal());
  }
  return series;
}

TEST(IntegratedAutocorrelation, CountsRepeatedNumbersOnce) {
  for (const int times : {1, 4, 10}) {
    // At a lag l < times a part 1 - l / times of the products are squares: the sum is `times`. Four
    // hundred numbers know their correlations to a twentieth.
    EXPECT_NEAR(integrated_autocorrelation(repeated_noise(400, times)), times, 0.2 * times);
  }
}

TEST(IntegratedAutocorrelation, IsOneWhereThereIsNothingToTell) {
  EXPECT_EQ(integrated_autocorrelation({1, 1, 1, 1, 1, 1, 1}), 1);
  EXPECT_EQ(integrated_autocorrelation(std::vector<double>(20, 0.0)), 1);
  EXPECT_EQ(integrated_autocorrelation({}), 1);
}

}  // namespace
}  // namespace pliant
