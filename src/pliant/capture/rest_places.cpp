#include "pliant/capture/rest_places.h"

#include "pliant/capture/unrolled_sheet.h"

namespace pliant {

RestPlaces::RestPlaces(const SampleAxes& axes, const Eigen::Matrix3Xd& first,
                       const Eigen::Vector2d& size, double spacing)
    : axes_(axes), spacing_(spacing) {
  constexpr double kFlat = 2e-3;  // of the size: distances are short by less than 0.01 %
  constexpr double kReach = 2.3;  // spacings
  if (axes.off_plane <= kFlat * size.minCoeff()) return;
  const Eigen::Matrix3Xd points = axes.of(first);
  const UnrolledSheet flat = unrolled(points, kReach * spacing);
  Eigen::Matrix3Xd laid = Eigen::Matrix3Xd::Zero(3, points.cols());
  laid.topRows<2>() = flat.places;
  unrolling_.emplace(points.topRows<2>(), laid, kReach * spacing);
  unrolling_->bend(0);
  stretch_ = flat.stretch;
}

Eigen::Matrix2Xd RestPlaces::of(const Eigen::Matrix3Xd& rest) const {
  Eigen::Matrix2Xd places = axes_.of(rest).topRows<2>();
  if (!unrolling_) return places;
  for (auto place : places.colwise()) {
    const auto laid = unrolling_->at(place, spacing_);
    if (laid) place = laid->position.head<2>();
  }
  return places;
}

}  // namespace pliant
