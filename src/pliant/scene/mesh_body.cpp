#include "pliant/scene/mesh_body.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pliant/geometry/world_positions.h"

namespace pliant {
namespace {

// A face that runs over a vertex twice has no extent; its edges are those of its neighbours.
Eigen::Matrix3Xi triangles_of(const PolygonMesh& polygons) {
  const CutFaces cut =
      cut_into_triangles(polygons.faces, face_planes(polygons), polygons.numbering);
  Eigen::Matrix3Xi triangles(3, cut.corners.cols());
  Eigen::Index count = 0;
  for (const auto& corners : cut.corners.colwise()) {
    const Eigen::Vector3i triangle =
        corners.unaryExpr([&](int corner) { return polygons.faces.corners[size_t(corner)]; });
    const auto& [a, b, c] = std::array{triangle(0), triangle(1), triangle(2)};
    if (a != b && b != c && c != a) triangles.col(count++) = triangle;
  }
  return triangles.leftCols(count);
}

void require_same_faces(const PolygonMesh& frame, const PolygonMesh& first) {
  if (frame.faces == first.faces && frame.positions.cols() == first.positions.cols()) return;
  throw InputError(
      {frame.numbering.file},
      fmt::format("has {} vertices and {} faces, not those of {}, which has {} and {}",
                  frame.positions.cols(), frame.faces.size(), quoted_value(first.numbering.file),
                  first.positions.cols(), first.faces.size()),
      "the same vertices and faces in every frame, which only move");
}

}  // namespace

MeshBody::MeshBody(const BodySource& source, const std::optional<Motion>& motion)
    : rate_(source.rate), motion_(motion) {
  const PolygonMesh first = read_polygon_mesh(source.files.front());
  triangles_ = triangles_of(first);
  frames_.push_back(world_positions(first, source.unit, source.up));
  for (size_t i = 1; i < source.files.size(); ++i) {
    const PolygonMesh frame = read_polygon_mesh(source.files[i]);
    require_same_faces(frame, first);
    frames_.push_back(world_positions(frame, source.unit, source.up));
  }
}

Eigen::Matrix3Xd MeshBody::positions(double time) const {
  const double frame = std::clamp(time * rate_, 0.0, static_cast<double>(frames_.size() - 1));
  const auto before = static_cast<size_t>(frame);
  Eigen::Matrix3Xd positions = frames_[before];
  if (const double share = frame - std::floor(frame); share > 0) {
    positions += share * (frames_[before + 1] - positions);
  }
  if (!motion_) return positions;
  const Pose pose = pose_at(*motion_, time);
  return (pose.rotation.toRotationMatrix() * positions).colwise() + pose.translation;
}

}  // namespace pliant
