#include "pliant/capture/rest_places.h"

#include <utility>

#include "pliant/base/errors.h"
#include "pliant/capture/unrolled_sheet.h"

namespace pliant {

RestPlaces::RestPlaces(const SampleAxes& axes, const Eigen::Matrix3Xd& first,
                       const Eigen::Vector2d& size, double spacing)
    : axes_(axes) {
  constexpr double kFlat = 2e-3;  // of the size: an arch is seen short by 0.01 % then
  constexpr double kReach = 2.3;  // spacings
  if (axes.off_plane <= kFlat * size.minCoeff()) return;
  const Eigen::Matrix3Xd points = axes.of(first);
  UnrolledSheet flat = unrolled(points, kReach * spacing);
  stretch_ = flat.stretch;
  shown_ = points.topRows<2>();
  laid_ = std::move(flat.places);
  near_.emplace(shown_, kReach * spacing);
}

void RestPlaces::require_sheet(const std::string& file) const {
  constexpr double kMost = 0.2;
  if (!stretch_ || *stretch_ < kMost) return;
  throw InputError({file}, "shows points that are not those of a sheet: it cannot be laid flat",
                   "a sample with an irregular pattern, without folds in the first frame");
}

Eigen::Matrix2Xd RestPlaces::of(const Eigen::Matrix3Xd& rest) const {
  Eigen::Matrix2Xd places = axes_.of(rest).topRows<2>();
  if (!near_) return places;
  for (auto place : places.colwise()) {
    const auto same = near_->nearest(place);
    if (same) place += laid_.col(*same) - shown_.col(*same);
  }
  return places;
}

}  // namespace pliant
