#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>

#include "io/temporary_folder.h"

namespace pliant::test {

/// Where a place of a sample at rest (m) is in a frame (m).
using Motion = std::function<Eigen::Vector3d(int frame, const Eigen::Vector2d& place)>;

/// A sample of 40 mm x 80 mm that a camera sees whose rows count downwards, 0.05 mm a pixel, its
/// lower left corner at the pixel (100, 1900): points 2 mm apart, 2 mm off all edges.
class PointTables {
 public:
  static constexpr double kWidth = 0.04, kHeight = 0.08, kPixel = 0.05e-3, kSpacing = 2e-3;

  static std::vector<Eigen::Vector2d> places() {
    std::vector<Eigen::Vector2d> places;
    for (int j = 1; j < 40; ++j) {
      for (int i = 1; i < 20; ++i) places.emplace_back(i * kSpacing, j * kSpacing);
    }
    return places;
  }

  static Eigen::Vector2d pixel(const Eigen::Vector2d& place) {
    return {100 + place.x() / kPixel, 1900 - place.y() / kPixel};
  }

  /// Writes points/FRAME.csv with columns x, y, u, v in pixels.
  /// @param row  what else is done to a row; empty: nothing
  static void write(const TemporaryFolder& folder, int frames, const Motion& motion,
                    const std::function<std::string(int frame, std::size_t point,
                                                    const std::string& row)>& row = {}) {
    const auto all = places();
    for (int f = 0; f < frames; ++f) {
      std::string text = "x,y,u,v\n";
      for (std::size_t p = 0; p < all.size(); ++p) {
        const Eigen::Vector2d at = pixel(all[p]);
        const Eigen::Vector2d by = pixel(motion(f, all[p]).head<2>()) - at;
        const std::string line = fmt::format("{},{},{},{}", at.x(), at.y(), by.x(), by.y());
        text += (row ? row(f, p, line) : line) + "\n";
      }
      folder.write(fmt::format("points/{:03}.csv", f), text);
    }
  }

  /// A dic/1 file of these tables; `more` are further lines.
  static std::filesystem::path describe(const TemporaryFolder& folder, const std::string& more) {
    return folder.write("pull.yaml",
                        "pliant: dic/1\n"
                        "test: stretch-warp\n"
                        "sample: {width: 40 mm, height: 80 mm, density: 150 g/m^2}\n"
                        "points: points/*.csv\n"
                        "scale: 0.05 mm\n"
                        "origin: [100, 1900]\n"
                        "warp: -y\n" +
                            more);
  }

  /// Two jaws, the upper one driven and pulled by what log.csv says.
  static constexpr const char* kJaws =
      "clips:\n"
      "  - {name: lower, side: bottom, motion: held}\n"
      "  - {name: upper, side: top, motion: extension}\n"
      "forces: {data: log.csv, on: upper}\n";
};

}  // namespace pliant::test
