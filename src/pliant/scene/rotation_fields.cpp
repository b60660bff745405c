#include "pliant/scene/rotation_fields.h"

#include <vector>

#include <fmt/format.h>

#include "pliant/io/vector_fields.h"

namespace pliant {
namespace {

// Shorter ones are a slip: their direction is rounding.
constexpr double kLeastNorm = 1e-9;

Eigen::Vector3d read_axis(const Value& value) {
  const Eigen::Vector3d axis = read_vector(value);
  if (axis.norm() < kLeastNorm) value.fail("has no direction", "an axis of some length");
  return axis.normalized();
}

Rotation read_quaternion(const Value& value) {
  const std::vector<double> numbers = value.numbers();
  if (numbers.size() != 4) {
    value.fail(fmt::format("has {} numbers", numbers.size()), "a quaternion [w, x, y, z]");
  }
  const Eigen::Quaterniond quaternion(numbers[0], numbers[1], numbers[2], numbers[3]);
  if (quaternion.norm() < kLeastNorm) value.fail("is no rotation", "a quaternion of some length");
  const Eigen::AngleAxisd rotation(quaternion.normalized());
  return {rotation.axis(), rotation.angle(), false};
}

}  // namespace

Rotation read_rotation(const Value& value) {
  Fields fields = value.fields();
  Rotation rotation;
  if (const auto quaternion = fields.optional("quaternion")) {
    rotation = read_quaternion(*quaternion);
  } else {
    rotation.axis = read_axis(fields.require("axis"));
    rotation.angle = fields.require("angle").quantity(Dimension::angle);
  }
  fields.finish();
  return rotation;
}

}  // namespace pliant
