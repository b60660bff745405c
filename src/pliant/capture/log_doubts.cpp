#include "pliant/capture/log_doubts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <Eigen/QR>
#include <fmt/format.h>

#include "pliant/base/quantity.h"

namespace pliant {
namespace {

double size_of(double force) { return std::isnan(force) ? 0 : std::abs(force); }

}  // namespace

std::optional<double> limit_of(const std::vector<double>& readings) {
  constexpr int kFewest = 3, kTimes = 4;  // pairs of rows; as many as elsewhere
  const double largest = size_of(*std::ranges::max_element(readings, {}, size_of));
  int at_largest = 0, elsewhere = 0;
  for (std::size_t row = 1; row < readings.size(); ++row) {
    if (readings[row] != readings[row - 1]) continue;
    ++(size_of(readings[row]) == largest ? at_largest : elsewhere);
  }
  if (largest == 0 || at_largest < kFewest || at_largest <= kTimes * elsewhere) return {};
  return largest;
}

std::string limit_doubt(const std::vector<double>& readings) {
  const auto limit = limit_of(readings);
  if (!limit) return {};
  return fmt::format(
      "reads {} again and again: a cell at the limit of its range, or one that is not connected? "
      "Frames at it are left out",
      format_quantity(*limit, Dimension::force, 4));
}

std::vector<double> without_limit(std::vector<double> readings) {
  if (const auto limit = limit_of(readings)) {
    std::ranges::replace_if(
        readings, [&](double force) { return size_of(force) == *limit; },
        std::numeric_limits<double>::quiet_NaN());
  }
  return readings;
}

std::string extension_doubt(const std::vector<double>& extension, const std::vector<double>& way) {
  constexpr std::size_t kFewest = 4;
  constexpr double kMost = 0.05;  // of the range of the way
  std::vector<std::size_t> frames;
  for (std::size_t f = 0; f < std::min(extension.size(), way.size()); ++f) {
    if (std::isfinite(extension[f]) && std::isfinite(way[f])) frames.push_back(f);
  }
  if (frames.size() < kFewest) return {};
  Eigen::MatrixXd line(std::ssize(frames), 2);
  Eigen::VectorXd seen(std::ssize(frames));
  for (Eigen::Index i = 0; i < seen.size(); ++i) {
    const std::size_t f = frames[static_cast<std::size_t>(i)];
    line.row(i) << 1, extension[f];
    seen(i) = way[f];
  }
  const Eigen::VectorXd left = seen - line * line.colPivHouseholderQr().solve(seen);
  const double range = seen.maxCoeff() - seen.minCoeff();
  if (left.norm() / std::sqrt(static_cast<double>(left.size())) <= kMost * range) return {};
  Eigen::Index worst = 0;
  const double most = left.cwiseAbs().maxCoeff(&worst);
  return fmt::format(
      "the extension of the log and the way of its clip in the pictures do not go together: they "
      "are {} apart in frame {}: are rows and pictures of the same moments?",
      format_quantity(most, Dimension::length, 3), frames[static_cast<std::size_t>(worst)]);
}

}  // namespace pliant
