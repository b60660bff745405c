#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "pliant/base/random.h"
#include "pliant/capture/lens.h"
#include "pliant/capture/printed_board.h"
#include "pliant/capture/spline_picture.h"

#include "capture/texture.h"

namespace pliant::test {

/// Pixels from the middle of a pixel at which it sees a share of its light on one side: a square
/// pixel behind a lens that blurs by as much.
inline double blurred_share(double share) {
  return share < 0.5 ? std::sqrt(2 * share) - 1 : 1 - std::sqrt(2 * (1 - share));
}

/// The binary digits of a number behind the point.
inline double reversed_bits(int number) {
  double value = 0;
  for (double digit = 0.5; number > 0; number /= 2, digit /= 2) value += digit * (number % 2);
  return value;
}

/// Brightness of a pixel around a place: the mean of what is there.
/// @param at  of a place (pixels)
template <class At>
double seen_by_pixel(const Eigen::Vector2d& pixel, int samples, const At& at) {
  double sum = 0;
  for (int sample = 0; sample < samples; ++sample) {
    // No two in a row or column: edges along them would move in steps.
    const Eigen::Vector2d within((sample + 0.5) / samples, reversed_bits(sample) + 0.5 / samples);
    sum += at(Eigen::Vector2d(pixel + within.unaryExpr(&blurred_share)));
  }
  return sum / samples;
}

/// Brightness within a label and the white around it, -1 outside.
/// @param tag  side of its black square (m)
/// @param place  from its middle
inline double label_brightness(const PrintedBoard& label, double tag,
                               const Eigen::Vector2d& place) {
  const double around = tag / 2 + tag / kTagCells;
  if (place.cwiseAbs().maxCoeff() > around) return -1;
  return label.at(place + Eigen::Vector2d::Constant(tag / 2));
}

/// A label as it was printed, with its white around it.
inline PrintedBoard printed_label(int code, double tag) {
  return PrintedBoard({1, 1, tag, tag / kTagCells, code});
}

/// A flat strip between two jaws with the labels 0 and 1, as a pinhole camera sees it: 30 mm x 90
/// mm, labels of 15 mm whose middles are 15 mm outside of its ends. Plane coordinates are those of
/// the sample.
struct LabelledPull {
  static constexpr double kWidth = 0.030, kHeight = 0.090, kTag = 0.015, kEdge = 0.015;
  static constexpr int kColumns = 360, kRows = 1040;
  static constexpr double kFocal = 5000 / 1.5;  ///< pixels

  double strain = 0;      ///< of the cloth, along warp; across it narrows by a share of it
  double slip = 0;        ///< by which it has left the upper jaw (m)
  double nearer = 0;      ///< of the upper jaw to the camera (m)
  double turned = 0;      ///< of the camera, about its axis (rad)
  double tilted = 0;      ///< of the camera, about its rows (rad)
  double jaw_turned = 0;  ///< of the upper jaw in the plane (rad)
  bool hidden = false;    ///< whether something is in front of the lower label
  double k1 = 0;          ///< radial distortion of the lens
  double narrows = 0.1;   ///< that share
  double rolled = 0;      ///< strain that is added from the first row that is read to the last one

  /// Where the upper end of the cloth would be without slip (m).
  double jaw() const { return kHeight * (1 + strain) + slip; }
  double narrowing() const { return -narrows * strain; }

  /// From the plane to pixels: a camera 500 mm away, 0.15 mm a pixel.
  Eigen::Matrix3d to_picture() const {
    constexpr double kDistance = 0.5;
    const double slope = std::asin(nearer / (jaw() + 2 * kEdge));
    const Eigen::Matrix3d sheet =
        Eigen::AngleAxisd(slope, Eigen::Vector3d::UnitX()).toRotationMatrix();
    Eigen::Matrix3d camera;  // columns, rows downwards, away
    camera = Eigen::AngleAxisd(tilted, Eigen::Vector3d::UnitX()) *
             Eigen::AngleAxisd(turned, Eigen::Vector3d::UnitZ()) *
             Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
    const Eigen::Vector3d seen(kWidth / 2, kHeight / 2, 0), foot(0, -kEdge, 0);
    Eigen::Matrix3d plane;  // columns: u, v, origin in the camera's axes
    plane.col(0) = camera * sheet.col(0);
    plane.col(1) = camera * sheet.col(1);
    plane.col(2) = camera * (foot - sheet * foot - seen) + kDistance * Eigen::Vector3d::UnitZ();
    Eigen::Matrix3d k;
    k << kFocal, 0, kColumns / 2.0, 0, kFocal, kRows / 2.0, 0, 0, 1;
    return k * plane;
  }

  CameraModel camera() const {
    CameraModel model;
    model.intrinsics << kFocal, kFocal, kColumns / 2.0, kRows / 2.0, k1, 0, 0, 0, 0;
    model.columns = kColumns;
    model.rows = kRows;
    return model;
  }

  /// Brightness of a place of the plane (0 to 1).
  double at(const Eigen::Vector2d& place, const Texture& texture) const {
    static const PrintedBoard lower = printed_label(0, kTag), upper = printed_label(1, kTag);
    const Eigen::Vector2d middle(kWidth / 2, 0);
    const Eigen::Rotation2Dd back(-jaw_turned);
    const Eigen::Vector2d on_jaw = back * (place - middle - Eigen::Vector2d(0, jaw()));
    // The lower label stands on its head: its edge is towards the cloth.
    const double label =
        std::max(label_brightness(lower, kTag, -(place - middle + Eigen::Vector2d(0, kEdge))),
                 label_brightness(upper, kTag, on_jaw - Eigen::Vector2d(0, kEdge)));
    if (hidden && place.y() < 0) return 0.5;
    if (label >= 0) return label;
    const Eigen::Vector2d rest((place.x() - kWidth / 2) / (1 + narrowing()) + kWidth / 2,
                               place.y() / (1 + strain));
    if (rest.x() < 0 || rest.x() > kWidth || rest.y() < -0.002 || rest.y() > kHeight + 0.002) {
      return 0.9;
    }
    return texture.at(rest / 1.5e-4) / 255;
  }

  GreyPicture picture(std::uint64_t seed) const {
    const Texture texture(5);
    const Lens lens(camera());
    GreyPicture picture(kRows, kColumns);
    for (int row = 0; row < kRows; ++row) {
      LabelledPull now = *this;
      now.strain += rolled * row / kRows;
      const Eigen::Matrix3d to_plane = now.to_picture().inverse();
      for (int column = 0; column < kColumns; ++column) {
        const Eigen::Vector2d pixel = lens.straightened(Eigen::Vector2d(column, row));
        // The edges of a label are where its corners are found: finer there, and cloth is smooth.
        const double v = (to_plane * pixel.homogeneous()).hnormalized().y();
        const int samples = v < 0 || v > now.jaw() ? 64 : 4;
        const double light = seen_by_pixel(pixel, samples, [&](const Eigen::Vector2d& place) {
          return now.at((to_plane * place.homogeneous()).hnormalized(), texture);
        });
        picture(row, column) = static_cast<float>(0.1 + 0.8 * light);
      }
    }
    RandomStream random(seed);
    add_noise(picture, 0.01, random);
    return picture;
  }
};

}  // namespace pliant::test
