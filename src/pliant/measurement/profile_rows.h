#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "pliant/measurement/data_source.h"

namespace pliant {

/// A strip's profile as it was measured: consecutive rows, from the clamp to the free end.
struct ProfileRows {
  double setting = 0;  ///< what the experiment varies: overhang or radius (m)
  int specimen = 0;
  int first = 0;
  std::vector<Eigen::Vector2d> points;  ///< m, from the first: gravity along -y, clamp along +x

  /// Share of each point in the length of the line through the points, 0 to 1.
  std::vector<double> shares() const;
};

/// Reads profiles: a new one begins with point 0, or where the setting or the repeat changes.
/// @param setting  name of the column of what the experiment varies
/// @throws InputError for points out of order, points that coincide, a line through them that
///         turns back, or a profile of fewer than five points
std::vector<ProfileRows> read_profiles(const DataRows& data, std::string_view setting);

}  // namespace pliant
