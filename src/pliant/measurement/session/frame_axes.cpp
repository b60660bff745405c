#include "pliant/measurement/session/frame_axes.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace pliant {
namespace {

/// Few mirrored axes first: of points in a plane several axes may tell the same.
constexpr std::array<std::array<int, 3>, 8> kSigns{{{1, 1, 1},
                                                    {-1, 1, 1},
                                                    {1, -1, 1},
                                                    {1, 1, -1},
                                                    {-1, -1, 1},
                                                    {-1, 1, -1},
                                                    {1, -1, -1},
                                                    {-1, -1, -1}}};

}  // namespace

std::string explaining_axes(const Eigen::Matrix3Xd& found, const Eigen::Matrix3Xd& expected,
                            double most) {
  const auto fits = [&](const Eigen::Matrix3d& axes) {
    return (axes * found - expected).colwise().norm().maxCoeff() <= most;
  };
  for (const std::array<int, 3>& sign : kSigns) {
    std::array<int, 3> axis{0, 1, 2};
    do {
      Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
      for (int row = 0; row < 3; ++row) {
        const auto r = static_cast<std::size_t>(row);
        axes(row, axis[r]) = sign[r];
      }
      if (!fits(axes)) continue;
      const auto name = [&](std::size_t row) {
        return fmt::format("{}{}", sign[row] < 0 ? "-" : "",
                           "xyz"[static_cast<std::size_t>(axis[row])]);
      };
      return fmt::format(" (it would fit with {}, {}, {} of the frame as x, y, z)", name(0),
                         name(1), name(2));
    } while (std::ranges::next_permutation(axis).found);
  }
  return "";
}

}  // namespace pliant
