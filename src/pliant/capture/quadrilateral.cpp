#include "pliant/capture/quadrilateral.h"

#include <algorithm>
#include <cmath>

namespace pliant {

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
  constexpr double kRounding = 1e-6;  // of a pixel
  const Eigen::Vector2d least = corners.rowwise().minCoeff(), most = corners.rowwise().maxCoeff();
  const Eigen::Vector2i from = (least.array() + margin).ceil().cast<int>();
  const Eigen::Vector2i to = (most.array() - margin).floor().cast<int>();
  std::vector<Eigen::Vector2d> places;
  for (int y = from.y(); y <= to.y(); y += step) {
    for (int x = from.x(); x <= to.x(); x += step) {
      const Eigen::Vector2d place(x, y);
      if (is_within(corners, place, margin - kRounding)) places.push_back(place);
    }
  }
  return places;
}

}  // namespace pliant
