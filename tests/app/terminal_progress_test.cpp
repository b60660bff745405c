#include "apps/pliant/terminal_progress.h"

#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace pliant {
namespace {

/// A progress display whose clock the test sets.
class Display {
 public:
  explicit Display(TerminalProgress::Options options)
      : progress(out_, options, [this] { return seconds; }) {}

  std::string take() {
    std::string text = out_.str();
    out_.str({});
    return text;
  }

  double seconds = 0.0;

 private:
  std::ostringstream out_;

 public:
  TerminalProgress progress;
};

TEST(TerminalProgress, ShowsNothingForWorkUnderTwoSeconds) {
  for (const bool terminal : {false, true}) {
    Display display({.terminal = terminal});
    display.progress.begin("fit", 10.0);
    for (int i = 0; i < 10; ++i) {
      display.seconds = 0.19 * i;
      display.progress.advance(i);
    }
    display.progress.end();
    EXPECT_EQ(display.take(), "");
  }
}

TEST(TerminalProgress, DrawsABarWithTheTimeLeftAndRemovesIt) {
  Display display({.terminal = true});
  display.progress.begin("fit", 10.0);
  display.seconds = 30.0;
  display.progress.advance(3.0);
  EXPECT_EQ(display.take(), "\r\x1b[Kfit [#########.....................]  30 %, 1:10 min left");
  display.seconds = 30.05;  // too early to draw again
  display.progress.advance(4.0);
  EXPECT_EQ(display.take(), "");
  display.progress.end();
  EXPECT_EQ(display.take(), "\r\x1b[K");
}

TEST(TerminalProgress, PrintsPlainLinesEveryTwoSecondsElsewhere) {
  Display display({.terminal = false});
  display.progress.begin("fit", 100.0);
  for (int i = 1; i <= 10; ++i) {
    display.seconds = 0.5 * i;
    display.progress.advance(i);
  }
  display.progress.end();
  EXPECT_EQ(display.take(), "fit: 4 %, 48 s left\nfit: 8 %, 46 s left\n");
}

TEST(TerminalProgress, TellsTheTimeSpentWhereTheTotalIsUnknown) {
  Display display({.terminal = false});
  display.progress.begin("fit", 0.0);
  display.seconds = 3700.0;
  display.progress.advance(5.0);
  EXPECT_EQ(display.take(), "fit: 1:01 h\n");
}

TEST(TerminalProgress, PutsMessagesOnLinesOfTheirOwn) {
  Display display({.terminal = true});
  display.progress.begin("fit", 10.0);
  display.seconds = 5.0;
  display.progress.advance(5.0);
  display.take();
  display.progress.message(Level::warning, "slack");
  EXPECT_EQ(display.take(), "\r\x1b[Kwarning: slack\n");
  display.progress.message(Level::info, "12 rows");
  display.progress.message(Level::debug, "left out by default");
  EXPECT_EQ(display.take(), "12 rows\n");
}

TEST(TerminalProgress, KeepsOnlyWarningsAndErrorsWhenQuiet) {
  Display display({.terminal = true, .quiet = true});
  display.progress.begin("fit", 10.0);
  display.seconds = 5.0;
  display.progress.advance(5.0);
  display.progress.message(Level::info, "12 rows");
  display.progress.message(Level::warning, "slack");
  display.progress.end();
  EXPECT_EQ(display.take(), "warning: slack\n");
}

}  // namespace
}  // namespace pliant
