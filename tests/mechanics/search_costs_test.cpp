#include "pliant/mechanics/search_costs.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace pliant {
namespace {

TEST(SearchCosts, CountEachSecondOnce) {
  SearchCosts costs;
  const Stopwatch watch;
  {
    const Timed whole(&costs, &SearchCosts::energies);
    const Timed within(&costs, &SearchCosts::pairs);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  const double passed = watch.seconds();
  EXPECT_GE(costs.pairs, 0.002);
  EXPECT_GE(costs.energies, 0);
  EXPECT_LE(costs.energies + costs.pairs, passed);
}

}  // namespace
}  // namespace pliant
