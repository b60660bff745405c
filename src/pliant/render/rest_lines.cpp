#include "pliant/render/rest_lines.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "pliant/base/assert.h"
#include "pliant/render/number_scale.h"

namespace pliant {
namespace {

constexpr double kUsualLines = 12;  // each way, at most
// Shares of the spacing.
constexpr float kHalfWidth = 0.012F;
constexpr float kDash = 0.25F, kInk = 0.6F;  // from one dash to the next, and how much of it is one
constexpr float kDensest = 0.25F;

/// The slopes of linear functions over a triangle.
/// @param changes  of the functions from corner 0 to 1 and to 2, a row a function
Eigen::Vector2f slopes_over(const Eigen::Matrix3f& corners, const Eigen::Matrix2f& changes) {
  Eigen::Matrix<float, 3, 2> sides;
  sides << corners.col(1) - corners.col(0), corners.col(2) - corners.col(0);
  const Eigen::Matrix2f metric = sides.transpose() * sides;
  return (changes * metric.inverse() * changes.transpose()).diagonal().cwiseSqrt();
}

}  // namespace

double usual_spacing(double rest_area) { return round_step(std::sqrt(rest_area) / kUsualLines); }

RestLinePattern::RestLinePattern(const RestLines& lines, const Eigen::Matrix3Xf& positions,
                                 const Eigen::Matrix3Xi& triangles)
    : slopes_(2, triangles.cols()) {
  PLIANT_ASSERT(lines.rest_corners.cols() == triangles.size(), "a triangle has three rest corners");
  // Whole spacings that all share are left out, so that single precision does.
  const Eigen::Matrix2Xd corners = lines.rest_corners / lines.spacing;
  const Eigen::Vector2d origin = corners.rowwise().minCoeff().array().floor();
  corners_ = (corners.colwise() - origin).cast<float>();
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    Eigen::Matrix2f changes;
    changes << corners_.col(3 * t + 1) - corners_.col(3 * t),
        corners_.col(3 * t + 2) - corners_.col(3 * t);
    slopes_.col(t) = slopes_over(positions(Eigen::all, triangles.col(t)), changes);
  }
}

bool RestLinePattern::covers(const RayHit& hit, float half_width) const {
  const Eigen::Vector2f at = corners_.middleCols<3>(3 * hit.triangle) * hit.barycentric;
  const auto on_line = [&](int axis) {
    const float half = std::max(kHalfWidth, half_width * slopes_(axis, hit.triangle));
    return half < kDensest && std::abs(at[axis] - std::round(at[axis])) < half;
  };
  if (on_line(0)) return true;
  const float dash = at[0] / kDash;
  return std::abs(dash - std::round(dash)) < kInk / 2 && on_line(1);
}

}  // namespace pliant
