#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// Places of a plane, sorted into cells, so that those near to another are found at once.
class NearPlaces {
 public:
  /// @param places  2 x places; at least one
  /// @param reach   how far near is, > 0, in the unit of the places
  NearPlaces(Eigen::Matrix2Xd places, double reach);

  /// Numbers of the places within reach, in order.
  std::vector<int> around(const Eigen::Vector2d& place) const;
  /// The nearest of them.
  std::optional<int> nearest(const Eigen::Vector2d& place) const;
  double distance(int number, const Eigen::Vector2d& place) const {
    return (places_.col(number) - place).norm();
  }

 private:
  Eigen::Vector2i cell_of(const Eigen::Vector2d& place) const;

  Eigen::Matrix2Xd places_;
  double reach_;
  Eigen::Vector2d corner_;
  Eigen::Vector2i cells_;
  std::vector<std::vector<int>> in_cell_;
};

}  // namespace pliant
