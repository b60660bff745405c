#include "pliant/capture/log_clock.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include "pliant/capture/line_through_rows.h"

namespace pliant {
namespace {

constexpr int kFewestFrames = 5;
constexpr double kCovered = 0.8;  // of the frames, by the log

/// Both motions where a start puts the frames within the log.
struct Overlap {
  std::vector<double> seen, logged, speed;  // of the log (m/s)
};

struct Alignment {
  double start = 0;
  double unlike = 1;  // share of the variance of the ways that the log does not tell
};

class ClockFinder {
 public:
  ClockFinder(const std::vector<double>& times, const std::vector<double>& extension,
              const std::vector<double>& ways, double rate)
      : times_(times), extension_(extension), rate_(rate) {
    for (std::size_t f = 0; f < ways.size(); ++f) {
      if (std::isnan(ways[f])) continue;
      frames_.push_back(static_cast<double>(f));
      ways_.push_back(ways[f]);
    }
  }

  ClockSearch found() const {
    if (std::ssize(frames_) < kFewestFrames) return {{}, "hardly a frame shows the clip"};
    const std::vector<Alignment> all = alignments();
    if (all.empty()) return {{}, "the log is shorter than the frames"};
    const auto best = std::ranges::min_element(all, {}, &Alignment::unlike);
    constexpr double kMostUnlike = 0.02;
    if (best->unlike > kMostUnlike) {
      return {{},
              fmt::format("the clip does not move as the log's extension does: at best they "
                          "correlate by {:.3f}",
                          std::sqrt(1 - best->unlike))};
    }
    if (const auto other = rival(all, *best)) {
      return {{},
              fmt::format("motions go together with the first frame at {:.4g} s as well as at "
                          "{:.4g} s",
                          best->start, *other)};
    }
    return refined(best->start);
  }

 private:
  std::optional<Overlap> overlap(double start) const {
    Overlap overlap;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const double time = start + frames_[i] / rate_;
      if (time < times_.front() || time > times_.back()) continue;
      const LinePiece piece = line_at(times_, extension_, time);
      overlap.seen.push_back(ways_[i]);
      overlap.logged.push_back(piece.value);
      overlap.speed.push_back(piece.slope);
    }
    const double least =
        std::max<double>(kFewestFrames, kCovered * static_cast<double>(frames_.size()));
    if (static_cast<double>(overlap.seen.size()) < least) return std::nullopt;
    return overlap;
  }

  static double unlike(const Overlap& overlap) {
    const auto size = static_cast<Eigen::Index>(overlap.seen.size());
    Eigen::ArrayXd seen = Eigen::Map<const Eigen::ArrayXd>(overlap.seen.data(), size);
    Eigen::ArrayXd logged = Eigen::Map<const Eigen::ArrayXd>(overlap.logged.data(), size);
    seen -= seen.mean();
    logged -= logged.mean();
    const double product = (seen * logged).sum();
    const double squares = seen.square().sum() * logged.square().sum();
    return squares > 0 && product > 0 ? 1 - product * product / squares : 1;
  }

  /// A quarter of a frame or of the log's rows apart, whatever is finer.
  std::vector<Alignment> alignments() const {
    constexpr int kMost = 40000;
    const double length = times_.back() - times_.front();
    const double of_frames = frames_.back() / rate_;
    const double rows = static_cast<double>(times_.size() - 1);
    const double step =
        std::max(std::min(1 / rate_, length / rows) / 4, (length + of_frames) / kMost);
    std::vector<Alignment> all;
    for (double start = times_.front() - of_frames; start <= times_.back(); start += step) {
      const auto both = overlap(start);
      if (both) all.push_back({start, unlike(*both)});
    }
    return all;
  }

  /// Another start that is about as good, beyond a hill.
  static std::optional<double> rival(const std::vector<Alignment>& all, const Alignment& best) {
    constexpr double kAsGood = 4, kHill = 20, kRounding = 1e-6;
    const double as_good = kAsGood * best.unlike + kRounding;
    const auto at = static_cast<std::size_t>(&best - all.data());
    const auto beyond = [&](auto begin, auto end) -> std::optional<double> {
      double hill = 0;
      for (auto it = begin; it != end; ++it) {
        hill = std::max(hill, it->unlike);
        if (it->unlike < as_good && hill > kHill * as_good) return it->start;
      }
      return std::nullopt;
    };
    const auto after = beyond(all.begin() + static_cast<std::ptrdiff_t>(at), all.end());
    return after ? after
                 : beyond(all.rbegin() + static_cast<std::ptrdiff_t>(all.size() - 1 - at),
                          all.rend());
  }

  /// By Gauss and Newton's method in start, offset and gain.
  ClockSearch refined(double start) const {
    constexpr int kRounds = 20;
    LogClock clock{start, 0, 0};
    for (int round = 0; round < kRounds; ++round) {
      const auto both = overlap(clock.start);
      if (!both) return {{}, "the log is shorter than the frames"};
      const auto size = static_cast<Eigen::Index>(both->seen.size());
      Eigen::MatrixX3d rows(size, 3);
      rows.col(0).setOnes();
      rows.col(1) = Eigen::Map<const Eigen::VectorXd>(both->logged.data(), size);
      const Eigen::VectorXd seen = Eigen::Map<const Eigen::VectorXd>(both->seen.data(), size);
      const Eigen::Vector2d line = rows.leftCols<2>().colPivHouseholderQr().solve(seen);
      const Eigen::VectorXd residual = seen - rows.leftCols<2>() * line;
      rows.col(2) = line(1) * Eigen::Map<const Eigen::VectorXd>(both->speed.data(), size);
      const Eigen::Matrix3d normal = rows.transpose() * rows;
      const auto qr = rows.colPivHouseholderQr();
      if (qr.rank() < 3) return {{}, kSteady};
      const double step = qr.solve(residual)(2);
      clock.start += step;
      const double variance =
          residual.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(size - 3, 1));
      clock.error = std::sqrt(variance * normal.inverse()(2, 2));
      clock.correlation = std::sqrt(1 - unlike(*both));
      if (std::abs(step) < 1e-3 * clock.error + 1e-9) break;
    }
    constexpr double kMostError = 0.5;  // frames
    if (!(clock.error < kMostError / rate_)) return {{}, kSteady};
    return {clock, {}};
  }

  static constexpr const char* kSteady =
      "the clip moves too steadily to tell by it when a frame was taken";

  const std::vector<double>&times_, &extension_;
  double rate_;
  std::vector<double> frames_, ways_;  // of those that show the clip
};

}  // namespace

ClockSearch find_clock(const std::vector<double>& times, const std::vector<double>& extension,
                       const std::vector<double>& ways, double rate) {
  return ClockFinder(times, extension, ways, rate).found();
}

}  // namespace pliant
