#include "pliant/capture/reference_patch.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace pliant {
namespace {

/// The motion that undoes `step` first: x -> motion(step^-1(x)), about the middle of the patch.
PatchMotion after_undoing(const PatchMotion& motion, const Eigen::Matrix<double, 6, 1>& step) {
  Eigen::Matrix2d by;
  by << 1 + step(2), step(3), step(4), 1 + step(5);
  const Eigen::Matrix2d slope = (Eigen::Matrix2d::Identity() + motion.slope) * by.inverse();
  return {motion.shift - slope * step.head<2>(), slope - Eigen::Matrix2d::Identity()};
}

}  // namespace

std::optional<ReferencePatch> ReferencePatch::of(const SplinePicture& picture,
                                                 const Eigen::Vector2d& place, int radius) {
  if (!picture.contains_beside(place, Eigen::Vector2d::Constant(radius))) return std::nullopt;
  ReferencePatch patch;
  patch.place_ = place;
  patch.radius_ = radius;
  patch.noise_left_ = picture.noise_left(place);
  const int side = 2 * radius + 1;
  const Eigen::Index pixels = side * side;
  patch.values_.resize(pixels);
  patch.across_.resize(pixels);
  patch.down_.resize(pixels);
  Eigen::Matrix<float, Eigen::Dynamic, 6> steps(pixels, 6);  // d value / d motion
  int i = 0;
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x, ++i) {
      const Eigen::Vector2f off(static_cast<float>(x), static_cast<float>(y));
      const PictureSample sample = picture.sample(place + off.cast<double>());
      patch.values_(i) = sample.value;
      patch.across_(i) = sample.gradient.x();
      patch.down_(i) = sample.gradient.y();
      steps.row(i) << sample.gradient.x(), sample.gradient.y(), sample.gradient.x() * off.x(),
          sample.gradient.x() * off.y(), sample.gradient.y() * off.x(),
          sample.gradient.y() * off.y();
    }
  }
  patch.values_ -= patch.values_.mean();
  patch.norm_ = patch.values_.matrix().cast<double>().norm();
  if (!(patch.norm_ > 0)) return std::nullopt;
  // What a step does beyond a change of brightness and of contrast.
  const Eigen::RowVectorXf mean = steps.colwise().mean();
  steps.rowwise() -= mean;
  const Eigen::VectorXf unit = patch.values_.matrix() / static_cast<float>(patch.norm_);
  const Eigen::RowVectorXf bright = unit.transpose() * steps;
  steps -= unit * bright;
  patch.mean_step_ = mean.transpose().cast<double>();
  patch.bright_step_ = bright.transpose().cast<double>() / patch.norm_;
  const Eigen::Matrix<double, 6, 6> normal = (steps.transpose() * steps).cast<double>();
  // A patch without texture, or with stripes alone, could be anywhere, or anywhere along them.
  constexpr double kFlat = 1e-4;
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> factor(normal);
  const Eigen::Vector2d along = normal.diagonal().head<2>();
  const double crossed = normal.topLeftCorner<2, 2>().determinant();
  if (factor.info() != Eigen::Success || !(crossed > kFlat * along.maxCoeff() * along.maxCoeff())) {
    return std::nullopt;
  }
  patch.inverse_ = factor.solve(Eigen::Matrix<double, 6, 6>::Identity());
  return patch;
}

ReferencePatch::Vector6 ReferencePatch::along_steps(const Eigen::ArrayXf& numbers) const {
  using Square = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Index side = 2 * radius_ + 1;
  const auto reach = static_cast<float>(radius_);
  const Eigen::VectorXf off = Eigen::VectorXf::LinSpaced(side, -reach, reach);
  Vector6 sums;
  for (Eigen::Index k = 0; k < 2; ++k) {
    const Eigen::ArrayXf product = (k == 0 ? across_ : down_) * numbers;
    const Eigen::Map<const Square> square(product.data(), side, side);
    const Eigen::VectorXf by_column = square.colwise().sum().transpose();
    const Eigen::VectorXf by_row = square.rowwise().sum();
    sums(k) = by_column.sum();
    sums(2 + 2 * k) = by_column.dot(off);
    sums(3 + 2 * k) = by_row.dot(off);
  }
  return sums;
}

