// Least squares within a convex set: symmetric 2 x 2 matrices without negative eigenvalues.

#include "pliant/estimation/convex_search.h"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace pliant {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Solver = Eigen::SelfAdjointEigenSolver<Matrix2d>;

/// Their lengths are Frobenius norms.
Matrix2d matrix_of(const VectorXd& p) {
  Matrix2d matrix;
  matrix << p(0), p(1) / std::sqrt(2), p(1) / std::sqrt(2), p(2);
  return matrix;
}

VectorXd numbers_of(const Matrix2d& matrix) {
  return Vector3d(matrix(0, 0), std::sqrt(2) * matrix(0, 1), matrix(1, 1));
}

ConvexSet positive_matrices() {
  return {{}, [](const VectorXd& p) -> Eigen::MatrixXd {
            const Solver solver(matrix_of(p));
            if (solver.eigenvalues()(0) >= -1e-9) return Eigen::MatrixXd(0, 3);
            const Eigen::Vector2d v = solver.eigenvectors().col(0);
            return Eigen::RowVector3d(v(0) * v(0), std::sqrt(2) * v(0) * v(1), v(1) * v(1));
          }};
}

/// The distance of W p from W q.
LeastSquaresProblem distance(const Eigen::Matrix3d& w, const VectorXd& q) {
  LeastSquaresProblem problem;
  problem.residuals = 3;
  problem.lower = VectorXd::Constant(3, -1e6);
  problem.upper = VectorXd::Constant(3, 1e6);
  problem.scale = VectorXd::Ones(3);
  problem.evaluate = [=](const VectorXd& p, VectorXd& residual, Eigen::MatrixXd* jacobian) {
    residual = w * (p - q);
    if (jacobian) *jacobian = w;
    return true;
  };
  return problem;
}

const VectorXd kOutside = numbers_of((Matrix2d() << 1, 2, 2, -0.5).finished());

TEST(ConvexSearch, TheNearestPositiveMatrixIsThePositivePart) {
  const Solver solver(matrix_of(kOutside));
  const Matrix2d part = solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() *
                        solver.eigenvectors().transpose();
  const LeastSquaresProblem problem = distance(Eigen::Matrix3d::Identity(), kOutside);
  const VectorXd nearest = nearest_within(positive_matrices(), problem, kOutside, {});
  EXPECT_LT((nearest - numbers_of(part)).norm(), 1e-5);
}

TEST(ConvexSearch, AMatrixWithinIsItsOwnNearest) {
  const VectorXd within = numbers_of((Matrix2d() << 2, 1, 1, 3).finished());
  const LeastSquaresProblem problem = distance(Eigen::Matrix3d::Identity(), within);
  EXPECT_LT((nearest_within(positive_matrices(), problem, within, {}) - within).norm(), 1e-9);
}

/// Of all positive matrices s (cos, sin)(cos, sin)^T + t 1 none costs less.
TEST(ConvexSearch, FindsTheBestWithinAndProjectionsDoNot) {
  const Eigen::Matrix3d w = Vector3d(1, 3, 0.2).asDiagonal();
  const LeastSquaresProblem problem = distance(w, kOutside);
  const VectorXd start = numbers_of(Matrix2d::Identity());
  const LeastSquaresSummary within = solve_within(positive_matrices(), problem, start, {}, {});
  EXPECT_TRUE(within.converged);
  EXPECT_GT(Solver(matrix_of(within.parameters)).eigenvalues()(0), -1e-6);
  double least = INFINITY;
  for (int i = 0; i < 2000; ++i) {
    const double angle = M_PI * i / 2000;
    const Eigen::Vector2d v(std::cos(angle), std::sin(angle));
    const VectorXd along = numbers_of(v * v.transpose());
    const double size = (w * along).dot(w * kOutside) / (w * along).squaredNorm();
    least = std::min(least, (w * (size * along - kOutside)).squaredNorm() / 2);
  }
  EXPECT_NEAR(within.cost, least, 1e-4 * least);
  const LeastSquaresSummary projected =
      solve_projected(positive_matrices(), problem, start, {}, {});
  EXPECT_TRUE(projected.converged);
  EXPECT_GT(Solver(matrix_of(projected.parameters)).eigenvalues()(0), -1e-6);
  EXPECT_GT(projected.cost, 1.2 * within.cost);
}

}  // namespace
}  // namespace pliant
