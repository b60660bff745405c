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
constexpr int kMostCells = 1000;  // along an axis

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
    : rest_(std::move(rest)), moved_(std::move(moved)), reach_(reach) {
  corner_ = rest_.rowwise().minCoeff();
  const Eigen::Vector2d size = rest_.rowwise().maxCoeff() - corner_;
  cells_ = (size / reach_).array().floor().min(kMostCells - 1).cast<int>() + 1;
  in_cell_.resize(static_cast<std::size_t>(cells_.prod()));
  for (Eigen::Index i = 0; i < rest_.cols(); ++i) {
    const Eigen::Vector2i cell = cell_of(rest_.col(i));
    in_cell_[static_cast<std::size_t>(cell.y() * cells_.x() + cell.x())].push_back(
        static_cast<int>(i));
  }
}

Eigen::Vector2i LocalMotion::cell_of(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d at = (place - corner_) / reach_;
  return at.array().floor().max(0).min(cells_.cast<double>().array() - 1).cast<int>();
}

std::vector<int> LocalMotion::points_near(const Eigen::Vector2d& place) const {
  std::vector<int> near;
  const Eigen::Vector2i middle = cell_of(place);
  for (int y = std::max(middle.y() - 1, 0); y <= std::min(middle.y() + 1, cells_.y() - 1); ++y) {
    for (int x = std::max(middle.x() - 1, 0); x <= std::min(middle.x() + 1, cells_.x() - 1); ++x) {
      for (const int i : in_cell_[static_cast<std::size_t>(y * cells_.x() + x)]) {
        if ((rest_.col(i) - place).norm() <= reach_) near.push_back(i);
      }
    }
  }
  std::ranges::sort(near);
  return near;
}

std::optional<MovedPlace> LocalMotion::at(const Eigen::Vector2d& place, double gap) const {
  const std::vector<int> near = points_near(place);
  if (static_cast<int>(near.size()) < kFewestPoints) return std::nullopt;
  const bool is_close =
      std::ranges::any_of(near, [&](int i) { return (rest_.col(i) - place).norm() <= gap; });
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
