#include "pliant/base/progress.h"

#include <csignal>
#include <stdexcept>

#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/base/run_context.h"

namespace pliant {
namespace {

StopFlag signal_flag;

TEST(StopToken, NeverStopsByItself) {
  const StopToken token;
  EXPECT_FALSE(token.stop_requested());
  EXPECT_NO_THROW(token.throw_if_requested());
}

TEST(StopToken, SeesWhatASignalHandlerRequested) {
  const StopToken token = signal_flag.token();
  EXPECT_FALSE(token.stop_requested());
  const auto earlier = std::signal(SIGUSR1, [](int) { signal_flag.request(); });
  std::raise(SIGUSR1);
  std::signal(SIGUSR1, earlier);
  EXPECT_TRUE(token.stop_requested());
  EXPECT_THROW(token.throw_if_requested(), Interrupted);
}

class CountingProgress : public Progress {
 public:
  void begin(std::string_view /*task*/, double /*total*/) override { ++open; }
  void advance(double done) override { last = done; }
  void end() override { --open; }
  void message(Level /*level*/, std::string_view /*text*/) override {}
  int open = 0;
  double last = 0.0;
};

TEST(ProgressTask, EndsWithItsScopeAlsoWhenAnExceptionLeavesIt) {
  CountingProgress progress;
  try {
    ProgressTask task(progress, "fit", 10.0);
    task.advance(4.0);
    EXPECT_EQ(progress.open, 1);
    throw std::runtime_error("stop");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(progress.open, 0);
  EXPECT_EQ(progress.last, 4.0);
}

TEST(RunContext, IsSilentAndSingleThreadedByDefault) {
  RunContext context;
  EXPECT_EQ(&context.progress, &silent_progress());
  EXPECT_EQ(context.threads, 1);
  EXPECT_FALSE(context.stop.stop_requested());
  ProgressTask task(context.progress, "nothing", 0.0);
  task.advance(1.0);
  context.progress.message(Level::error, "nobody hears it");
}

}  // namespace
}  // namespace pliant
