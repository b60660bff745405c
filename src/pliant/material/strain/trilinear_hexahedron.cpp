#include "pliant/material/strain/trilinear_hexahedron.h"

#include "pliant/base/assert.h"
#include "pliant/geometry/hexahedron_shape.h"

namespace pliant {

std::array<HexahedronPoint, 8> hexahedron_points(
    const TrilinearHexahedron::Positions& rest_positions) {
  std::array<HexahedronPoint, 8> points;
  for (size_t p = 0; p < points.size(); ++p) {
    const auto& gradients = hexahedron_gradients()[p];
    const Eigen::Matrix3d map = rest_positions * gradients;
    points[p].size = map.determinant();
    PLIANT_ASSERT(points[p].size > 0,
                  "a hexahedron has a volume at rest around each of its points");
    points[p].rest.weights = gradients * map.inverse();
  }
  return points;
}

}  // namespace pliant
