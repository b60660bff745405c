#include "pliant/material/strain/discrete_shells.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "pliant/math/cross_matrix.h"

namespace pliant {
namespace {

using Vector = Eigen::Vector3d;
using RowVector = Eigen::RowVector3d;
using Matrix = Eigen::Matrix3d;
using ByEdges = Eigen::Matrix<double, 3, 9>;  // derivatives w.r.t. (edge, side 1, side 2)

// One wing of a hinge: the triangle of the edge and a vertex at `side` from the edge's first node.
// `turn` is 1 for the triangle that has the edge in its own direction, -1 for the other.
struct Wing {
  Vector edge, side;
  double turn = 1;
  Vector normal = turn * edge.cross(side);

  // d theta / d vertex: the vertex moves across the wing at its height over the edge.
  Vector vertex_gradient() const { return -edge.norm() / normal.squaredNorm() * normal; }

  // Where the vertex stands along the edge, 0 at its first node and 1 at its second.
  double share() const { return side.dot(edge) / edge.squaredNorm(); }

  RowVector share_by_side() const { return edge.transpose() / edge.squaredNorm(); }
  RowVector share_by_edge() const {
    return (side - 2 * share() * edge).transpose() / edge.squaredNorm();
  }

  // Derivatives of the vertex gradient.
  Matrix gradient_by_side() const { return by_normal() * turn * cross_matrix(edge); }
  Matrix gradient_by_edge() const {
    return -normal / normal.squaredNorm() * edge.transpose() / edge.norm() -
           by_normal() * turn * cross_matrix(side);
  }

  Matrix by_normal() const {
    const double n2 = normal.squaredNorm();
    return -edge.norm() / n2 * (Matrix::Identity() - 2 / n2 * normal * normal.transpose());
  }
};

struct FoldedHinge {
  Wing first, second;
};

FoldedHinge hinge_of(const DiscreteShells::Positions& x) {
  const Vector edge = x.col(1) - x.col(0);
  return {Wing{edge, x.col(2) - x.col(0), 1}, Wing{edge, x.col(3) - x.col(0), -1}};
}

// From derivatives w.r.t. (edge, side 1, side 2) to those w.r.t. the four nodes.
template <int Rows>
Eigen::Matrix<double, Rows, 12> by_nodes(const Eigen::Matrix<double, Rows, 9>& d) {
  Eigen::Matrix<double, Rows, 12> result;
  result << -d.template leftCols<3>() - d.template middleCols<3>(3) - d.template rightCols<3>(), d;
  return result;
}

}  // namespace

double dihedral_angle(const DiscreteShells::Positions& positions) {
  const FoldedHinge hinge = hinge_of(positions);
  const Vector& n1 = hinge.first.normal;
  const Vector& n2 = hinge.second.normal;
  const double sine = n1.cross(n2).dot(hinge.first.edge) / hinge.first.edge.norm();
  return std::atan2(sine, n1.dot(n2));
}

double continued_angle(double angle, double near) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return angle + kTurn * std::round((near - angle) / kTurn);
}

DiscreteShells::Rest DiscreteShells::continued(const Rest& rest, const Strain& last) {
  constexpr double kQuarter = std::numbers::pi / 2;
  const double angle = rest.angle + last(0) * rest.height / 3;
  return {rest.angle, rest.height, angle - std::clamp(angle, -kQuarter, kQuarter)};
}

DiscreteShells::Strain DiscreteShells::strain(const Rest& rest, const Positions& positions) {
  const double angle = continued_angle(dihedral_angle(positions), rest.near_angle);
  return Strain(3 * (angle - rest.angle) / rest.height);
}

// Rigid motions leave theta unchanged: the edge's nodes balance the force and the moment of the two
// vertices, each by the vertex' share along the edge. A share over the wing's height is the cosine
// over a height of [Tamstorf2013].
DiscreteShells::Gradient DiscreteShells::gradient(const Rest& rest, const Positions& positions) {
  const FoldedHinge hinge = hinge_of(positions);
  const Vector g1 = hinge.first.vertex_gradient(), g2 = hinge.second.vertex_gradient();
  const double t1 = hinge.first.share(), t2 = hinge.second.share();
  Gradient result;
  result << (-(1 - t1) * g1 - (1 - t2) * g2).transpose(), (-t1 * g1 - t2 * g2).transpose(),
      g1.transpose(), g2.transpose();
  return 3 / rest.height * result;
}

// The Hessian of theta ([Tamstorf2013]), by edge and sides in place of normals in the planes of the
// wings: the gradient's derivatives, whose sum over the nodes is zero.
DiscreteShells::Hessian DiscreteShells::weighted_hessian(const Rest& rest,
                                                         const Positions& positions,
                                                         const Strain& y) {
  const FoldedHinge hinge = hinge_of(positions);
  const Vector g1 = hinge.first.vertex_gradient(), g2 = hinge.second.vertex_gradient();
  const double t1 = hinge.first.share(), t2 = hinge.second.share();
  ByEdges dg1, dg2;
  dg1 << hinge.first.gradient_by_edge(), hinge.first.gradient_by_side(), Matrix::Zero();
  dg2 << hinge.second.gradient_by_edge(), Matrix::Zero(), hinge.second.gradient_by_side();
  Eigen::Matrix<double, 1, 9> dt1, dt2;
  dt1 << hinge.first.share_by_edge(), hinge.first.share_by_side(), RowVector::Zero();
  dt2 << hinge.second.share_by_edge(), RowVector::Zero(), hinge.second.share_by_side();

  const ByEdges at_second_node = -t1 * dg1 - g1 * dt1 - t2 * dg2 - g2 * dt2;
  Eigen::Matrix<double, 12, 9> rows;
  rows << -dg1 - dg2 - at_second_node, at_second_node, dg1, dg2;
  return 3 / rest.height * y(0) * by_nodes<12>(rows);
}

}  // namespace pliant
