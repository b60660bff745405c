#include "pliant/capture/spline_picture.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

/// Turns samples into coefficients of the cubic B-spline through them, which is mirrored at both
/// ends: a causal and an anticausal recursion [Unser1999, Box 2].
template <class Line>
void to_coefficients(Line line) {
  const float pole = std::sqrt(3.0F) - 2;
  const Eigen::Index count = line.size();
  const Eigen::Index horizon = std::min<Eigen::Index>(count, 16);  // the pole's power is below 1e-9
  float sum = line(0), power = pole;
  for (Eigen::Index i = 1; i < horizon; ++i, power *= pole) sum += power * line(i);
  line *= 6;
  line(0) = 6 * sum;
  for (Eigen::Index i = 1; i < count; ++i) line(i) += pole * line(i - 1);
  line(count - 1) = pole / (pole * pole - 1) * (line(count - 1) + pole * line(count - 2));
  for (Eigen::Index i = count - 2; i >= 0; --i) line(i) = pole * (line(i + 1) - line(i));
}

/// Gives each sample a share of its neighbours; mirrored at both ends.
template <class Line>
void smooth(Line line, float share) {
  const Eigen::Index last = line.size() - 1;
  float before = line(1);
  for (Eigen::Index i = 0; i <= last; ++i) {
    const float own = line(i), after = i < last ? line(i + 1) : before;
    line(i) = (1 - 2 * share) * own + share * (before + after);
    before = own;
  }
}

/// Weights of four neighbouring coefficients at a share of the way between the middle two: four
/// polynomials of it at once.
struct Weights {
  float t;

  explicit Weights(float share) : t(share) {}

  Eigen::Vector4f value() const {
    const Eigen::Array4f cubic(-1, 3, -3, 1), square(3, -6, 3, 0), linear(-3, 0, 3, 0),
        constant(1, 4, 1, 0);
    return (((cubic * t + square) * t + linear) * t + constant) * (1.0F / 6);
  }
  Eigen::Vector4f slope() const {
    const Eigen::Array4f square(-1, 3, -3, 1), linear(2, -4, 2, 0), constant(-1, 0, 1, 0);
    return ((square * t + linear) * t + constant) * 0.5F;
  }
};

}  // namespace

SplinePicture::SplinePicture(const GreyPicture& picture, double smoothing)
    : smoothing_(smoothing),
      coefficients_(picture.rows() + 2 * kBorder, picture.cols() + 2 * kBorder) {
  PLIANT_ASSERT(picture.rows() >= 4 && picture.cols() >= 4, "a picture has pixels around a place");
  auto inner = coefficients_.block(kBorder, kBorder, picture.rows(), picture.cols());
  inner = picture;
  const auto share = static_cast<float>(smoothing);
  for (Eigen::Index row = 0; row < inner.rows(); ++row) {
    if (share > 0) smooth(inner.row(row), share);
    to_coefficients(inner.row(row));
  }
  for (Eigen::Index column = 0; column < inner.cols(); ++column) {
    if (share > 0) smooth(inner.col(column), share);
    to_coefficients(inner.col(column));
  }
  for (Eigen::Index i = 1; i <= kBorder; ++i) {
    const Eigen::Index left = kBorder, right = kBorder + picture.cols() - 1;
    coefficients_.col(left - i) = coefficients_.col(left + i);
    coefficients_.col(right + i) = coefficients_.col(right - i);
  }
  for (Eigen::Index i = 1; i <= kBorder; ++i) {
    const Eigen::Index top = kBorder, bottom = kBorder + picture.rows() - 1;
    coefficients_.row(top - i) = coefficients_.row(top + i);
    coefficients_.row(bottom + i) = coefficients_.row(bottom - i);
  }
}

/// The coefficients around a place, and what they count there.
struct SplinePicture::Neighbourhood {
  const float* corner;
  Eigen::Index stride;  // from row to row
  Weights across, down;

  auto row(int i) const { return Eigen::Map<const Eigen::Vector4f>(corner + i * stride); }
  /// Of the four rows, column by column.
  Eigen::Vector4f sum(const Eigen::Vector4f& weights) const {
    return weights(0) * row(0) + weights(1) * row(1) + weights(2) * row(2) + weights(3) * row(3);
  }
};

inline SplinePicture::Neighbourhood SplinePicture::around(const Eigen::Vector2d& place) const {
  // Places are not negative: cut off is rounded down.
  const auto column = static_cast<int>(place.x()), row = static_cast<int>(place.y());
  return {&coefficients_(row + kBorder - 1, column + kBorder - 1), coefficients_.cols(),
          Weights(static_cast<float>(place.x() - column)),
          Weights(static_cast<float>(place.y() - row))};
}

inline float SplinePicture::value_at(const Eigen::Vector2d& place) const {
  const Neighbourhood near = around(place);
  return near.sum(near.down.value()).dot(near.across.value());
}

float SplinePicture::value(const Eigen::Vector2d& place) const { return value_at(place); }

void SplinePicture::values(const Eigen::Vector2d& from, const Eigen::Vector2d& step,
                           std::span<float> values) const {
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = value_at(from + static_cast<double>(i) * step);
  }
}

double SplinePicture::noise_left(const Eigen::Vector2d& place) const {
  return noise_left_along(place.x()) * noise_left_along(place.y());
}

double SplinePicture::noise_left_along(double place) const {
  // A coefficient is the samples around it times factor pole^|distance| [Unser1999, Box 2]; what is
  // further away than this does not count.
  constexpr int kReach = 12;
  const double pole = std::sqrt(3.0) - 2, factor = 6 * pole / (pole * pole - 1);
  const Eigen::Vector4f values = Weights(static_cast<float>(place - std::floor(place))).value();
  const auto weight_of = [&](int sample) {
    double weight = 0;
    for (int i = 0; i < 4; ++i) weight += values[i] * std::pow(pole, std::abs(sample - i));
    return factor * weight;
  };
  double sum = 0;
  for (int pixel = -kReach; pixel <= kReach; ++pixel) {
    const double weight = (1 - 2 * smoothing_) * weight_of(pixel) +
                          smoothing_ * (weight_of(pixel - 1) + weight_of(pixel + 1));
    sum += weight * weight;
  }
  return sum;
}

PictureSample SplinePicture::sample(const Eigen::Vector2d& place) const {
  const Neighbourhood near = around(place);
  const Eigen::Vector4f across = near.across.value();
  const Eigen::Vector4f columns = near.sum(near.down.value());
  return {columns.dot(across),
          {columns.dot(near.across.slope()), near.sum(near.down.slope()).dot(across)}};
}

}  // namespace pliant
