#pragma once

#include <optional>
#include <string>

#include "pliant/capture/near_places.h"
#include "pliant/capture/sample_axes.h"

namespace pliant {

/// Where points are on the sample laid flat, by where they are at rest: in its plane, or unrolled
/// where it does not lie flat.
class RestPlaces {
 public:
  /// @param first    points of the first frame, 3 x points
  /// @param spacing  of them (m)
  RestPlaces(const SampleAxes& axes, const Eigen::Matrix3Xd& first, const Eigen::Vector2d& size,
             double spacing);

  /// @param rest  3 x points at rest, some of those of the first frame (m)
  Eigen::Matrix2Xd of(const Eigen::Matrix3Xd& rest) const;
  /// By how much it had to be stretched, as of UnrolledSheet; nothing where it lies flat.
  std::optional<double> stretch() const { return stretch_; }
  /// @param file  of the points
  /// @throws InputError where they are not those of a sheet at all
  void require_sheet(const std::string& file) const;

 private:
  SampleAxes axes_;
  std::optional<double> stretch_;
  Eigen::Matrix2Xd shown_, laid_;   // points of the first frame in the plane, and unrolled
  std::optional<NearPlaces> near_;  // of those in the plane
};

}  // namespace pliant
