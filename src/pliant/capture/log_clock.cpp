#include "pliant/capture/log_clock.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <Eigen/LU>
#include <Eigen/QR>
#include <fmt/format.h>

#include "pliant/capture/line_through_rows.h"

namespace pliant {
namespace {

constexpr int kFewestFrames = 5;  // of a way that goes straight; one more of a parabola
constexpr double kCovered = 0.8;  // of the frames, by the log

/// Both motions where a start puts the frames within the log.
struct Overlap {
  std::vector<double> seen, logged;
  std::vector<double> speed;  // of the log, a second
  std::vector<double> rise;   // of the log while the frame stands still

  Eigen::Index size() const { return std::ssize(seen); }
};

Eigen::Map<const Eigen::VectorXd> vector_of(const std::vector<double>& values) {
  return {values.data(), std::ssize(values)};
}

struct Alignment {
  double start = 0;
  double unlike = 1;  // share of the variance of the ways that the log does not tell, and of that
                      // of the log what it moves while frames stand still
};

class ClockFinder {
 public:
  ClockFinder(const ClockLog& log, const std::vector<double>& ways, double rate)
      : log_(log), rate_(rate) {
    for (std::size_t f = 0; f < ways.size(); ++f) {
      if (std::isnan(ways[f])) continue;
      frames_.push_back(static_cast<double>(f));
      ways_.push_back(ways[f]);
    }
  }

  ClockSearch found() const {
    if (std::ssize(frames_) < fewest_frames()) {
      return {{}, fmt::format("hardly a frame shows {}", moved())};
    }
    if (log_.time.size() < 2) return {{}, kShort};
    const std::vector<Alignment> all = alignments();
    if (all.empty()) return {{}, kShort};
    const auto best = std::ranges::min_element(all, {}, &Alignment::unlike);
    const double most_unlike = log_.goes_straight ? 0.02 : 0.1;
    if (best->unlike > most_unlike) {
      return {{},
              fmt::format("{} does not move as the log's {} does: at best they correlate by {:.3f}",
                          moved(), log_.goes_straight ? "extension" : "force",
                          std::sqrt(std::max(1 - best->unlike, 0.0)))};
    }
    if (const auto other = rival(all, *best)) return two_starts(best->start, *other);
    if (log_.still > 0) return middle_of_step(all, *best);
    const ClockSearch search = refined(best->start);
    return search.why == steady() ? middle_of_step(all, *best) : search;
  }

 private:
  int fewest_frames() const { return log_.goes_straight ? kFewestFrames : kFewestFrames + 1; }

  std::optional<Overlap> overlap(double start) const {
    Overlap overlap;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const double time = start + frames_[i] / rate_;
      if (time < log_.time.front() || time > log_.time.back()) continue;
      const LinePiece piece = line_at(log_.time, log_.value, time);
      overlap.seen.push_back(ways_[i]);
      overlap.logged.push_back(piece.value);
      overlap.speed.push_back(piece.slope);
      overlap.rise.push_back(value_at(time + log_.still / 2) - value_at(time - log_.still / 2));
    }
    const double least =
        std::max<double>(fewest_frames(), kCovered * static_cast<double>(frames_.size()));
    if (static_cast<double>(overlap.seen.size()) < least) return std::nullopt;
    return overlap;
  }

  double value_at(double time) const {
    return line_at(log_.time, log_.value, std::clamp(time, log_.time.front(), log_.time.back()))
        .value;
  }

  /// Rows of what ways are of: a constant, the log, and its square where they go by a parabola.
  Eigen::MatrixXd rows_of(const Overlap& overlap) const {
    const Eigen::VectorXd logged = vector_of(overlap.logged);
    Eigen::MatrixXd rows(logged.size(), log_.goes_straight ? 2 : 3);
    rows.col(0).setOnes();
    rows.col(1) = logged;
    if (!log_.goes_straight) rows.col(2) = logged.cwiseAbs2();
    return rows;
  }

  double unlike(const Overlap& overlap) const {
    const Eigen::ArrayXd seen = vector_of(overlap.seen).array() - vector_of(overlap.seen).mean();
    const Eigen::ArrayXd logged =
        vector_of(overlap.logged).array() - vector_of(overlap.logged).mean();
    if (!((seen * logged).sum() > 0)) return 1;
    const Eigen::MatrixXd rows = rows_of(overlap);
    const Eigen::VectorXd left =
        seen.matrix() - rows * rows.colPivHouseholderQr().solve(seen.matrix());
    return left.squaredNorm() / seen.square().sum() +
           vector_of(overlap.rise).squaredNorm() / logged.square().sum();
  }

  /// A quarter of a frame or of the log's rows apart, whatever is finer.
  std::vector<Alignment> alignments() const {
    constexpr int kMost = 40000;
    const double length = log_.time.back() - log_.time.front();
    const double of_frames = frames_.back() / rate_;
    const double rows = static_cast<double>(log_.time.size() - 1);
    const double step =
        std::max(std::min(1 / rate_, length / rows) / 4, (length + of_frames) / kMost);
    std::vector<Alignment> all;
    for (double start = log_.time.front() - of_frames; start <= log_.time.back(); start += step) {
      const auto both = overlap(start);
      if (both) all.push_back({start, unlike(*both)});
    }
    return all;
  }

