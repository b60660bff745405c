#include "pliant/base/parallel.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace pliant {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnceWhateverTheThreads) {
  for (const int threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> visits(100);
    parallel_for(100, threads, [&](int i) { ++visits[static_cast<size_t>(i)]; });
    for (const auto& count : visits) EXPECT_EQ(count, 1);
  }
}

TEST(ParallelFor, DoesNothingForNoWork) {
  parallel_for(0, 4, [](int) { FAIL(); });
}

TEST(ParallelFor, ThrowsTheExceptionOfTheLowestIndexAfterAllHaveRun) {
  std::atomic<int> runs = 0;
  const auto work = [&](int i) {
    ++runs;
    if (i == 3 || i == 9) throw std::runtime_error(std::to_string(i));
  };
  try {
    parallel_for(20, 3, work);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "3");
  }
  EXPECT_EQ(runs, 20);
}

}  // namespace
}  // namespace pliant