ReferencePatch::Vector6 ReferencePatch::along_free_steps(const Eigen::ArrayXf& numbers) const {
  const double sum = numbers.sum(), along_values = (values_ * numbers).sum();
  return along_steps(numbers) - mean_step_ * sum - bright_step_ * along_values;
}

bool ReferencePatch::sample(const SplinePicture& picture, const PatchMotion& motion,
                            Eigen::ArrayXf& values) const {
  const Eigen::Matrix2d slope = Eigen::Matrix2d::Identity() + motion.slope;
  const Eigen::Vector2d middle = place_ + motion.shift;
  for (const int x : {-radius_, radius_}) {
    for (const int y : {-radius_, radius_}) {
      if (!picture.contains(middle + slope * Eigen::Vector2d(x, y))) return false;
    }
  }
  const auto side = static_cast<std::size_t>(2 * radius_ + 1);
  const std::span<float> all(values.data(), side * side);
  for (std::size_t row = 0; row < side; ++row) {
    const Eigen::Vector2d first(-radius_, static_cast<double>(row) - radius_);
    picture.values(middle + slope * first, slope.col(0), all.subspan(row * side, side));
  }
  return true;
}

std::optional<double> ReferencePatch::correlation(const SplinePicture& picture,
                                                  const PatchMotion& motion) const {
  Eigen::ArrayXf values(values_.size());
  if (!sample(picture, motion, values)) return std::nullopt;
  values -= values.mean();
  const double norm = values.matrix().cast<double>().norm();
  if (!(norm > 0)) return std::nullopt;
  return values.matrix().dot(values_.matrix()) / (norm * norm_);
}

std::optional<PatchMatch> ReferencePatch::match(const SplinePicture& picture,
                                                const PatchMotion& start) const {
  constexpr int kMostIterations = 30;
  constexpr double kExact = 1e-4;  // pixels
  constexpr int kUnknowns = 8;     // six of the motion, brightness and contrast
  constexpr int kFirstSteps = 5;
  constexpr double kHopeless = 0.5;  // correlation after these: it goes astray
  PatchMatch result;
  result.motion = start;
  Eigen::ArrayXf values(values_.size());
  for (result.iterations = 1; result.iterations <= kMostIterations; ++result.iterations) {
    if (!sample(picture, result.motion, values)) return std::nullopt;
    values -= values.mean();
    const double norm = values.matrix().cast<double>().norm();
    if (!(norm > 0)) return std::nullopt;
    result.correlation = values.matrix().dot(values_.matrix()) / (norm * norm_);
    if (result.iterations > kFirstSteps && result.correlation < kHopeless) return std::nullopt;
    const Eigen::ArrayXf missed = values * static_cast<float>(norm_ / norm) - values_;
    const Vector6 step = inverse_ * along_free_steps(missed);
    result.motion = after_undoing(result.motion, step);
    const double moved = std::max(step.head<2>().norm(), radius_ * step.tail<4>().norm());
    if (!std::isfinite(moved) || moved > radius_) return std::nullopt;
    if (moved > kExact) continue;
    const double left = missed.matrix().cast<double>().squaredNorm();
    const auto rows = static_cast<double>(values_.size());
    // Both pictures have the noise. Smoothing and interpolation take some of it from a pixel, and
    // give it to the neighbours: over a patch it counts as before.
    const double variance = left / (rows - kUnknowns) /
                            (noise_left_ + picture.noise_left(place_ + result.motion.shift));
    result.noise = std::sqrt(variance);
    result.covariance = 2 * variance * inverse_.topLeftCorner<2, 2>();
    return result;
  }
  return std::nullopt;
}

}  // namespace pliant
