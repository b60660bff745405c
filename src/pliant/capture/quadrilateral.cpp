#include "pliant/capture/quadrilateral.h"

#include <algorithm>
#include <cmath>

namespace pliant {

namespace {

/// With its sides moved inwards.
Quadrilateral shrunk(const Quadrilateral& corners, double margin) {
  const auto unit = [&](int from, int to) -> Eigen::Vector2d {
    return (corners.col(to % 4) - corners.col(from % 4)).normalized();
  };
  Quadrilateral inner;
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector2d next = unit(k, k + 1), last = unit(k, k + 3);
    const double sine = std::abs(next.x() * last.y() - next.y() * last.x());
    inner.col(k) = corners.col(k) + margin / sine * (next + last);
  }
  return inner;
}

}  // namespace

bool is_within(const Quadrilateral& corners, const Eigen::Vector2d& place, double margin) {
  const auto left_of = [&](int k) {  // how far the place is left of a side
    const Eigen::Vector2d side = corners.col((k + 1) % 4) - corners.col(k);
    const Eigen::Vector2d way = place - corners.col(k);
    return (side.x() * way.y() - side.y() * way.x()) / side.norm();
  };
  double least = INFINITY, most = -INFINITY;
  for (int k = 0; k < 4; ++k) {
    least = std::min(least, left_of(k));
    most = std::max(most, left_of(k));
  }
  // All on one side, whichever way round the corners go.
  return least >= margin || most <= -margin;
}

std::vector<Eigen::Vector2d> places_within(const Quadrilateral& corners, int step, int margin) {
  constexpr double kRounding = 0.75;  // of a pixel, along both axes
  const Quadrilateral inner = shrunk(corners, margin);
  // Along the sides from the first corner to the second and to the fourth.
  const auto spaces = [&](int from, int to, int other_from, int other_to) {
    const double longest = std::max((inner.col(to) - inner.col(from)).norm(),
                                    (inner.col(other_to) - inner.col(other_from)).norm());
    return std::max(1, static_cast<int>(std::ceil(longest / step)));
  };
  const int across = spaces(0, 1, 3, 2), along = spaces(0, 3, 1, 2);
  std::vector<Eigen::Vector2d> places;
  for (int j = 0; j <= along; ++j) {
    const double v = static_cast<double>(j) / along;
    const Eigen::Vector2d from = (1 - v) * inner.col(0) + v * inner.col(3);
    const Eigen::Vector2d to = (1 - v) * inner.col(1) + v * inner.col(2);
    for (int i = 0; i <= across; ++i) {
      const double u = static_cast<double>(i) / across;
      const Eigen::Vector2d place = ((1 - u) * from + u * to).array().round();
      if (is_within(corners, place, margin - kRounding)) places.push_back(place);
    }
  }
  return places;
}

}  // namespace pliant
