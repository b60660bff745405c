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
constexpr int kBentUnknowns = 6;
constexpr int kFewestBent = 15;  // points of which a motion of second order is told
constexpr double kWider = 1.4;   // reach at edges, where points lie on one side

/// Whether places lie in all directions about as far.
bool spreads(const Eigen::Matrix2Xd& rest) {
  constexpr double kThinnest = 0.05;  // across, over along
  const Eigen::Matrix2Xd centred = rest.colwise() - rest.rowwise().mean();
  const Eigen::Vector2d spread =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(centred * centred.transpose()).eigenvalues();
  return spread(0) > kThinnest * kThinnest * spread(1);
}

/// Whether places lie on all sides of one.
bool surrounds(const Eigen::Matrix2Xd& rest, const Eigen::Vector2d& place) {
  constexpr double kFewest = 0.15;  // of the places, on each side
  const Eigen::Matrix2Xd off = rest.colwise() - place;
  for (const Eigen::Index axis : {0, 1}) {
    const double share = (off.row(axis).array() > 0).cast<double>().mean();
    if (share < kFewest || share > 1 - kFewest) return false;
  }
  return spreads(rest);
}

/// Least squares of position = rows * coefficients, the first of which is the position sought and
/// the next two its slope.
MovedPlace fitted(const Eigen::MatrixXd& rows, const Eigen::Matrix3Xd& moved,
                  Eigen::MatrixX3d& coefficients) {
  const Eigen::LDLT<Eigen::MatrixXd> normal(rows.transpose() * rows);
  coefficients = normal.solve(rows.transpose() * moved.transpose());
  MovedPlace result;
  result.position = coefficients.row(0);
  result.slope = coefficients.middleRows<2>(1).transpose();
  result.leverage = normal.solve(Eigen::VectorXd::Unit(rows.cols(), 0))(0);
  if (rows.rows() > rows.cols()) {
    result.residual = (rows * coefficients - moved.transpose()).squaredNorm() /
                      static_cast<double>(3 * (rows.rows() - rows.cols()));
  }
  return result;
}

std::optional<MovedPlace> affine_at(const Eigen::Vector2d& place, const Eigen::Matrix2Xd& rest,
                                    const Eigen::Matrix3Xd& moved) {
  if (!spreads(rest)) return std::nullopt;
  Eigen::MatrixXd rows(rest.cols(), 3);
  rows.col(0).setOnes();
  rows.rightCols<2>() = (rest.colwise() - place).transpose();
  Eigen::MatrixX3d coefficients;
  return fitted(rows, moved, coefficients);
}

/// @param reach  of the points, by which their distances are scaled (m)
MovedPlace bent_at(const Eigen::Vector2d& place, const Eigen::Matrix2Xd& rest,
                   const Eigen::Matrix3Xd& moved, double reach, double patch) {
  const Eigen::MatrixX2d off = (rest.colwise() - place).transpose() / reach;
  Eigen::MatrixXd rows(rest.cols(), kBentUnknowns);
  rows << Eigen::VectorXd::Ones(rest.cols()), off, off.col(0).cwiseAbs2() / 2,
      off.col(0).cwiseProduct(off.col(1)), off.col(1).cwiseAbs2() / 2;
  Eigen::MatrixX3d coefficients;
  MovedPlace result = fitted(rows, moved, coefficients);
  const Eigen::Vector3d laplacian =
      (coefficients.row(3) + coefficients.row(5)).transpose() / (reach * reach);
  result.position -= patch * patch / 24 * laplacian;
  result.slope /= reach;
  return result;
}

}  // namespace

LocalMotion::LocalMotion(Eigen::Matrix2Xd rest, Eigen::Matrix3Xd moved, double reach)
    : rest_(std::move(rest)), moved_(std::move(moved)), near_(rest_, reach), reach_(reach) {}

void LocalMotion::bend(double patch) {
  patch_ = patch;
  wide_.emplace(rest_, kWider * reach_);
}

/// Of second order: at edges, and where points are few, by points from further around, as far as
/// these tell it. An affine motion would lead straight on where cloth bends.
std::optional<MovedPlace> LocalMotion::bent_motion(const Eigen::Vector2d& place,
                                                   const std::vector<int>& near) const {
  constexpr double kMostLeverage = 6;
  const Eigen::Matrix2Xd beside = rest_(Eigen::all, near);
  if (std::ssize(near) >= kFewestBent && surrounds(beside, place)) {
    return bent_at(place, beside, moved_(Eigen::all, near), reach_, *patch_);
  }
  const std::vector<int> more = wide_->around(place);
  const Eigen::Matrix2Xd rest = rest_(Eigen::all, more);
  if (std::ssize(more) < kFewestBent || !spreads(rest)) return std::nullopt;
  const MovedPlace moved = bent_at(place, rest, moved_(Eigen::all, more), reach_, *patch_);
  return moved.leverage <= kMostLeverage ? std::optional(moved) : std::nullopt;
}

std::optional<MovedPlace> LocalMotion::at(const Eigen::Vector2d& place, double gap) const {
  const std::vector<int> near = near_.around(place);
  if (static_cast<int>(near.size()) < kFewestPoints) return std::nullopt;
  const bool is_close =
      std::ranges::any_of(near, [&](int i) { return near_.distance(i, place) <= gap; });
  if (!is_close) return std::nullopt;
  if (patch_) return bent_motion(place, near);
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
