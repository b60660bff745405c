#include "pliant/capture/cloth_print.h"

#include <cstdint>
#include <vector>

#include "pliant/capture/wavelet_noise.h"

namespace pliant {
namespace {

GreyPicture brightness_of(const std::vector<std::uint8_t>& levels, int columns, int rows) {
  constexpr float kWhite = 255;
  const Eigen::Map<
      const Eigen::Array<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>
      grey(levels.data(), rows, columns);
  return grey.cast<float>() / kWhite;
}

}  // namespace

ClothPrint::ClothPrint(const ClothPattern& pattern, int columns, int rows, double pixel)
    : pixel_(pixel),
      picture_(brightness_of(noise_levels(pattern, columns, rows, pixel), columns, rows)) {}

double ClothPrint::at(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d last(static_cast<double>(picture_.columns() - 1),
                             static_cast<double>(picture_.rows() - 1));
  const Eigen::Vector2d there = place / pixel_;
  return picture_.value(there.cwiseMax(0).cwiseMin(last));
}

}  // namespace pliant
