#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// Triangles in a hierarchy of boxes along the axes, made once and fitted to where they are.
class TriangleTree {
 public:
  /// @param positions  at which triangles that are near each other come into one branch (m)
  /// @param triangles  at least one
  TriangleTree(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles);

  /// Calls `visit` with each pair of triangles whose boxes come within `reach` of each other while
  /// all their corners go straight ways at once, a smaller number first, in a fixed order.
  /// @param ways  of all points (m)
  void pairs(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xd& ways, double reach,
             const std::function<void(int, int)>& visit) const;

 private:
  // Children follow their parent; a leaf has a triangle in place of a second child.
  struct Node {
    int first = -1, second = 0;
    bool is_leaf() const { return first < 0; }
  };
  // What the corners of triangles span, and their ways.
  struct Span {
    Eigen::Array3d low, high, least_way, most_way;

    void include(const Span& other);
    double volume() const { return (high - low).prod(); }
  };

  int build(std::vector<int>& triangles, size_t begin, size_t end, const Eigen::Matrix3Xd& middles);
  std::vector<Span> fitted(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xd& ways) const;
  static bool may_meet(const Span& one, const Span& other, double reach);

  Eigen::Matrix3Xi triangles_;
  std::vector<Node> nodes_;
};

}  // namespace pliant
