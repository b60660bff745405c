#include "pliant/experiment/session/virtual/cut_sheet.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "pliant/experiment/session/virtual/test_clips.h"
#include "pliant/geometry/irregular_mesh.h"
#include "pliant/geometry/regular_grid.h"

namespace pliant {
namespace {

int nodes_along(double side, double edge) {
  return std::max(2, static_cast<int>(std::lround(side / edge)) + 1);
}

TriangleMesh rectangle(const VirtualSession& options) {
  if (options.nodes) {
    return regular_grid(options.width, options.height, options.nodes->first, options.nodes->second);
  }
  if (has_irregular_meshes()) {
    std::vector<Eigen::AlignedBox2d> held;
    for (const TestClip& clip : test_clips(options)) held.push_back(clip.holds);
    return irregular_rectangle(options.width, options.height, options.edge, held);
  }
  return regular_grid(options.width, options.height, nodes_along(options.width, options.edge),
                      nodes_along(options.height, options.edge));
}

}  // namespace

CutSheet cut_sheet(const VirtualSession& options) {
  TriangleMesh mesh = rectangle(options);
  CutSheet sheet;
  sheet.places = mesh.positions.topRows<2>();
  if (options.test != "bias-extension") {
    sheet.rest = std::move(mesh);
    return sheet;
  }
  // The strip's length halves the angle between weft and warp.
  sheet.placed.rotation = Eigen::AngleAxisd(-std::numbers::pi / 4, Eigen::Vector3d::UnitZ());
  sheet.placed.translation.y() = options.width / std::numbers::sqrt2;
  const Eigen::Matrix2Xd turned =
      (sheet.placed.rotation.toRotationMatrix().topLeftCorner<2, 2>() * sheet.places).colwise() +
      sheet.placed.translation.head<2>();
  sheet.rest = flat_mesh(turned, mesh.triangles);
  return sheet;
}

}  // namespace pliant
