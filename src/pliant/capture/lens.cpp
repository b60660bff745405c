#include "pliant/capture/lens.h"

#include <fmt/format.h>

#include "pliant/base/errors.h"

namespace pliant {

Eigen::Matrix2Xd Lens::straightened(const Eigen::Matrix2Xd& seen) const {
  if (!camera_) return seen;
  const Intrinsics& own = camera_->intrinsics;
  Eigen::Matrix2Xd straight(2, seen.cols());
  for (Eigen::Index i = 0; i < seen.cols(); ++i) {
    const auto direction = camera_->straight(seen.col(i));
    if (!direction) {
      throw InputError({},
                       fmt::format("the calibration of the camera knows no direction of the pixel "
                                   "({:.0f}, {:.0f})",
                                   seen(0, i), seen(1, i)),
                       "boards that reach the corners of the picture in its calibration");
    }
    straight.col(i) = direction->cwiseProduct(own.head<2>()) + own.segment<2>(2);
  }
  return straight;
}

Eigen::Matrix2Xd Lens::seen(const Eigen::Matrix2Xd& straight) const {
  if (!camera_) return straight;
  const Intrinsics& own = camera_->intrinsics;
  Eigen::Matrix2Xd pixels(2, straight.cols());
  for (Eigen::Index i = 0; i < straight.cols(); ++i) {
    const Eigen::Vector2d direction =
        (straight.col(i) - own.segment<2>(2)).cwiseQuotient(own.head<2>());
    pixels.col(i) = pixel_of(own.data(), Eigen::Vector3d(direction.homogeneous()));
  }
  return pixels;
}

}  // namespace pliant
