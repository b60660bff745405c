#include "pliant/geometry/fingertip.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "pliant/geometry/volume_mesher.h"

namespace pliant {
namespace {

constexpr int kTissue = 1, kBone = 2, kSkin = 3;

/// Where a place is in an elliptic cylinder along x that ends in half an ellipsoid: 0 on its axis,
/// 1 on its surface.
struct CappedCylinder {
  double cylinder = 0;  ///< length of the part that is no cap (m)
  double cap = 0;       ///< length of the cap (m)
  double half_width = 0, half_height = 0;
  double lift = 0;  ///< of its axis (m)

  double depth_at(const Eigen::Vector3d& place) const {
    const double x = std::max(place.x() - cylinder, 0.0) / cap;
    return std::hypot(x, place.y() / half_width, (place.z() - lift) / half_height);
  }
};

CappedCylinder outside_of(const Fingertip& shape) {
  const double cap = shape.width / 2;
  return {shape.length - cap, cap, shape.width / 2, shape.height / 2, 0};
}

CappedCylinder bone_of(const Fingertip& shape) {
  const double cap = shape.width / 4;
  return {shape.length - shape.width / 4 - cap, cap, 0.28 * shape.width, 0.22 * shape.height,
          0.12 * shape.height};
}

struct Surface {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3i> triangles;
};

/// Rings of points around the axis, closed by a point at either end.
Surface surface_of(const Fingertip& shape) {
  const CappedCylinder outside = outside_of(shape);
  const double round = std::numbers::pi * (shape.width + shape.height) / 2;
  const int around = std::max(12, static_cast<int>(std::lround(round / shape.edge)));
  const int along = std::max(2, static_cast<int>(std::lround(outside.cylinder / shape.edge)));
  const int over = std::max(4, around / 4);  // rings of the cap
  Surface surface;
  surface.points.emplace_back(0, 0, 0);
  const auto add_ring = [&](double x, double share) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      surface.points.emplace_back(x, share * outside.half_width * std::cos(angle),
                                  share * outside.half_height * std::sin(angle));
    }
  };
  for (int i = 0; i <= along; ++i) add_ring(outside.cylinder * i / along, 1);
  for (int i = 1; i < over; ++i) {
    const double angle = std::numbers::pi / 2 * i / over;
    add_ring(outside.cylinder + outside.cap * std::sin(angle), std::cos(angle));
  }
  surface.points.emplace_back(shape.length, 0, 0);
  const int rings = along + over, tip = static_cast<int>(surface.points.size()) - 1;
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    const auto point = [&](int ring, int place) { return 1 + ring * around + place; };
    surface.triangles.emplace_back(0, point(0, next), point(0, i));
    for (int ring = 0; ring + 1 < rings; ++ring) {
      surface.triangles.emplace_back(point(ring, i), point(ring, next), point(ring + 1, i));
      surface.triangles.emplace_back(point(ring, next), point(ring + 1, next), point(ring + 1, i));
    }
    surface.triangles.emplace_back(point(rings - 1, i), point(rings - 1, next), tip);
  }
  return surface;
}

void label_elements(const Fingertip& shape, VolumeMesh& mesh) {
  constexpr double kSkinShare = 0.2;  // of half the height
  const CappedCylinder outside = outside_of(shape), bone = bone_of(shape);
  for (int e = 0; e < mesh.element_count(); ++e) {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const int node : mesh.nodes_of(e)) centre += mesh.positions.col(node) / 4;
    const bool in_bone = bone.depth_at(centre) < 1;
    const bool in_skin = outside.depth_at(centre) > 1 - kSkinShare;
    mesh.labels.push_back(in_bone ? kBone : in_skin ? kSkin : kTissue);
  }
  mesh.region_names = {{kTissue, "tissue"}, {kBone, "bone"}, {kSkin, "skin"}};
}

void group_nodes(const Fingertip& shape, VolumeMesh& mesh) {
  std::set<int> bone, nail;
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (mesh.label_of(e) != kBone) continue;
    for (const int node : mesh.nodes_of(e)) bone.insert(node);
  }
  const Eigen::Matrix3Xi triangles = boundary_surface(mesh).triangles;
  for (const int node : triangles.reshaped()) {
    const Eigen::Vector3d place = mesh.positions.col(node);
    const bool above = place.z() > 0.3 * shape.height && std::abs(place.y()) < 0.35 * shape.width;
    if (above && place.x() > shape.length - 0.75 * shape.width) nail.insert(node);
  }
  mesh.groups["bone"].assign(bone.begin(), bone.end());
  mesh.groups["nail"].assign(nail.begin(), nail.end());
  mesh.groups["base"] = nodes_at(mesh, 0, 0);
}

}  // namespace

VolumeMesh make_fingertip(const Fingertip& shape) {
  const Surface surface = surface_of(shape);
  Eigen::Matrix3Xd positions(3, std::ssize(surface.points));
  for (Eigen::Index i = 0; i < positions.cols(); ++i) {
    positions.col(i) = surface.points[static_cast<std::size_t>(i)];
  }
  Eigen::Matrix3Xi triangles(3, std::ssize(surface.triangles));
  for (Eigen::Index i = 0; i < triangles.cols(); ++i) {
    triangles.col(i) = surface.triangles[static_cast<std::size_t>(i)];
  }
  VolumeMesh mesh = fill_surface(positions, triangles, shape.edge);
  label_elements(shape, mesh);
  group_nodes(shape, mesh);
  return mesh;
}

}  // namespace pliant
