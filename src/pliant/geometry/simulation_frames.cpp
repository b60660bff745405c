#include "pliant/geometry/simulation_frames.h"

#include <cmath>
#include <span>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/plane_cut.h"
#include "pliant/geometry/volume_file.h"
#include "pliant/io/document.h"
#include "pliant/io/fields.h"
#include "pliant/io/obj.h"
#include "pliant/io/ply.h"

namespace pliant {
namespace {

// Frame files have six digits.
constexpr int kLargestIndex = 999'999;

std::vector<SimulationFrame> read_frames(const Value& list) {
  std::vector<SimulationFrame> frames;
  for (const Value& item : list.items()) {
    Fields fields = item.fields();
    const Value index = fields.require("index");
    const Value time = fields.require("time");
    const SimulationFrame frame{index.integer(0, kLargestIndex), time.number()};
    if (!frames.empty() && frame.index <= frames.back().index) {
      index.fail("frames out of order", "a number above that of the frame before");
    }
    if (!frames.empty() && !(frame.time > frames.back().time)) {
      time.fail("frames out of order", "a time after that of the frame before");
    }
    frames.push_back(frame);
  }
  if (frames.empty()) list.fail("no frames", "a simulation that wrote frames as PLY files");
  return frames;
}

int triangle_count(const Polygons& faces) {
  const size_t count = faces.corners.size() - 2 * faces.size();
  return static_cast<int>(count);
}

Eigen::Matrix3Xi fan_triangles(const Polygons& faces) {
  Eigen::Matrix3Xi triangles(3, triangle_count(faces));
  Eigen::Index next = 0;
  for (size_t face = 0; face < faces.size(); ++face) {
    const std::span<const int> corners = faces[face];
    for (size_t k = 2; k < corners.size(); ++k) {
      triangles.col(next++) << corners[0], corners[k - 1], corners[k];
    }
  }
  return triangles;
}

Eigen::Matrix3Xd matrix_of(const std::vector<Point3>& points) {
  static_assert(sizeof(Point3) == 3 * sizeof(double));
  return Eigen::Map<const Eigen::Matrix3Xd>(points.front().data(), 3, std::ssize(points));
}

}  // namespace

std::filesystem::path SimulationFrames::file_of(const SimulationFrame& frame) const {
  return directory / "frames" / fmt::format("{:06}.ply", frame.index);
}

std::filesystem::path SimulationFrames::obstacles_of(const SimulationFrame& frame) const {
  if (!std::filesystem::is_directory(obstacles)) return obstacles;
  return obstacles / fmt::format("{:06}.obj", frame.index);
}

const SimulationFrame* frame_at(const SimulationFrames& simulation, double time) {
  constexpr double kSame = 1e-6;  // s
  for (const SimulationFrame& frame : simulation.frames) {
    if (std::abs(frame.time - time) < kSame) return &frame;
  }
  return nullptr;
}

SimulationFrames read_simulation_frames(const std::filesystem::path& directory) {
  if (!std::filesystem::is_directory(directory)) {
    throw InputError({directory.string()}, "is no directory", "the results of simulate");
  }
  const Document document = read_json(directory / "simulation.json");
  Fields fields = Value(document).fields();
  require_document(fields, "simulation", 1);
  // Of the many further fields pictures need none.
  SimulationFrames simulation;
  simulation.directory = directory;
  simulation.frames = read_frames(fields.require("frames"));
  simulation.units = fields.texts("fields");
  if (const auto mesh = fields.optional("mesh")) simulation.mesh = directory / mesh->text();
  if (const auto still = fields.optional("obstacles")) {
    simulation.obstacles = directory / still->text();
  }
  if (const auto solids = fields.optional("solids")) simulation.solids = directory / solids->text();
  return simulation;
}

TriangleMesh read_cloth(const std::filesystem::path& file) {
  const ObjMesh obj = read_obj(file);
  TriangleMesh mesh;
  mesh.positions = matrix_of(obj.positions);
  mesh.triangles = fan_triangles(obj.faces);
  const bool triangles = std::ssize(obj.faces.corners) == mesh.triangles.size();
  if (!triangles || obj.texture_corners.size() != obj.faces.corners.size()) {
    throw InputError({file.string()}, "is no cloth with its rest plane",
                     "triangles with texture coordinates, as simulate writes them");
  }
  mesh.rest_corners.resize(2, mesh.triangles.size());
  for (Eigen::Index c = 0; c < mesh.rest_corners.cols(); ++c) {
    const int point = obj.texture_corners[static_cast<size_t>(c)];
    if (point < 0) throw InputError({file.string()}, "has a corner without texture point");
    const auto& [u, v] = obj.texture_points[static_cast<size_t>(point)];
    mesh.rest_corners.col(c) << u, v;
  }
  return mesh;
}

SolidMesh read_obstacles(const std::filesystem::path& file) {
  const ObjMesh obj = read_obj(file);
  if (obj.positions.empty() || obj.faces.size() == 0) {
    throw InputError({file.string()}, "has no faces", "the surfaces of obstacles");
  }
  return {matrix_of(obj.positions), fan_triangles(obj.faces)};
}

Eigen::Matrix4Xi read_solids(const std::filesystem::path& file) {
  return tetrahedra_of(read_volume_file(file, {.unit = 1}).mesh);
}

FrameMesh read_frame(const std::filesystem::path& file) {
  const PlyMesh ply = read_ply(file);
  if (ply.positions.empty() || ply.faces.size() == 0) {
    throw InputError({file.string()}, "has no faces", "the surface of a cloth");
  }
  constexpr double kFarthest = 1e15;  // m; beyond it, products of coordinates overflow in the rays
  FrameMesh mesh;
  mesh.positions = matrix_of(ply.positions);
  if (!(mesh.positions.cwiseAbs().maxCoeff() < kFarthest)) {
    throw InputError({file.string()}, "has vertices too far away to be drawn",
                     "coordinates below 1e15 m");
  }
  mesh.triangles = fan_triangles(ply.faces);
  for (const PlyColumn& column : ply.vertex_columns) {
    mesh.fields[column.name] =
        Eigen::Map<const Eigen::VectorXd>(column.values.data(), std::ssize(column.values));
  }
  return mesh;
}

}  // namespace pliant