  /// By how much a start may be unlike that is about as good.
  static double as_good_as(const Alignment& best) {
    constexpr double kTimes = 4, kRounding = 1e-6;
    return kTimes * best.unlike + kRounding;
  }

  /// Another start that is about as good, beyond a hill.
  static std::optional<double> rival(const std::vector<Alignment>& all, const Alignment& best) {
    constexpr double kHill = 20, kHighest = 0.5;
    const double as_good = as_good_as(best);
    const auto at = static_cast<std::size_t>(&best - all.data());
    const auto beyond = [&](auto begin, auto end) -> std::optional<double> {
      double hill = 0;
      for (auto it = begin; it != end; ++it) {
        hill = std::max(hill, it->unlike);
        if (it->unlike < as_good && hill > std::min(kHill * as_good, kHighest)) return it->start;
      }
      return std::nullopt;
    };
    const auto after = beyond(all.begin() + static_cast<std::ptrdiff_t>(at), all.end());
    return after ? after
                 : beyond(all.rbegin() + static_cast<std::ptrdiff_t>(all.size() - 1 - at),
                          all.rend());
  }

  /// Where the log stands still while frames are taken, all starts of a while are alike.
  ClockSearch middle_of_step(const std::vector<Alignment>& all, const Alignment& best) const {
    constexpr double kHill = 3;
    const double frame = 1 / rate_;
    const double level = as_good_as(best);
    double hill = 0;
    for (const Alignment& other : all) {
      if (std::abs(other.start - best.start) < frame) hill = std::max(hill, other.unlike);
    }
    if (hill < kHill * level) return {{}, steady()};
    const auto is_above = [&](const Alignment& other) { return other.unlike > level; };
    const auto at = all.begin() + (&best - all.data());
    const auto after = std::find_if(at, all.end(), is_above);
    const auto before = std::find_if(std::make_reverse_iterator(at), all.rend(), is_above);
    if (after == all.end() || before == all.rend()) return {{}, steady()};
    const double width = after->start - before->start;
    if (width > frame) return {{}, steady()};
    // Steps that go evenly up are alike a step later.
    for (const Alignment& other : all) {
      const bool is_beyond = other.start < before->start || other.start > after->start;
      if (is_beyond && !is_above(other)) return two_starts(best.start, other.start);
    }
    return {LogClock{(after->start + before->start) / 2, width / std::sqrt(12.0),
                     std::sqrt(std::max(1 - best.unlike, 0.0))},
            {}};
  }

  static ClockSearch two_starts(double best, double other) {
    return {
        {},
        fmt::format("motions go together with the first frame at {:.4g} s as well as at {:.4g} s",
                    best, other)};
  }

  /// By Gauss and Newton's method in the start and the coefficients of the way.
  ClockSearch refined(double start) const {
    constexpr int kRounds = 20;
    LogClock clock{start, 0, 0};
    for (int round = 0; round < kRounds; ++round) {
      const auto both = overlap(clock.start);
      if (!both) return {{}, kShort};
      const Eigen::MatrixXd own = rows_of(*both);
      const Eigen::Index last = own.cols();
      const Eigen::VectorXd seen = vector_of(both->seen);
      const Eigen::VectorXd law = own.colPivHouseholderQr().solve(seen);
      const Eigen::VectorXd residual = seen - own * law;
      Eigen::VectorXd by_value = Eigen::VectorXd::Constant(both->size(), law(1));
      if (!log_.goes_straight) by_value += 2 * law(2) * vector_of(both->logged);
      Eigen::MatrixXd rows(both->size(), last + 1);
      rows << own, by_value.cwiseProduct(vector_of(both->speed));
      const auto qr = rows.colPivHouseholderQr();
      if (qr.rank() <= last) return {{}, steady()};
      const double step = qr.solve(residual)(last);
      clock.start += step;
      const double variance = residual.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(
                                                           both->size() - last - 1, 1));
      const Eigen::MatrixXd normal = rows.transpose() * rows;
      clock.error = std::sqrt(variance * normal.inverse()(last, last));
      clock.correlation = std::sqrt(std::max(1 - unlike(*both), 0.0));
      if (std::abs(step) < 1e-3 * clock.error + 1e-9) break;
    }
    constexpr double kMostError = 0.5;  // frames
    if (!(clock.error < kMostError / rate_)) return {{}, steady()};
    return {clock, {}};
  }

  const char* moved() const { return log_.goes_straight ? "the clip" : "what cords pull"; }
  std::string steady() const {
    return fmt::format("{} moves too steadily to tell by it when a frame was taken", moved());
  }

  static constexpr const char* kShort = "the log is shorter than the frames";

  const ClockLog& log_;
  double rate_;
  std::vector<double> frames_, ways_;  // of those that show the clip
};

}  // namespace

ClockSearch find_clock(const ClockLog& log, const std::vector<double>& ways, double rate) {
  return ClockFinder(log, ways, rate).found();
}

}  // namespace pliant
