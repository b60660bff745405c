#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// Pairs of triangles that pass through each other, the smaller number first, in rising order: a
/// side of one meets the inside of the other. Exact; triangles that only touch, or lie upon each
/// other, do not cross.
/// @param positions  finite, one column a vertex
/// @param triangles  vertices of each triangle, one column a triangle
/// @return nothing where the program was built without CGAL
std::optional<std::vector<std::array<int, 2>>> crossing_triangles(
    const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles);

/// The same between some triangles and others; each with its own number, the first of `one`.
std::optional<std::vector<std::array<int, 2>>> crossing_triangles(const Eigen::Matrix3Xd& positions,
                                                                  const Eigen::Matrix3Xi& one,
                                                                  const Eigen::Matrix3Xi& other);

}  // namespace pliant
