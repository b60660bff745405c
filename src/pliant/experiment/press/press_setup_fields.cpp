#include "pliant/experiment/press/press_setup_fields.h"

#include "pliant/experiment/body_fields.h"
#include "pliant/io/vector_fields.h"

namespace pliant {
namespace {

Eigen::Vector3d read_direction(const Value& value) {
  if (value.is_scalar()) {
    const auto axis = side_named(value.text());
    if (!axis) value.fail(quoted_value(value.text()), "-x, +x, -y, +y, -z, +z or [x, y, z]");
    return *axis;
  }
  const Eigen::Vector3d direction = read_vector(value);
  if (direction.norm() == 0) value.fail("has no length", "a direction, e.g. [0, 0, -1]");
  return direction.normalized();
}

void require_movable(const Value& fixed, const PressSetup& setup) {
  if (nodes_to_touch(setup).empty()) {
    fixed.fail("holds the whole surface of the body", "a part of it");
  }
}

}  // namespace

void read_press_setup(Fields& fields, PressSetup& setup, std::string& fixed) {
  const Value held = fields.require("fixed");
  fixed = held.text();
  setup.held = read_body_nodes(held, setup.mesh);
  require_movable(held, setup);
  const Value direction = fields.require("direction");
  setup.direction = read_direction(direction);
  const auto radius = fields.optional("radius"), through = fields.optional("through");
  if (radius) setup.radius = radius->positive_quantity(Dimension::length);
  if (through) {
    if (!radius) through->fail("is of a sphere", "`radius` beside it, or a plane without it");
    setup.through = read_vector(*through);
  }
  if (first_touch(setup)) return;
  (through ? *through : direction)
      .fail("leads the sphere past the body", "a line that meets it, through `through`");
}

}  // namespace pliant
