#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// What the middle third of a pulled sample did, frame by frame. Strains are engineering ones.
struct MiddleRecord {
  std::string direction;         ///< of the pull: weft or warp; of strips cut on the bias: bias
  double length = 0, width = 0;  ///< of the middle third along the pull, and of the sample (m)
  std::vector<double> strain, lateral_strain;  ///< NaN of frames that are left out

  /// @param pull  rest coordinate along which it is pulled
  /// @param size  of the sample (m)
  MiddleRecord(int pull, const Eigen::Vector2d& size);

  /// The affine motion of the points in the middle third.
  /// @param rest, moved  2 and 3 x points (m)
  /// @return false, and nothing is added, where fewer than five are there, or all in a line
  bool add(const Eigen::Matrix2Xd& rest, const Eigen::Matrix3Xd& moved);
  void add_nothing();

 private:
  int pull_;
};

}  // namespace pliant
