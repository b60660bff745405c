#pragma once

#include "pliant/experiment/moved_body/moved_body_type.h"
#include "pliant/experiment/press/press_type.h"
#include "pliant/geometry/block_mesh.h"

namespace pliant::test {

/// A block of 40 x 20 x 20 mm that is held at -x; its other end is pulled by a tenth and pushed
/// aside.
inline VirtualMovedBody moved_block(std::array<int, 3> cells = {6, 3, 3}) {
  VirtualMovedBody test;
  test.name = "block";
  test.setup.mesh = block_of_hexahedra({0.04, 0.02, 0.02}, cells);
  test.setup.held = nodes_at(test.setup.mesh, 0, 0);
  test.setup.moved = nodes_at(test.setup.mesh, 0, 0.04);
  test.fixed = "-x";
  test.moved = "+x";
  test.shifts = {{0.004, 0, 0}, {0, 0.004, 0}};
  test.marks = 20;
  return test;
}

/// A block of 20 x 20 x 10 mm that is held below and pressed by a sphere.
inline VirtualPress pressed_block(const TestType& kind, std::array<int, 3> cells, int samples) {
  VirtualPress test;
  test.name = std::string(kind.name);
  test.kind = &kind;
  test.setup.mesh = block_of_hexahedra({0.02, 0.02, 0.01}, cells);
  test.setup.held = nodes_at(test.setup.mesh, 2, 0);
  test.setup.radius = 8e-3;
  test.setup.through = {0.01, 0.01, 0};
  test.fixed = "-z";
  test.depths = {1.5e-3};
  test.samples = samples;
  return test;
}

}  // namespace pliant::test
