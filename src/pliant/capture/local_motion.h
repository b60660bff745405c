#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/near_places.h"

namespace pliant {

/// Where a place of the sheet has gone, by the points around it.
struct MovedPlace {
  Eigen::Vector3d position;           ///< m
  Eigen::Matrix<double, 3, 2> slope;  ///< d position / d (u, v)
  double leverage =
      1;  ///< variance of `position` over that of a point, were all points independent
  double residual = 0;  ///< mean square by which a coordinate of the points misses (m^2)
};

/// Measured motion of scattered points, smoothed: near a place it is affine in the rest
/// coordinates, or of second order where cloth may bend, by least squares.
class LocalMotion {
 public:
  /// @param rest   2 x points, rest coordinates (m)
  /// @param moved  3 x points (m)
  /// @param reach  points within this distance of a place tell its motion (m)
  LocalMotion(Eigen::Matrix2Xd rest, Eigen::Matrix3Xd moved, double reach);

  /// From now on motions are of second order.
  /// @param patches  of each point, side of the square whose mean it is (m); where cloth bends it
  ///                 lies off it, by the square of the side over 24 times its Laplacian
  void bend(Eigen::VectorXd patches);

  /// @param gap  the nearest point may be this far away (m)
  /// @return nothing where no point is so near, or those in reach do not tell the motion: fewer
  ///         than five (of second order twelve), all in a line, too far on one side, or all about a
  ///         sharp bend
  std::optional<MovedPlace> at(const Eigen::Vector2d& place, double gap) const;

 private:
  std::optional<MovedPlace> bent_motion(const Eigen::Vector2d& place,
                                        const std::vector<int>& near) const;
  std::optional<MovedPlace> bent_by(const Eigen::Vector2d& place, const std::vector<int>& points,
                                    int fewest) const;

  Eigen::Matrix2Xd rest_;
  Eigen::Matrix3Xd moved_;
  NearPlaces near_;
  std::optional<NearPlaces> wide_;  // at edges, where motions are of second order
  double reach_;
  Eigen::VectorXd patches_;  // none: affine
  double usual_ = 0;         // mean square by which points miss, median (m^2)
};

/// The affine motion of points by least squares: position and slope at their middle. Nothing of
/// fewer than five, or where all lie in a line.
std::optional<MovedPlace> affine_motion(const Eigen::Matrix2Xd& rest,
                                        const Eigen::Matrix3Xd& moved);

/// Median distance of a point from its nearest neighbour, of some hundred points (m).
double point_spacing(const Eigen::Matrix2Xd& rest);

}  // namespace pliant
