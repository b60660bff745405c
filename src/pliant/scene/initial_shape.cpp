#include "pliant/scene/initial_shape.h"

#include <cmath>
#include <numbers>

namespace pliant {
namespace {

// A mesh file's coordinates are rounded; a cloth is flat within this part of its extent.
constexpr double kFlat = 1e-5;

Eigen::Vector3d axis_direction(CylinderAxis axis) {
  if (axis == CylinderAxis::u) return Eigen::Vector3d::UnitX();
  if (axis == CylinderAxis::v) return Eigen::Vector3d::UnitY();
  return Eigen::Vector3d(1, 1, 0) / std::numbers::sqrt2;
}

Eigen::Vector3d across_direction(CylinderAxis axis) {
  if (axis == CylinderAxis::u) return Eigen::Vector3d::UnitY();
  if (axis == CylinderAxis::v) return Eigen::Vector3d::UnitX();
  return Eigen::Vector3d(1, -1, 0) / std::numbers::sqrt2;
}

/// Of the radius of curvature (m), by the angle.
double growth_of_radius(const RolledShape& shape) { return shape.pitch / (2 * std::numbers::pi); }

/// Of curvature (m^2), at a length along the cloth from the line that stays; not above zero where
/// there is no spiral.
double squared_radius_at(const RolledShape& shape, double length) {
  return shape.radius * shape.radius + 2 * growth_of_radius(shape) * length;
}

}  // namespace

Eigen::Matrix3Xd rolled(const RolledShape& shape, const Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d axis = axis_direction(shape.axis), across = across_direction(shape.axis);
  const Eigen::Vector3d normal = (shape.towards_back ? -1 : 1) * Eigen::Vector3d::UnitZ();
  const double growth = growth_of_radius(shape);
  Eigen::Matrix3Xd result(3, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d point = points.col(i);
    const double length = point.dot(across), height = point.dot(normal);
    // Of the tangent: its integral over the radius r + growth * angle is the length.
    const double angle = 2 * length / (shape.radius + std::sqrt(squared_radius_at(shape, length)));
    const double sine = std::sin(angle), cosine = std::cos(angle);
    // 1 - cos(angle), without cancellation at small angles.
    const double versine = 2 * std::pow(std::sin(angle / 2), 2);
    const double along = shape.radius * sine + growth * (angle * sine - versine);
    const double rise = shape.radius * versine + growth * (sine - angle * cosine);
    result.col(i) = point.dot(axis) * axis + (along - height * sine) * across +
                    (rise + height * cosine) * normal;
  }
  return result;
}

void require_rollable(const RolledShape& shape, const Eigen::Matrix3Xd& points) {
  if (points.cols() == 0) return;
  const double extent = points.topRows<2>().cwiseAbs().maxCoeff();
  if (points.row(2).cwiseAbs().maxCoeff() > kFlat * extent) {
    throw InputError(shape.where, "the mesh is not flat", "a mesh in the plane z = 0 to be rolled");
  }
  const double innermost = (across_direction(shape.axis).transpose() * points).minCoeff();
  if (squared_radius_at(shape, innermost) > 0) return;
  throw InputError(shape.where, "the cloth reaches further inwards than its spiral",
                   "a larger radius, a smaller pitch, or a cloth that begins at (0, 0)");
}

}  // namespace pliant
