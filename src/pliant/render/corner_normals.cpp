#include "pliant/render/corner_normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <boost/pending/disjoint_sets.hpp>

#include "pliant/geometry/topology.h"

namespace pliant {
namespace {

const float kCreaseCosine = std::cos(80 * std::numbers::pi_v<float> / 180);

float corner_angle(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// For each vertex the direction of the vectors of the triangles around it, by their angles there.
Eigen::Matrix3Xf mean_directions(const Eigen::Matrix3Xf& vectors, const Eigen::Matrix3Xf& positions,
                                 const Eigen::Matrix3Xi& triangles) {
  Eigen::Matrix3Xf directions = Eigen::Matrix3Xf::Zero(3, positions.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const Eigen::Matrix3f corners = positions(Eigen::all, triangles.col(t));
    for (int k = 0; k < 3; ++k) {
      const float angle = corner_angle(corners.col((k + 1) % 3) - corners.col(k),
                                       corners.col((k + 2) % 3) - corners.col(k));
      directions.col(triangles(k, t)) += angle * vectors.col(t);
    }
  }
  for (auto direction : directions.colwise()) direction.stableNormalize();
  return directions;
}

Eigen::Matrix3Xf triangle_normals(const Eigen::Matrix3Xf& positions,
                                  const Eigen::Matrix3Xi& triangles) {
  Eigen::Matrix3Xf normals(3, triangles.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const Eigen::Matrix3f corners = positions(Eigen::all, triangles.col(t));
    normals.col(t) =
        (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).stableNormalized();
  }
  return normals;
}

/// The corners of triangles in sets that share a normal.
class SmoothCorners {
 public:
  SmoothCorners(const Eigen::Matrix3Xi& triangles, const Eigen::Matrix3Xf& normals)
      : triangles_(triangles), sets_(static_cast<std::size_t>(triangles.size())) {
    const std::vector<TriangleSide> sides = sides_by_edge(triangles);
    for (auto begin = sides.begin(); begin != sides.end();) {
      const auto end = std::find_if_not(begin, sides.end(), [&](const TriangleSide& side) {
        return std::minmax(side.from, side.to) == std::minmax(begin->from, begin->to);
      });
      if (end - begin == 2) join_if_smooth(begin[0], begin[1], normals);
      begin = end;
    }
  }

  /// The number of each corner's set, from 0.
  Eigen::Matrix3Xi numbers() {
    Eigen::Matrix3Xi numbers(3, triangles_.cols());
    std::vector<int> of_set(static_cast<std::size_t>(triangles_.size()), -1);
    int next = 0;
    for (Eigen::Index corner = 0; corner < triangles_.size(); ++corner) {
      int& number = of_set[sets_.find_set(static_cast<std::size_t>(corner))];
      if (number < 0) number = next++;
      numbers(corner) = number;
    }
    return numbers;
  }

 private:
  void join_if_smooth(const TriangleSide& a, const TriangleSide& b,
                      const Eigen::Matrix3Xf& normals) {
    const bool front_meets_front = a.from == b.to;
    const float cosine = normals.col(a.triangle).dot(normals.col(b.triangle));
    if (!front_meets_front || !(cosine > kCreaseCosine)) return;
    sets_.union_set(corner(a, 0), corner(b, 1));
    sets_.union_set(corner(a, 1), corner(b, 0));
  }
  static std::size_t corner(const TriangleSide& side, int end) {
    return static_cast<std::size_t>(3 * side.triangle + (side.corner + end) % 3);
  }

  const Eigen::Matrix3Xi& triangles_;
  boost::disjoint_sets_with_storage<> sets_;
};

}  // namespace

Eigen::Matrix3Xf vertex_normals(const Eigen::Matrix3Xf& positions,
                                const Eigen::Matrix3Xi& triangles) {
  return mean_directions(triangle_normals(positions, triangles), positions, triangles);
}

CornerNormals corner_normals(const Eigen::Matrix3Xf& positions, const Eigen::Matrix3Xi& triangles) {
  const Eigen::Matrix3Xf flat = triangle_normals(positions, triangles);
  CornerNormals result{SmoothCorners(triangles, flat).numbers(), {}};
  // The mesh cut open along its creases.
  Eigen::Matrix3Xf cut(3, triangles.size() == 0 ? 0 : result.corners.maxCoeff() + 1);
  for (Eigen::Index c = 0; c < triangles.size(); ++c) {
    cut.col(result.corners(c)) = positions.col(triangles(c));
  }
  const Eigen::Matrix3Xf normals = mean_directions(flat, cut, result.corners);
  Eigen::Matrix3Xf means(3, triangles.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    means.col(t) = normals(Eigen::all, result.corners.col(t)).rowwise().sum();
  }
  result.normals = mean_directions(means, cut, result.corners);
  return result;
}

}  // namespace pliant
