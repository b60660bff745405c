#include "pliant/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
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

TEST(ParallelFor, RunsOnOneThreadOutsideOfALimit) {
  std::set<std::thread::id> threads;
  parallel_for(50, [&](int) { threads.insert(std::this_thread::get_id()); });
  EXPECT_EQ(threads, std::set{std::this_thread::get_id()});
}

// A loop within a loop, with what each outer index holds: the thread that waits for the inner loop
// must not begin with another outer index, nor may an inner limit be wider than the outer one.
TEST(ParallelFor, WithinAnotherKeepsToItsOwnWorkAndLimit) {
  std::atomic<int> at_once = 0, most = 0, sum = 0;
  thread_local bool busy = false;
  parallel_for(20, 2, [&](int) {
    EXPECT_FALSE(busy);
    busy = true;
    parallel_for(20, 50, [&](int i) {
      most = std::max(most.load(), ++at_once);
      sum += i;
      --at_once;
    });
    busy = false;
  });
  EXPECT_EQ(sum, 20 * 190);
  EXPECT_LE(most, 2);
}

TEST(Pipeline, UsesItemsInTheirOrderAfterTheyAreMade) {
  for (const int threads : {1, 2, 4}) {
    std::vector<int> made(200, -1), used;
    with_threads(threads, [&] {
      pipeline(
          200, [&](int i) { made[static_cast<size_t>(i)] = i; },
          [&](int i) { used.push_back(made[static_cast<size_t>(i)]); });
    });
    EXPECT_EQ(used, made);
  }
}

TEST(Pipeline, EndsWithTheExceptionOfTheLowestItem) {
  const auto fail_at = [](int bad) {
    return [bad](int i) {
      if (i == bad) throw std::runtime_error(std::to_string(i));
    };
  };
  for (const int threads : {1, 2}) {
    for (const auto& [bad_make, bad_use] : {std::pair{7, 20}, {20, 7}, {7, 7}}) {
      int used = 0;
      try {
        with_threads(threads, [&, make = fail_at(bad_make), use = fail_at(bad_use)] {
          pipeline(50, make, [&](int i) {
            use(i);
            ++used;
          });
        });
        FAIL() << "nothing was thrown";
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "7");
      }
      EXPECT_EQ(used, 7);
    }
  }
}

}  // namespace
}  // namespace pliant
