#include "pliant/geometry/world_positions.h"

#include <array>
#include <string_view>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

/// Rows of a rotation from the file's axes to the world's.
Eigen::Matrix3d world_axes(const std::string& up, const std::string& file) {
  struct Axes {
    std::string_view up;
    std::array<int, 9> rows;
  };
  constexpr std::array<Axes, 6> kAxes{{{"z", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
                                       {"-z", {1, 0, 0, 0, -1, 0, 0, 0, -1}},
                                       {"y", {1, 0, 0, 0, 0, -1, 0, 1, 0}},
                                       {"-y", {1, 0, 0, 0, 0, 1, 0, -1, 0}},
                                       {"x", {0, 0, -1, 0, 1, 0, 1, 0, 0}},
                                       {"-x", {0, 0, 1, 0, 1, 0, -1, 0, 0}}}};
  for (const Axes& axes : kAxes) {
    if (axes.up != up) continue;
    return Eigen::Map<const Eigen::Matrix<int, 3, 3, Eigen::RowMajor>>(axes.rows.data())
        .cast<double>();
  }
  throw InputError({file, 0, "up"}, "unknown axis " + quoted_value(up), "x, -x, y, -y, z or -z");
}

}  // namespace

Eigen::Matrix3Xd world_positions(const PolygonMesh& polygons, double unit, const std::string& up) {
  return world_positions(polygons.positions, unit, up, polygons.numbering.file);
}

Eigen::Matrix3Xd world_positions(const Eigen::Matrix3Xd& positions, double unit,
                                 const std::string& up, const std::string& file) {
  Eigen::Matrix3Xd world = world_axes(up, file) * (unit * positions);
  if (!world.allFinite()) {
    throw InputError({file, 0, "unit"}, "positions overflow", "a smaller unit");
  }
  return world;
}

}  // namespace pliant
