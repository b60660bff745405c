#include "pliant/experiment/drape/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace pliant {
namespace {

using Spans = std::vector<std::pair<double, double>>;

/// Horizontal lines that an area is summed over: at 30 cm they lie 0.2 mm apart, and the sum is
/// right to 1e-5.
constexpr int kLines = 1500;

/// Where a horizontal line meets a triangle; nothing where it does not.
void add_span(const std::array<Eigen::Vector2d, 3>& corners, double y, Spans& spans) {
  double low = INFINITY, high = -INFINITY;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector2d &a = corners[k], &b = corners[(k + 1) % 3];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    const double x = a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y());
    low = std::min(low, x);
    high = std::max(high, x);
  }
  if (low < high) spans.emplace_back(low, high);
}

/// Length of the union of spans.
double covered(Spans& spans) {
  std::ranges::sort(spans);
  double length = 0, end = -INFINITY;
  for (const auto& [from, to] : spans) {
    if (to <= end) continue;
    length += to - std::max(from, end);
    end = to;
  }
  return length;
}

double covered_area(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles,
                    double disc) {
  const double low = std::min(positions.row(1).minCoeff(), -disc);
  const double high = std::max(positions.row(1).maxCoeff(), disc);
  const double apart = (high - low) / kLines;
  std::vector<Spans> lines(kLines);
  const auto y_of = [&](int line) { return low + (line + 0.5) * apart; };
  for (int line = 0; line < kLines; ++line) {
    const double half = disc * disc - y_of(line) * y_of(line);
    if (half <= 0) continue;
    lines[static_cast<std::size_t>(line)].emplace_back(-std::sqrt(half), std::sqrt(half));
  }
  for (const auto& triangle : triangles.colwise()) {
    std::array<Eigen::Vector2d, 3> corners;
    for (int k = 0; k < 3; ++k) {
      corners[static_cast<std::size_t>(k)] = positions.col(triangle[k]).head<2>();
    }
    const auto [bottom, top] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
    const int first = std::max(0, static_cast<int>((bottom - low) / apart - 0.5));
    const int last = std::min(kLines - 1, static_cast<int>((top - low) / apart + 0.5));
    for (int line = first; line <= last; ++line) {
      add_span(corners, y_of(line), lines[static_cast<std::size_t>(line)]);
    }
  }
  double length = 0;
  for (Spans& spans : lines) length += covered(spans);
  return length * apart;
}

constexpr double kTurn = 2 * std::numbers::pi;

/// Lengthens the radii that a side of a triangle crosses further out.
void widen(Eigen::Vector2d from, Eigen::Vector2d to, std::vector<double>& radii) {
  double begin = std::atan2(from.y(), from.x()), end = std::atan2(to.y(), to.x());
  if (std::remainder(end - begin, kTurn) < 0) {
    std::swap(from, to);
    std::swap(begin, end);
  }
  if (end < begin) end += kTurn;
  const Eigen::Vector2d along = to - from;
  const double apart = kTurn / kSilhouetteAngles;
  for (auto i = static_cast<long>(std::ceil(begin / apart)); static_cast<double>(i) * apart <= end;
       ++i) {
    const double angle = static_cast<double>(i) * apart;
    const Eigen::Vector2d ray(std::cos(angle), std::sin(angle));
    const double slant = ray.x() * along.y() - ray.y() * along.x();
    if (slant == 0) continue;
    const double radius = (from.x() * along.y() - from.y() * along.x()) / slant;
    const long place = (i % kSilhouetteAngles + kSilhouetteAngles) % kSilhouetteAngles;
    double& outermost = radii[static_cast<std::size_t>(place)];
    outermost = std::max(outermost, radius);
  }
}

}  // namespace

Silhouette silhouette_of(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles,
                         double disc) {
  Silhouette silhouette;
  silhouette.area = covered_area(positions, triangles, disc);
  silhouette.radii.assign(kSilhouetteAngles, disc);
  for (const auto& triangle : triangles.colwise()) {
    for (int k = 0; k < 3; ++k) {
      widen(positions.col(triangle[k]).head<2>(), positions.col(triangle[(k + 1) % 3]).head<2>(),
            silhouette.radii);
    }
  }
  return silhouette;
}

}  // namespace pliant
