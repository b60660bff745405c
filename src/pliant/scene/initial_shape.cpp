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

}  // namespace

Eigen::Matrix3Xd rolled(const RolledShape& shape, const Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d axis = axis_direction(shape.axis), across = across_direction(shape.axis);
  const Eigen::Vector3d normal = (shape.towards_back ? -1 : 1) * Eigen::Vector3d::UnitZ();
  Eigen::Matrix3Xd result(3, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d point = points.col(i);
    const double angle = point.dot(across) / shape.radius, height = point.dot(normal);
    // 1 - cos(angle), without cancellation at small angles.
    const double rise = shape.radius * 2 * std::pow(std::sin(angle / 2), 2);
    result.col(i) = point.dot(axis) * axis + (shape.radius - height) * std::sin(angle) * across +
                    (rise + height * std::cos(angle)) * normal;
  }
  return result;
}

void require_flat(const RolledShape& shape, const Eigen::Matrix3Xd& points) {
  if (points.cols() == 0) return;
  const double extent = points.topRows<2>().cwiseAbs().maxCoeff();
  if (points.row(2).cwiseAbs().maxCoeff() <= kFlat * extent) return;
  throw InputError(shape.where, "the mesh is not flat", "a mesh in the plane z = 0 to be rolled");
}

}  // namespace pliant
