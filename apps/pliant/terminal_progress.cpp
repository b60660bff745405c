#include "apps/pliant/terminal_progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <ostream>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

constexpr double kSilentSeconds = 2.0;  // work that is done by then shows nothing
constexpr double kLineSeconds = 2.0;    // between plain lines
constexpr double kRedrawSeconds = 0.1;  // between drawings of the bar
constexpr int kBarWidth = 30;
constexpr std::size_t kTaskWidth = 36;  // with the bar and the times, within 80 columns
constexpr const char* kClearLine = "\r\x1b[K";

std::string duration(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

/// Share of the work that is done, in [0, 1]; none when the total is unknown.
std::optional<double> share(double done, double total) {
  if (total <= 0.0) return std::nullopt;
  return std::clamp(done / total, 0.0, 1.0);
}

/// ", 12 s left" at the pace so far; empty while nothing is done.
std::string time_left(double elapsed, double done_share) {
  if (done_share <= 0.0) return {};
  return fmt::format(", {} left", duration(elapsed * (1.0 - done_share) / done_share));
}

const char* prefix(Level level) {
  switch (level) {
    case Level::debug:
      return "debug: ";
    case Level::info:
      return "";
    case Level::warning:
      return "warning: ";
    case Level::error:
      return "error: ";
  }
  return "";
}

}  // namespace

TerminalProgress::TerminalProgress(std::ostream& out, Options options, Clock clock)
    : out_(out), options_(options), clock_(std::move(clock)) {}

void TerminalProgress::begin(std::string_view task, double total) {
  task_ = one_line(task, kTaskWidth);
  total_ = total;
  begun_ = clock_();
  last_shown_ = begun_;
}

void TerminalProgress::advance(double done) {
  if (options_.quiet) return;
  const double now = clock_();
  if (now - begun_ < kSilentSeconds) return;
  if (now - last_shown_ < (options_.terminal ? kRedrawSeconds : kLineSeconds)) return;
  last_shown_ = now;
  if (options_.terminal) {
    draw_bar(now - begun_, done);
  } else {
    print_line(now - begun_, done);
  }
}

void TerminalProgress::end() { clear_bar(); }

void TerminalProgress::message(Level level, std::string_view text) {
  const Level lowest = options_.quiet ? std::max(Level::warning, options_.level) : options_.level;
  if (level < lowest) return;
  clear_bar();
  out_ << prefix(level) << text << '\n' << std::flush;
}

TerminalProgress::Clock TerminalProgress::steady_clock() {
  return [] {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
  };
}

void TerminalProgress::draw_bar(double elapsed, double done) {
  const std::optional<double> part = share(done, total_);
  if (part) {
    const int filled = static_cast<int>(*part * kBarWidth);
    out_ << fmt::format("{}{} [{:#<{}}{:.<{}}] {:3.0f} %{}", kClearLine, task_, "", filled, "",
                        kBarWidth - filled, 100.0 * *part, time_left(elapsed, *part));
  } else {
    out_ << fmt::format("{}{}, {}", kClearLine, task_, duration(elapsed));
  }
  out_ << std::flush;
  bar_shown_ = true;
}

void TerminalProgress::print_line(double elapsed, double done) {
  const std::optional<double> part = share(done, total_);
  const std::string state =
      part ? fmt::format("{:.0f} %{}", 100.0 * *part, time_left(elapsed, *part))
           : duration(elapsed);
  out_ << fmt::format("{}: {}\n", task_, state) << std::flush;
}

void TerminalProgress::clear_bar() {
  if (bar_shown_) out_ << kClearLine << std::flush;
  bar_shown_ = false;
}

}  // namespace pliant
