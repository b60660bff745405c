#pragma once

#include <vector>

#include <Eigen/Core>

namespace pliant {

/// A smooth line in the plane: cubic splines along points, in the sense of least squares.
class SplineLine {
 public:
  /// @param points  in their order along the line, neighbours apart
  /// @param shares  of each point in the length of the line through them, ascending from 0 to 1
  /// @param spans   cubic pieces of equal share, at least 1
  SplineLine(const std::vector<Eigen::Vector2d>& points, const std::vector<double>& shares,
             int spans);

  /// @param share  0 to 1
  Eigen::Vector2d position(double share) const;
  /// d position / d share.
  Eigen::Vector2d direction(double share) const;
  /// Positive where the line turns left.
  double curvature(double share) const;

 private:
  Eigen::Matrix<double, 2, Eigen::Dynamic> derivatives(double share, int order) const;

  Eigen::RowVectorXd knots_;
  Eigen::MatrixXd controls_;  // 2 x control points
};

/// Share of each point in the length of the line through the points, 0 to 1.
std::vector<double> length_shares(const std::vector<Eigen::Vector2d>& points);

}  // namespace pliant
