#pragma once

#include <cmath>

#include <Eigen/LU>

#include "pliant/capture/tag_detector.h"

namespace pliant::test {

/// Blurs a picture by a Gaussian.
/// @param sd  pixels
inline GreyPicture blurred(const GreyPicture& picture, double sd) {
  const int reach = static_cast<int>(std::ceil(4 * sd));
  Eigen::ArrayXf weights(2 * reach + 1);
  for (int i = -reach; i <= reach; ++i) {
    weights(i + reach) = static_cast<float>(std::exp(-i * i / (2 * sd * sd)));
  }
  weights /= weights.sum();
  GreyPicture along = GreyPicture::Zero(picture.rows(), picture.cols()), both = along;
  const auto inside = [](Eigen::Index i, Eigen::Index n) {
    return std::clamp<Eigen::Index>(i, 0, n - 1);
  };
  for (int i = -reach; i <= reach; ++i) {
    for (Eigen::Index c = 0; c < picture.cols(); ++c) {
      along.col(c) += weights(i + reach) * picture.col(inside(c + i, picture.cols()));
    }
  }
  for (int i = -reach; i <= reach; ++i) {
    for (Eigen::Index r = 0; r < picture.rows(); ++r) {
      both.row(r) += weights(i + reach) * along.row(inside(r + i, picture.rows()));
    }
  }
  return both;
}

/// The homography that takes the corners of the unit square (lower left, lower right, upper right,
/// upper left) to four places.
inline Eigen::Matrix3d homography_of_square(const Eigen::Matrix<double, 2, 4>& corners) {
  Eigen::Matrix<double, 8, 8> system;
  Eigen::Vector<double, 8> right;
  constexpr double kX[] = {0, 1, 1, 0}, kY[] = {0, 0, 1, 1};
  for (int i = 0; i < 4; ++i) {
    const double u = corners(0, i), v = corners(1, i);
    system.row(2 * i) << kX[i], kY[i], 1, 0, 0, 0, -u * kX[i], -u * kY[i];
    system.row(2 * i + 1) << 0, 0, 0, kX[i], kY[i], 1, -v * kX[i], -v * kY[i];
    right.segment<2>(2 * i) = corners.col(i);
  }
  const Eigen::Vector<double, 8> h = system.partialPivLu().solve(right);
  Eigen::Matrix3d result;
  result << h(0), h(1), h(2), h(3), h(4), h(5), h(6), h(7), 1;
  return result;
}

/// A tag on white paper, each pixel the mean of 8 x 8 places of it.
/// @param corners  pixels, as DetectedTag
/// @param blur     pixels
inline GreyPicture draw_tag(int columns, int rows, int code,
                            const Eigen::Matrix<double, 2, 4>& corners, double blur) {
  constexpr int kSamples = 8;
  const GreyPicture cells = tag_cells(code);
  const Eigen::Matrix3d to_square = homography_of_square(corners).inverse();
  GreyPicture picture(rows, columns);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      float sum = 0;
      for (int i = 0; i < kSamples * kSamples; ++i) {
        const double x = column - 0.5 + (i % kSamples + 0.5) / kSamples;
        const double y = row - 0.5 + (i / kSamples + 0.5) / kSamples;
        const Eigen::Vector2d place = (to_square * Eigen::Vector3d(x, y, 1)).hnormalized();
        const bool inside = place.minCoeff() >= 0 && place.maxCoeff() < 1;
        sum += !inside
                   ? 1.0f
                   : cells(static_cast<int>((1 - place.y()) * 8), static_cast<int>(place.x() * 8));
      }
      picture(row, column) = 0.1f + 0.8f * sum / (kSamples * kSamples);
    }
  }
  return blurred(picture, blur);
}

}  // namespace pliant::test
