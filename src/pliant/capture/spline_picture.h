#pragma once

#include <span>

#include <Eigen/Core>

namespace pliant {

/// Brightness, row 0 uppermost, column 0 leftmost, in any unit.
using GreyPicture = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A value between pixels, and how it changes.
struct PictureSample {
  float value = 0;
  Eigen::Vector2f gradient;  ///< by column and by row
};

/// A picture between its pixels: the cubic B-spline that passes through all of them, mirrored at
/// its border [Unser1999]. Places are (column, row), the middle of the first pixel being (0, 0).
///
/// Speckles of two or three pixels are finer than a spline can follow, and what it makes of them
/// depends on where between the pixels they lie: matches would be drawn by that. A little smoothing
/// before takes most of it away [Pan2013a].
class SplinePicture {
 public:
  /// @param picture    at least 4 x 4
  /// @param smoothing  share of each neighbour in a pixel, along rows and along columns
  explicit SplinePicture(const GreyPicture& picture, double smoothing = 0);

  Eigen::Index columns() const { return coefficients_.cols() - 2 * kBorder; }
  Eigen::Index rows() const { return coefficients_.rows() - 2 * kBorder; }
  /// Whether a place lies between the picture's pixels.
  bool contains(const Eigen::Vector2d& place) const {
    return place.x() >= 0 && place.y() >= 0 && place.x() <= static_cast<double>(columns() - 1) &&
           place.y() <= static_cast<double>(rows() - 1);
  }
  /// Whether both places at opposite sides of one do.
  bool contains_beside(const Eigen::Vector2d& place, const Eigen::Vector2d& aside) const {
    return contains(place - aside) && contains(place + aside);
  }
  /// @param place  in the picture
  float value(const Eigen::Vector2d& place) const;
  /// Of places in a line, one step apart.
  void values(const Eigen::Vector2d& from, const Eigen::Vector2d& step,
              std::span<float> values) const;
  PictureSample sample(const Eigen::Vector2d& place) const;
  /// Share of the variance of independent noise of the picture's pixels that is left at a place.
  double noise_left(const Eigen::Vector2d& place) const;

 private:
  static constexpr Eigen::Index kBorder = 2;

  struct Neighbourhood;

  float value_at(const Eigen::Vector2d& place) const;
  Neighbourhood around(const Eigen::Vector2d& place) const;
  double noise_left_along(double place) const;

  double smoothing_;
  GreyPicture coefficients_;  // with a border, so that no place needs a special case
};

}  // namespace pliant
