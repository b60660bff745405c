#pragma once

#include <string>

#include <Eigen/Core>

namespace pliant {

/// What would explain points that are not where they are expected: axes of the frames that are
/// exchanged or mirrored, in words for the end of a message; empty where no axes do.
/// @param found, expected  m, one column a point
/// @param most             distance that counts as fitting (m)
std::string explaining_axes(const Eigen::Matrix3Xd& found, const Eigen::Matrix3Xd& expected,
                            double most);

}  // namespace pliant
