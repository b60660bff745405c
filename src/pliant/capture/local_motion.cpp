#include "pliant/capture/local_motion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "pliant/capture/median.h"
#include "pliant/capture/scattered.h"

namespace pliant {
namespace {

constexpr int kFewestPoints = 5;
constexpr int kBentUnknowns = 6;
constexpr int kFewestBent = 15;   // points of which a motion of second order is told
constexpr int kFewestSharp = 12;  // likewise where it bends sharply
constexpr double kWider = 1.4;    // reach at edges, where points lie on one side

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

/// By how much a position is off about, where the motion is not of second order (m): by what points
/// miss it, and the more the further it is carried beyond them.
double off_of(const MovedPlace& moved) { return std::sqrt(moved.residual) * moved.leverage; }

/// @param patches  sides of the squares whose means the points are (m)
/// @param reach    of the points, by which their distances are scaled (m)
MovedPlace bent_at(const Eigen::Vector2d& place, const Eigen::Matrix2Xd& rest,
                   const Eigen::Matrix3Xd& moved, const Eigen::VectorXd& patches, double reach) {
  const Eigen::MatrixX2d off = (rest.colwise() - place).transpose() / reach;
  const Eigen::VectorXd of_mean = (patches / reach).cwiseAbs2() / 24;
  Eigen::MatrixXd rows(rest.cols(), kBentUnknowns);
  rows << Eigen::VectorXd::Ones(rest.cols()), off, off.col(0).cwiseAbs2() / 2 + of_mean,
      off.col(0).cwiseProduct(off.col(1)), off.col(1).cwiseAbs2() / 2 + of_mean;
  Eigen::MatrixX3d coefficients;
  MovedPlace result = fitted(rows, moved, coefficients);
  result.slope /= reach;
  return result;
}

}  // namespace

LocalMotion::LocalMotion(Eigen::Matrix2Xd rest, Eigen::Matrix3Xd moved, double reach)
    : rest_(std::move(rest)), moved_(std::move(moved)), near_(rest_, reach), reach_(reach) {}

void LocalMotion::bend(Eigen::VectorXd patches) {
  patches_ = std::move(patches);
  wide_.emplace(rest_, kWider * reach_);
  constexpr int kProbes = 100;
  std::vector<double> residuals;
  for (const int i : scattered(static_cast<int>(rest_.cols()), kProbes)) {
    const Eigen::Vector2d place = rest_.col(i);
    if (const auto moved = bent_by(place, near_.around(place), kFewestBent)) {
      residuals.push_back(moved->residual);
    }
  }
  usual_ = residuals.empty() ? INFINITY : median(std::move(residuals));
}

/// Of second order: at edges, and where points are few, by points from further around, as far as
/// these tell it. An affine motion would lead straight on where cloth bends. Where points miss it
/// by more than they mostly do, cloth bends sharply: nearer ones tell it, or none.
std::optional<MovedPlace> LocalMotion::bent_motion(const Eigen::Vector2d& place,
                                                   const std::vector<int>& near) const {
  constexpr double kCloser = 0.7;     // of the reach, where cloth bends sharply
  constexpr double kAstray = 0.003;   // of the reach
  constexpr double kTimes = 3;        // what points mostly miss
  constexpr double kRounding = 1e-9;  // of the reach
  const auto usual = bent_by(place, near, kFewestBent);
  const bool is_inside = usual && surrounds(rest_(Eigen::all, near), place);
  const auto first = is_inside ? usual : bent_by(place, wide_->around(place), kFewestBent);
  const double smooth = kTimes * std::sqrt(usual_) + kRounding * reach_;
  if (first && std::sqrt(first->residual) <= smooth) return first;
  std::vector<int> close;
  std::ranges::copy_if(near, std::back_inserter(close),
                       [&](int i) { return near_.distance(i, place) <= kCloser * reach_; });
  std::vector<MovedPlace> tried;
  for (const auto& moved : {first, usual, bent_by(place, close, kFewestSharp)}) {
    if (moved && off_of(*moved) < std::max(kAstray * reach_, smooth)) tried.push_back(*moved);
  }
  if (tried.empty()) return std::nullopt;
  return *std::ranges::min_element(tried, {}, off_of);
}

/// By these points, as far as they tell it.
std::optional<MovedPlace> LocalMotion::bent_by(const Eigen::Vector2d& place,
                                               const std::vector<int>& points, int fewest) const {
  constexpr double kMostLeverage = 6;
  const Eigen::Matrix2Xd rest = rest_(Eigen::all, points);
  if (std::ssize(points) < fewest || !spreads(rest)) return std::nullopt;
  const MovedPlace moved =
      bent_at(place, rest, moved_(Eigen::all, points), patches_(points), reach_);
  return moved.leverage <= kMostLeverage ? std::optional(moved) : std::nullopt;
}

std::optional<MovedPlace> LocalMotion::at(const Eigen::Vector2d& place, double gap) const {
  const std::vector<int> near = near_.around(place);
  if (static_cast<int>(near.size()) < kFewestPoints) return std::nullopt;
  const bool is_close =
      std::ranges::any_of(near, [&](int i) { return near_.distance(i, place) <= gap; });
  if (!is_close) return std::nullopt;
  if (patches_.size() > 0) return bent_motion(place, near);
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
