#include "pliant/imaging/strip_end.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace pliant {
namespace {

/// Mean place of the pixels whose ways are within a range.
Eigen::Vector2d mean_place(const Photo& way, double from, double to) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // x, y, number
  for (Eigen::Index row = 0; row < way.rows(); ++row) {
    for (Eigen::Index column = 0; column < way.cols(); ++column) {
      const auto length = static_cast<double>(way(row, column));
      if (length < from || length > to) continue;
      sum += Eigen::Vector3d(static_cast<double>(column), static_cast<double>(row), 1);
    }
  }
  return sum.head<2>() / std::max(sum.z(), 1.0);
}

double longest_way(const Photo& way) {
  double longest = 0;
  for (const float length : way.reshaped()) {
    if (std::isfinite(length)) longest = std::max(longest, static_cast<double>(length));
  }
  return longest;
}

/// Mean of a photograph over a band, of what lies within; 0 where nothing does.
/// @param from    the middle of its beginning
/// @param across  half of its width, as a vector
double mean_over(const Photo& photo, const Eigen::Vector2d& from, const Eigen::Vector2d& along,
                 const Eigen::Vector2d& across) {
  constexpr int kSteps = 12;
  double sum = 0;
  int count = 0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int k = -kSteps / 4; k <= kSteps / 4; ++k) {
      const Eigen::Vector2d at = from + along * i / kSteps + across * (4.0 * k / kSteps);
      const Eigen::Index column = std::lround(at.x()), row = std::lround(at.y());
      if (column < 0 || row < 0 || column >= photo.cols() || row >= photo.rows()) continue;
      sum += static_cast<double>(photo(row, column));
      ++count;
    }
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace

Photo ways_from_clamp(const PixelMask& inside) {
  const Eigen::Index rows = inside.rows(), columns = inside.cols();
  Photo way = Photo::Constant(rows, columns, std::numeric_limits<float>::infinity());
  using Reached = std::pair<float, Eigen::Index>;  // way, number of the pixel
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
  const auto reach = [&](Eigen::Index row, Eigen::Index column, float length) {
    if (row < 0 || column < 0 || row >= rows || column >= columns) return;
    if (!inside(row, column) || way(row, column) <= length) return;
    way(row, column) = length;
    front.emplace(length, row * columns + column);
  };
  Eigen::Index first = 0;
  while (first + 1 < columns && !inside.col(first).any()) ++first;
  for (Eigen::Index row = 0; row < rows; ++row) reach(row, first, 0);
  while (!front.empty()) {
    const auto [length, pixel] = front.top();
    front.pop();
    const Eigen::Index row = pixel / columns, column = pixel % columns;
    if (length > way(row, column)) continue;
    for (int down = -1; down <= 1; ++down) {
      for (int right = -1; right <= 1; ++right) {
        reach(row + down, column + right, length + std::hypot(float(down), float(right)));
      }
    }
  }
  return way;
}

StripEnd free_end(const PixelMask& inside, double thickness) {
  const Photo way = ways_from_clamp(inside);
  const double last = longest_way(way), back = std::min(4 * thickness, last / 2);
  StripEnd end;
  end.place = mean_place(way, last - thickness, last);
  const Eigen::Vector2d before = mean_place(way, last - back - thickness, last - back);
  end.direction = (end.place - before).normalized();
  return end;
}

bool goes_on_faintly(const Photo& contrast, float threshold, const StripEnd& end,
                     double thickness) {
  constexpr double kFrom = 1.5, kLength = 6, kHalfWidth = 1.0 / 3, kBeside = 2.5;  // thicknesses
  constexpr double kClear = 0.12;       // of the threshold
  constexpr int kStep = 5, kMost = 30;  // degrees
  double most = 0;
  for (int turn = -kMost; turn <= kMost; turn += kStep) {
    const Eigen::Vector2d along = Eigen::Rotation2Dd(turn * std::numbers::pi / 180) * end.direction;
    const Eigen::Vector2d left(-along.y(), along.x());
    const auto band = [&](double aside) {
      return mean_over(contrast, end.place + thickness * (kFrom * along + aside * left),
                       kLength * thickness * along, kHalfWidth * thickness * left);
    };
    most = std::max(most, band(0) - std::max(band(-kBeside), band(kBeside)));
  }
  return most > kClear * static_cast<double>(threshold);
}

}  // namespace pliant
