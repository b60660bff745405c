#include "pliant/capture/sample_placement.h"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "pliant/base/quantity.h"

namespace pliant {

std::optional<SamplePlacement> place_sample(const Eigen::Matrix3Xd& points,
                                            const Quadrilateral& corners, const CameraModel& camera,
                                            const Eigen::Vector2d& size) {
  const Eigen::Vector3d middle = points.rowwise().mean();
  const Eigen::Matrix3Xd centred = points.colwise() - middle;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(centred * centred.transpose());
  const Eigen::Vector3d normal = spread.eigenvectors().col(0);
  Eigen::Matrix<double, 3, 4> seen;
  for (Eigen::Index k = 0; k < 4; ++k) {
    const auto ray = camera.ray(corners.col(k));
    if (!ray) return std::nullopt;
    const double way = normal.dot(middle - ray->from) / normal.dot(ray->direction);
    if (!(way > 0)) return std::nullopt;
    seen.col(k) = ray->from + way * ray->direction;
  }
  const auto side = [&](int from, int to) { return (seen.col(to) - seen.col(from)).norm(); };
  SamplePlacement placement;
  placement.sides << (side(0, 1) + side(3, 2)) / 2, (side(0, 3) + side(1, 2)) / 2;
  Eigen::Matrix<double, 3, 4> own;
  own << 0, size.x(), size.x(), 0, 0, 0, size.y(), size.y(), 0, 0, 0, 0;
  placement.to_sample = Eigen::Isometry3d(Eigen::umeyama(seen, own, /*with_scaling=*/false));
  return placement;
}

std::string size_doubt(double seen, double stated, const char* which) {
  constexpr double kMost = 0.015;
  if (std::abs(seen / stated - 1) < kMost) return {};
  return fmt::format(
      "the sample is {} {} by the pictures, {:.1f} % {} than the {} that it is said to: is the "
      "size of the board, of the labels or of the sample wrong, or was a camera refocused?",
      format_quantity(seen, Dimension::length, 4), which, 100 * std::abs(seen / stated - 1),
      seen > stated ? "more" : "less", format_quantity(stated, Dimension::length, 4));
}

}  // namespace pliant
