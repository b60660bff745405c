#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "pliant/capture/homography.h"
#include "pliant/capture/printed_board.h"

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

/// A tag on white paper, each pixel the mean of 8 x 8 places of it.
/// @param corners  pixels, as DetectedTag
/// @param blur     pixels
inline GreyPicture draw_tag(int columns, int rows, int code,
                            const Eigen::Matrix<double, 2, 4>& corners, double blur) {
  constexpr int kSamples = 8;
  const PrintedBoard tag({1, 1, 1, 0.25, code});  // of side 1
  Eigen::Matrix<double, 2, 4> square;
  square << 0, 1, 1, 0, 0, 0, 1, 1;
  const Eigen::Matrix3d to_square = homography(corners, square);
  GreyPicture picture(rows, columns);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      double sum = 0;
      for (int i = 0; i < kSamples * kSamples; ++i) {
        const double x = column - 0.5 + (i % kSamples + 0.5) / kSamples;
        const double y = row - 0.5 + (i / kSamples + 0.5) / kSamples;
        sum += tag.at((to_square * Eigen::Vector3d(x, y, 1)).hnormalized());
      }
      picture(row, column) = static_cast<float>(0.1 + 0.8 * sum / (kSamples * kSamples));
    }
  }
  return blurred(picture, blur);
}

}  // namespace pliant::test
