#include "material/bent_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>

#include "pliant/base/errors.h"
#include "pliant/geometry/rest_patch.h"
#include "pliant/material/strain/discrete_shells.h"
#include "pliant/material/strain/stvk_membrane.h"

namespace pliant {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// A stencil with a quadratic density: energy = area / 2 strain^T stiffness strain.
template <class M>
struct Element {
  typename M::Rest rest;
  Eigen::Matrix<int, M::kNodes, 1> nodes;
  double area = 0, stiffness = 0;

  typename M::Positions at(const Eigen::Matrix3Xd& x) const {
    typename M::Positions positions;
    for (int i = 0; i < M::kNodes; ++i) positions.col(i) = x.col(nodes(i));
    return positions;
  }
  double energy(const Eigen::Matrix3Xd& x) const {
    return area / 2 * stiffness * M::strain(rest, at(x)).squaredNorm();
  }
};

struct Sheet {
  std::vector<Element<StvkMembrane>> triangles;
  std::vector<Element<DiscreteShells>> hinges;
  std::vector<std::array<int, 2>> hinge_triangles;
  std::vector<Eigen::Index> unknown;  // of each vertex; -1 where it is held
  Eigen::Index unknowns = 0;

  double energy(const Eigen::Matrix3Xd& x) const {
    double sum = 0;
    for (const auto& element : triangles) sum += element.energy(x);
    for (const auto& element : hinges) sum += element.energy(x);
    return sum;
  }
};

/// Gradient and Hessian over the vertices that are free.
struct Derivatives {
  Eigen::VectorXd gradient;
  std::vector<Eigen::Triplet<double>> hessian;

  template <class M>
  void add(const Element<M>& element, const Sheet& sheet, const Eigen::Matrix3Xd& x) {
    const auto positions = element.at(x);
    const typename M::Strain stress = element.stiffness * M::strain(element.rest, positions);
    const typename M::Gradient by_nodes = M::gradient(element.rest, positions);
    const Eigen::VectorXd force = element.area * by_nodes.transpose() * stress;
    const typename M::Hessian h =
        element.area * (element.stiffness * by_nodes.transpose() * by_nodes +
                        M::weighted_hessian(element.rest, positions, stress));
    for (int i = 0; i < M::kUnknowns; ++i) {
      const Eigen::Index row = sheet.unknown[element.nodes(i / 3)];
      if (row < 0) continue;
      gradient(3 * row + i % 3) += force(i);
      for (int j = 0; j < M::kUnknowns; ++j) {
        const Eigen::Index column = sheet.unknown[element.nodes(j / 3)];
        if (column >= 0) hessian.emplace_back(3 * row + i % 3, 3 * column + j % 3, h(i, j));
      }
    }
  }
};

Derivatives derivatives(const Sheet& sheet, const Eigen::Matrix3Xd& x) {
  Derivatives result{Eigen::VectorXd::Zero(3 * sheet.unknowns), {}};
  for (const auto& element : sheet.triangles) result.add(element, sheet, x);
  for (const auto& element : sheet.hinges) result.add(element, sheet, x);
  return result;
}

/// Newton's direction, with the Hessian shifted until it is positive definite.
Eigen::VectorXd descent(const Sheet& sheet, const Derivatives& d) {
  SparseMatrix hessian(3 * sheet.unknowns, 3 * sheet.unknowns), identity = hessian;
  hessian.setFromTriplets(d.hessian.begin(), d.hessian.end());
  identity.setIdentity();
  for (double shift = 0;; shift = std::max(2 * shift, 1e-6)) {
    const Eigen::SimplicialLDLT<SparseMatrix> factor(hessian + shift * identity);
    if (factor.info() == Eigen::Success && factor.vectorD().minCoeff() > 0) {
      return -factor.solve(d.gradient);
    }
  }
}

Eigen::Matrix3Xd moved(const Sheet& sheet, Eigen::Matrix3Xd x, const Eigen::VectorXd& step) {
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    if (sheet.unknown[i] >= 0) x.col(i) += step.segment<3>(3 * sheet.unknown[i]);
  }
  return x;
}

void find_equilibrium(const Sheet& sheet, Eigen::Matrix3Xd& x) {
  constexpr double kNearEnough = 1e-10;  // m, of the last step: far below the edges
  constexpr int kMaxIterations = 50;
  for (int i = 0; i < kMaxIterations; ++i) {
    Eigen::VectorXd step = descent(sheet, derivatives(sheet, x));
    if (step.lpNorm<Eigen::Infinity>() < kNearEnough) return;
    const double energy = sheet.energy(x);
    for (int halvings = 0; halvings < 30; ++halvings, step /= 2) {
      if (sheet.energy(moved(sheet, x, step)) < energy) break;
    }
    x = moved(sheet, x, step);
  }
  throw SolverError("the equilibrium of a bent sheet", kMaxIterations, 0);
}

