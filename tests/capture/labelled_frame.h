#pragma once

#include <algorithm>
#include <array>

#include "capture/labelled_camera.h"

namespace pliant::test {

/// A square sheet in a picture frame of four bars, on which the labels 0 to 3 are (bottom, top,
/// left, right), seen from straight in front. Yarns keep their length.
struct LabelledFrame {
  static constexpr double kSide = 0.060, kTag = 0.012, kEdge = 0.012;
  static constexpr double kPixel = 0.15e-3;
  static constexpr int kPixels = 720;

  double angle = 0;  ///< by which weft and warp have left the right angle (rad)

  GreyPicture picture(std::uint64_t seed) const {
    const Texture texture(6);
    const std::array<Bar, 4> bars = this->bars();
    const Eigen::Matrix2d to_rest = motion().inverse();
    constexpr double kMiddle = (kPixels - 1) / 2.0, kBelowBars = 1e-3;
    const auto place_of = [&](const Eigen::Vector2d& pixel) {
      return Eigen::Vector2d(kPixel * (pixel.x() - kMiddle), kPixel * (kMiddle - pixel.y()));
    };
    const auto light_at = [&](const Eigen::Vector2d& pixel) {
      const Eigen::Vector2d place = place_of(pixel);
      const double label = label_at(bars, place);
      if (label >= 0) return label;
      const Eigen::Vector2d rest = to_rest * place;
      if (rest.cwiseAbs().maxCoeff() > kSide / 2 + kBelowBars) return 0.9;
      return texture.at(rest / kPixel) / 255;
    };
    GreyPicture picture(kPixels, kPixels);
    for (int row = 0; row < kPixels; ++row) {
      for (int column = 0; column < kPixels; ++column) {
        const Eigen::Vector2d pixel(column, row);
        const int samples = label_at(bars, place_of(pixel)) >= 0 ? 64 : 4;
        const double light = seen_by_pixel(pixel, samples, light_at);
        picture(row, column) = static_cast<float>(0.1 + 0.8 * light);
      }
    }
    RandomStream random(seed);
    add_noise(picture, 0.01, random);
    return picture;
  }

 private:
  /// Where its label is, from the middle of the frame (m).
  struct Bar {
    Eigen::Vector2d middle, along, outward;
  };

  /// Takes a place of the sheet at rest, from its middle, to where it is now.
  Eigen::Matrix2d motion() const {
    const double c = std::cos(angle / 2), s = std::sin(angle / 2);
    return (Eigen::Matrix2d() << c, s, s, c).finished();
  }

  // They lie along yarns, and labels point outwards at right angles to them.
  std::array<Bar, 4> bars() const {
    const std::array<Eigen::Vector2d, 4> sides{Eigen::Vector2d(0, -1), Eigen::Vector2d(0, 1),
                                               Eigen::Vector2d(-1, 0), Eigen::Vector2d(1, 0)};
    std::array<Bar, 4> bars;
    for (std::size_t b = 0; b < bars.size(); ++b) {
      const double turned = b < 2 ? angle / 2 : -angle / 2;
      bars[b].outward = Eigen::Rotation2Dd(turned) * sides[b];
      bars[b].along = {bars[b].outward.y(), -bars[b].outward.x()};
      bars[b].middle = motion() * sides[b] * kSide / 2 + kEdge * bars[b].outward;
    }
    return bars;
  }

  /// As of `label_brightness`, of any.
  static double label_at(const std::array<Bar, 4>& bars, const Eigen::Vector2d& place) {
    static const std::array labels{printed_label(0, kTag), printed_label(1, kTag),
                                   printed_label(2, kTag), printed_label(3, kTag)};
    double light = -1;
    for (std::size_t b = 0; b < bars.size(); ++b) {
      const Eigen::Vector2d off = place - bars[b].middle;
      light = std::max(light, label_brightness(labels[b], kTag,
                                               {bars[b].along.dot(off), bars[b].outward.dot(off)}));
    }
    return light;
  }
};

}  // namespace pliant::test
