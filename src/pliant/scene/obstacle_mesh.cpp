#include "pliant/scene/obstacle_mesh.h"

#include <array>
#include <cmath>
#include <numbers>

namespace pliant {
namespace {

constexpr int kAround = 72;  // facets of a round body around its axis
constexpr int kHalf = 18;    // rings from its pole to its equator

int add_point(const Eigen::Vector3d& point, ObjMesh& mesh) {
  mesh.positions.push_back({point.x(), point.y(), point.z()});
  return static_cast<int>(mesh.positions.size()) - 1;
}

/// Two axes across a direction, right-handed with it.
std::pair<Eigen::Vector3d, Eigen::Vector3d> across(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d first = direction.unitOrthogonal();
  return {first, direction.cross(first)};
}

// Rings of points from the pole behind `from` to that beyond `to`; the equator stands at both ends.
void add_round(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
               ObjMesh& mesh) {
  const Eigen::Vector3d axis =
      from == to ? Eigen::Vector3d::UnitZ().eval() : (to - from).normalized();
  const auto [u, v] = across(axis);
  const int first = static_cast<int>(mesh.positions.size());
  constexpr int kRings = 2 * kHalf + 2;
  for (int ring = 0; ring < kRings; ++ring) {
    const bool far = ring > kHalf;
    const double latitude = std::numbers::pi / 2 * ((far ? ring - 1 : ring) - kHalf) / kHalf;
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2 * std::numbers::pi * i / kAround;
      const Eigen::Vector3d out = std::cos(latitude) * (std::cos(angle) * u + std::sin(angle) * v) +
                                  std::sin(latitude) * axis;
      add_point((far ? to : from) + radius * out, mesh);
    }
  }
  for (int ring = 0; ring + 1 < kRings; ++ring) {
    if (ring == kHalf && from == to) continue;  // both equators are one
    for (int i = 0; i < kAround; ++i) {
      const int here = first + ring * kAround + i;
      const int next = first + ring * kAround + (i + 1) % kAround;
      mesh.faces.add(std::array{here, next, next + kAround});
      mesh.faces.add(std::array{here, next + kAround, here + kAround});
    }
  }
}

void add_shape(const Sphere& body, const Eigen::AlignedBox3d&, ObjMesh& mesh) {
  add_round(body.centre, body.centre, body.radius, mesh);
}

void add_shape(const Capsule& body, const Eigen::AlignedBox3d&, ObjMesh& mesh) {
  add_round(body.from, body.to, body.radius, mesh);
}

void add_shape(const HalfSpace& body, const Eigen::AlignedBox3d& cloth, ObjMesh& mesh) {
  const Eigen::Vector3d above = cloth.center();
  const Eigen::Vector3d centre = above - body.normal.dot(above - body.point) * body.normal;
  const auto [u, v] = across(body.normal);
  const double half = 0.75 * cloth.diagonal().norm();
  const int first = static_cast<int>(mesh.positions.size());
  for (const auto& [a, b] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
    add_point(centre + half * (a * u + b * v), mesh);
  }
  mesh.faces.add(std::array{first, first + 1, first + 2});
  mesh.faces.add(std::array{first, first + 2, first + 3});
}

// Corner i has the sign of axis k where bit k of i says so.
void add_shape(const Box& body, const Eigen::AlignedBox3d&, ObjMesh& mesh) {
  const int first = static_cast<int>(mesh.positions.size());
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    add_point(body.centre + body.half.cwiseProduct(signs), mesh);
  }
  constexpr std::array<std::array<int, 4>, 6> kFaces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& [a, b, c, d] : kFaces) {
    mesh.faces.add(std::array{first + a, first + b, first + c});
    mesh.faces.add(std::array{first + a, first + c, first + d});
  }
}

void move_from(size_t first, const Pose& pose, ObjMesh& mesh) {
  for (size_t i = first; i < mesh.positions.size(); ++i) {
    auto& [x, y, z] = mesh.positions[i];
    const Eigen::Vector3d moved = pose.apply({x, y, z});
    mesh.positions[i] = {moved.x(), moved.y(), moved.z()};
  }
}

void add_body(const MeshBody& body, double time, ObjMesh& mesh) {
  const int first = static_cast<int>(mesh.positions.size());
  const Eigen::Matrix3Xd positions = body.positions(time);
  for (const Eigen::Vector3d position : positions.colwise()) add_point(position, mesh);
  for (const auto& triangle : body.triangles().colwise()) {
    mesh.faces.add(std::array{first + triangle(0), first + triangle(1), first + triangle(2)});
  }
}

}  // namespace

ObjMesh obstacle_mesh(std::span<const SceneObstacle> obstacles,
                      const std::vector<BodyPiece>& bodies, const Eigen::AlignedBox3d& cloth,
                      double time) {
  ObjMesh mesh;
  for (const SceneObstacle& obstacle : obstacles) {
    const ObstacleShape* shape = obstacle.shape();
    if (!shape) continue;
    const size_t first = mesh.positions.size();
    std::visit([&](const auto& body) { add_shape(body, cloth, mesh); }, *shape);
    if (obstacle.motion) move_from(first, pose_at(*obstacle.motion, time), mesh);
  }
  for (const BodyPiece& piece : bodies) add_body(*piece.body, time, mesh);
  return mesh;
}

}  // namespace pliant
