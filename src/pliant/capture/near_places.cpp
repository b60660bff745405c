#include "pliant/capture/near_places.h"

#include <algorithm>
#include <utility>

namespace pliant {
namespace {

constexpr int kMostCells = 1000;  // along an axis

}  // namespace

NearPlaces::NearPlaces(Eigen::Matrix2Xd places, double reach)
    : places_(std::move(places)), reach_(reach) {
  corner_ = places_.rowwise().minCoeff();
  const Eigen::Vector2d size = places_.rowwise().maxCoeff() - corner_;
  cells_ = (size / reach_).array().floor().min(kMostCells - 1).cast<int>() + 1;
  in_cell_.resize(static_cast<std::size_t>(cells_.prod()));
  for (Eigen::Index i = 0; i < places_.cols(); ++i) {
    const Eigen::Vector2i cell = cell_of(places_.col(i));
    in_cell_[static_cast<std::size_t>(cell.y() * cells_.x() + cell.x())].push_back(
        static_cast<int>(i));
  }
}

Eigen::Vector2i NearPlaces::cell_of(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d at = (place - corner_) / reach_;
  return at.array().floor().max(0).min(cells_.cast<double>().array() - 1).cast<int>();
}

std::vector<int> NearPlaces::around(const Eigen::Vector2d& place) const {
  std::vector<int> near;
  const Eigen::Vector2i middle = cell_of(place);
  for (int y = std::max(middle.y() - 1, 0); y <= std::min(middle.y() + 1, cells_.y() - 1); ++y) {
    for (int x = std::max(middle.x() - 1, 0); x <= std::min(middle.x() + 1, cells_.x() - 1); ++x) {
      for (const int i : in_cell_[static_cast<std::size_t>(y * cells_.x() + x)]) {
        if (distance(i, place) <= reach_) near.push_back(i);
      }
    }
  }
  std::ranges::sort(near);
  return near;
}

std::optional<int> NearPlaces::nearest(const Eigen::Vector2d& place) const {
  const std::vector<int> near = around(place);
  if (near.empty()) return std::nullopt;
  return *std::ranges::min_element(near, {}, [&](int i) { return distance(i, place); });
}

}  // namespace pliant
