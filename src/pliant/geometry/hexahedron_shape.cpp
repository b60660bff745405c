#include "pliant/geometry/hexahedron_shape.h"

#include <cmath>

#include <Eigen/LU>

namespace pliant {
namespace {

// The nodes in the reference cube.
constexpr int kCorners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

// The factors (1 +- xi) / 2 of the shape function of a node, at the Gauss point in the octant of
// another.
Eigen::Vector3d factors(int node, int point) {
  Eigen::Vector3d result;
  for (int a = 0; a < 3; ++a) {
    result(a) = (1 + kCorners[node][a] * kCorners[point][a] / std::sqrt(3.0)) / 2;
  }
  return result;
}

Eigen::Matrix<double, 8, 3> gradients_at(int point) {
  Eigen::Matrix<double, 8, 3> gradients;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d f = factors(i, point);
    gradients.row(i) << kCorners[i][0] * f(1) * f(2), kCorners[i][1] * f(0) * f(2),
        kCorners[i][2] * f(0) * f(1);
  }
  return gradients / 2;
}

Eigen::Matrix<double, 8, 1> shares_at(int point) {
  Eigen::Matrix<double, 8, 1> shares;
  for (int i = 0; i < 8; ++i) shares(i) = factors(i, point).prod();
  return shares;
}

template <class Value>
std::array<Value, 8> at_all_points(Value (*at)(int)) {
  std::array<Value, 8> all;
  for (int p = 0; p < 8; ++p) all[static_cast<size_t>(p)] = at(p);
  return all;
}

}  // namespace

const std::array<Eigen::Matrix<double, 8, 3>, 8>& hexahedron_gradients() {
  static const auto all = at_all_points(gradients_at);
  return all;
}

const std::array<Eigen::Matrix<double, 8, 1>, 8>& hexahedron_shares() {
  static const auto all = at_all_points(shares_at);
  return all;
}

Eigen::Matrix<double, 8, 1> hexahedron_sizes(const Eigen::Matrix<double, 3, 8>& positions) {
  Eigen::Matrix<double, 8, 1> sizes;
  for (int p = 0; p < 8; ++p) {
    sizes(p) = (positions * hexahedron_gradients()[static_cast<size_t>(p)]).determinant();
  }
  return sizes;
}

}  // namespace pliant
