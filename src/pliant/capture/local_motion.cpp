#include "pliant/capture/local_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "pliant/capture/median.h"

namespace pliant {
namespace {

constexpr int kFewestPoints = 5;
constexpr int kUnknowns = 3;

/// Least squares of position = a + slope (rest - place).
std::optional<MovedPlace> affine_at(const Eigen::Vector2d& place, const Eigen::Matrix2Xd& rest,
                                    const Eigen::Matrix3Xd& moved) {
  constexpr double kThinnest = 0.05;  // of the points' spread across, over that along
  const Eigen::Index count = rest.cols();
  Eigen::MatrixX3d rows(count, 3);
  rows.col(0).setOnes();
  rows.rightCols<2>() = (rest.colwise() - place).transpose();
  const Eigen::Matrix2Xd centred = rest.colwise() - rest.rowwise().mean();
  const Eigen::Vector2d spread =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(centred * centred.transpose()).eigenvalues();
  if (!(spread(0) > kThinnest * kThinnest * spread(1))) return std::nullopt;
  const Eigen::LDLT<Eigen::Matrix3d> normal(rows.transpose() * rows);
  const Eigen::Matrix3d solution = normal.solve(rows.transpose() * moved.transpose());
  MovedPlace result;
  result.position = solution.row(0);
  result.slope = solution.bottomRows<2>().transpose();
  result.leverage = normal.solve(Eigen::Vector3d::UnitX())(0);
  if (count > kUnknowns) {
    result.residual = (rows * solution - moved.transpose()).squaredNorm() /
                      static_cast<double>(3 * (count - kUnknowns));
  }
  return result;
}

}  // namespace

LocalMotion::LocalMotion(Eigen::Matrix2Xd rest, Eigen::Matrix3Xd moved, double reach)
    : rest_(std::move(rest)), moved_(std::move(moved)), near_(rest_, reach) {}

std::optional<MovedPlace> LocalMotion::at(const Eigen::Vector2d& place, double gap) const {
  const std::vector<int> near = near_.around(place);
  if (static_cast<int>(near.size()) < kFewestPoints) return std::nullopt;
  const bool is_close =
      std::ranges::any_of(near, [&](int i) { return near_.distance(i, place) <= gap; });
  if (!is_close) return std::nullopt;
  return affine_at(place, rest_(Eigen::all, near), moved_(Eigen::all, near));
}

std::optional<MovedPlace> affine_motion(const Eigen::Matrix2Xd& rest,
                                        const Eigen::Matrix3Xd& moved) {
  if (rest.cols() < kFewestPoints) return std::nullopt;
  return affine_at(rest.rowwise().mean(), rest, moved);
}

double point_spacing(const Eigen::Matrix2Xd& rest) {
  constexpr Eigen::Index kMostProbes = 500;
  const Eigen::Index step = std::max<Eigen::Index>(rest.cols() / kMostProbes, 1);
  std::vector<double> nearest;
  for (Eigen::Index i = 0; i < rest.cols(); i += step) {
    Eigen::VectorXd distance = (rest.colwise() - rest.col(i)).colwise().norm();
    distance(i) = INFINITY;
    nearest.push_back(distance.minCoeff());
  }
  return median(std::move(nearest));
}

}  // namespace pliant
