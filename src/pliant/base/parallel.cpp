#include "pliant/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <vector>

#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace pliant {
namespace {

constexpr int kNoLimit = 0;
thread_local int present_limit = kNoLimit;

/// A limit that holds on this thread for as long as it lives.
class Limit {
 public:
  explicit Limit(int threads) : before_(present_limit) { present_limit = threads; }
  ~Limit() { present_limit = before_; }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;

 private:
  int before_;
};

}  // namespace

void with_threads(int threads, const std::function<void()>& work) {
  if (present_limit != kNoLimit && threads >= present_limit) {
    work();
    return;
  }
  const auto limited = [&] {
    const Limit limit(threads);
    work();
  };
  if (threads <= 1) {
    limited();
  } else {
    tbb::task_arena(threads).execute(limited);
  }
}

void parallel_for(int count, const std::function<void(int)>& work) {
  const int threads = present_limit;
  std::vector<std::exception_ptr> errors(static_cast<size_t>(std::max(count, 0)));
  const auto run = [&](int i) {
    const Limit limit(threads);
    try {
      work(i);
    } catch (...) {
      errors[static_cast<size_t>(i)] = std::current_exception();
    }
  };
  if (threads <= 1 || count <= 1) {
    for (int i = 0; i < count; ++i) run(i);
  } else {
    tbb::this_task_arena::isolate(
        [&] { tbb::parallel_for(0, count, run, tbb::simple_partitioner()); });
  }
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

void pipeline(int count, const std::function<void(int)>& make,
              const std::function<void(int)>& use) {
  constexpr size_t kAhead = 8;  // items that wait to be used
  const int threads = present_limit;
  if (threads <= 1) {
    for (int i = 0; i < count; ++i) {
      make(i);
      use(i);
    }
    return;
  }
  std::exception_ptr of_make, of_use;
  std::atomic<bool> failed = false;
  int next = 0;
  const auto attempt = [&](const std::function<void(int)>& work, int i, std::exception_ptr& error) {
    const Limit limit(threads);
    try {
      work(i);
    } catch (...) {
      error = std::current_exception();
      failed = true;
    }
  };
  const auto source = [&](tbb::flow_control& control) {
    const int i = next++;
    if (i < count && !failed) attempt(make, i, of_make);
    if (i >= count || failed) control.stop();
    return i;
  };
  const auto sink = [&](int i) {
    if (!of_use) attempt(use, i, of_use);
  };
  constexpr auto kInOrder = tbb::filter_mode::serial_in_order;
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_pipeline(kAhead, tbb::make_filter<void, int>(kInOrder, source) &
                                       tbb::make_filter<int, void>(kInOrder, sink));
  });
  if (of_use) std::rethrow_exception(of_use);
  if (of_make) std::rethrow_exception(of_make);
}

void parallel_for(int count, int threads, const std::function<void(int)>& work) {
  with_threads(threads, [&] { parallel_for(count, work); });
}

}  // namespace pliant
