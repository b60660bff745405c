#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "pliant/base/progress.h"

namespace pliant {

/// Shows the progress of long work and its messages on standard error.
///
/// On a terminal: one line with a bar and the time left, redrawn in place and gone at the end.
/// Elsewhere: plain lines, at most one every two seconds. Work of less than two seconds shows
/// nothing. Messages are lines of their own ("warning: ...").
class TerminalProgress : public Progress {
 public:
  struct Options {
    bool terminal = false;      ///< `out` is a terminal
    bool quiet = false;         ///< no progress, and no messages below warnings
    Level level = Level::info;  ///< messages below it are left out
  };
  /// Seconds from any origin.
  using Clock = std::function<double()>;

  TerminalProgress(std::ostream& out, Options options, Clock clock = steady_clock());

  void begin(std::string_view task, double total) override;
  void advance(double done) override;
  void end() override;
  void message(Level level, std::string_view text) override;

  static Clock steady_clock();

 private:
  void draw_bar(double elapsed, double done);
  void print_line(double elapsed, double done);
  void clear_bar();

  std::ostream& out_;
  Options options_;
  Clock clock_;
  std::string task_;
  double total_ = 0.0;
  double begun_ = 0.0;
  double last_shown_ = 0.0;
  bool bar_shown_ = false;
};

}  // namespace pliant