Sheet make_sheet(const RestPatch& patch, const BentSheet& bent) {
  Sheet sheet;
  const TriangleMesh& mesh = patch.mesh;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const MembraneRest rest = membrane_rest(mesh.rest_triangle(t));
    sheet.triangles.push_back({rest, mesh.triangles.col(t), rest.area, bent.membrane_stiffness});
  }
  const std::vector<Hinge> hinges = find_hinges(mesh);
  const std::vector<BendingVector> weights = bending_weights(hinges, bending_rule(mesh));
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    sheet.hinges.push_back({{0, hinges[i].height, 0},
                            Eigen::Vector4i(hinges[i].vertices.data()),
                            hinges[i].area,
                            weights[i].dot(bent.hinge_stiffness)});
    sheet.hinge_triangles.push_back(hinges[i].triangles);
  }
  for (const int depth : patch.depths) {
    sheet.unknown.push_back(depth > 1 ? sheet.unknowns++ : -1);
  }
  return sheet;
}

Eigen::Matrix3Xd on_cylinder(const TriangleMesh& mesh, double curvature, double direction) {
  const Eigen::Vector2d across(std::cos(direction), std::sin(direction));
  const Eigen::Vector2d along(-across.y(), across.x());
  const Eigen::Vector2d centre = mesh.positions.topRows<2>().rowwise().mean();
  Eigen::Matrix3Xd x(3, mesh.vertex_count());
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    const Eigen::Vector2d place = mesh.positions.col(i).head<2>() - centre;
    const double angle = curvature * place.dot(across);
    x.col(i) << std::sin(angle) / curvature, place.dot(along), (1 - std::cos(angle)) / curvature;
  }
  return x;
}

/// Curvature of the cylinder nearest to some of the vertices, from a quadratic surface through them
/// by least squares; good to (curvature * size)^2 / 12. It is not quite the curvature of the rim,
/// which does not relax as the inside does and so turns it away by a fraction of about edge / size.
double mean_curvature(const Eigen::Matrix3Xd& x, const std::vector<bool>& counts) {
  Eigen::MatrixXd polynomials = Eigen::MatrixXd::Zero(x.cols(), 6);
  Eigen::VectorXd heights = Eigen::VectorXd::Zero(x.cols());
  const double size = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).maxCoeff();
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    if (!counts[i]) continue;
    const double across = x(0, i) / size, along = x(1, i) / size;
    polynomials.row(i) << across * across / 2, across * along, along * along / 2, across, along, 1;
    heights(i) = x(2, i);
  }
  const Eigen::Matrix<double, 6, 6> normal = polynomials.transpose() * polynomials;
  return normal.ldlt().solve(polynomials.transpose() * heights)(0) / (size * size);
}

}  // namespace

double shown_stiffness(const TriangleMesh& mesh, const BentSheet& bent) {
  constexpr int kCoreDepth = 4;
  const RestPatch patch = rest_patch(mesh, std::numeric_limits<int>::max());
  const Sheet sheet = make_sheet(patch, bent);
  Eigen::Matrix3Xd x = on_cylinder(patch.mesh, bent.curvature, bent.direction);
  find_equilibrium(sheet, x);

  std::vector<bool> is_deep, is_core;
  for (const int depth : patch.depths) is_deep.push_back(depth >= kCoreDepth);
  double energy = 0, area = 0;
  for (const auto& triangle : sheet.triangles) {
    is_core.push_back(is_deep[triangle.nodes(0)] && is_deep[triangle.nodes(1)] &&
                      is_deep[triangle.nodes(2)]);
    if (!is_core.back()) continue;
    energy += triangle.energy(x);
    area += triangle.area;
  }
  for (std::size_t i = 0; i < sheet.hinges.size(); ++i) {
    // Each triangle has a third of its area at a hinge.
    for (const int t : sheet.hinge_triangles[i]) {
      if (!is_core[t]) continue;
      energy += sheet.triangles[t].area / 3 / sheet.hinges[i].area * sheet.hinges[i].energy(x);
    }
  }
  const double curvature = mean_curvature(x, is_deep);
  return energy / area / (1.5 * curvature * curvature);
}

}  // namespace pliant
