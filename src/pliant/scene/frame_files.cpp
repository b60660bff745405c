#include "pliant/scene/frame_files.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/io/obj.h"
#include "pliant/io/ply.h"
#include "pliant/io/vtu.h"
#include "pliant/mechanics/vertex_fields.h"
#include "pliant/scene/obstacle_mesh.h"

namespace pliant {
namespace {

bool asks_for_field(const Simulation& simulation, const std::string& name) {
  const auto& fields = simulation.scene().output.fields;
  const FrameField kind = name.starts_with("friction.") ? FrameField::friction : FrameField::strain;
  return std::find(fields.begin(), fields.end(), kind) != fields.end();
}

Polygons faces_of(const Simulation& simulation) {
  const Eigen::Matrix3Xi& triangles = simulation.built().faces;
  Polygons faces;
  for (Eigen::Index f = 0; f < triangles.cols(); ++f) {
    faces.add(std::array{triangles(0, f), triangles(1, f), triangles(2, f)});
  }
  return faces;
}

// Values at all vertices by name; 0 on cloths and solids that do not have a field.
std::map<std::string, Eigen::VectorXd> all_fields(const Simulation& simulation) {
  std::map<std::string, Eigen::VectorXd> all;
  if (simulation.scene().output.fields.empty()) return all;
  const SceneSystem& built = simulation.built();
  const auto add = [&](const auto& piece, int vertices) {
    for (const auto& [name, values] : vertex_fields(*built.system, simulation.now().state,
                                                    piece.shown, piece.first_point, vertices)) {
      if (!asks_for_field(simulation, name)) continue;
      Eigen::VectorXd& column = all[name];
      if (column.size() == 0) column = Eigen::VectorXd::Zero(built.vertices);
      column.segment(piece.first_point, vertices) = values;
    }
  };
  for (const ClothPiece& cloth : built.cloths) add(cloth, cloth.mesh.vertex_count());
  for (const SolidPiece& solid : built.solids) add(solid, solid.node_count());
  return all;
}

std::vector<double> numbers(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

std::string ply_bytes(const Simulation& simulation) {
  PlyMesh ply;
  ply.positions = cloth_points(simulation);
  ply.faces = faces_of(simulation);
  for (const auto& [name, values] : all_fields(simulation)) {
    ply.vertex_columns.push_back({name, numbers(values)});
  }
  ply.comments = {fmt::format("time {} s", simulation.now().state.time)};
  return write_ply(ply);
}

std::vector<int> corners_of(const auto& elements, int first_point) {
  std::vector<int> corners;
  for (const int node : elements.reshaped()) corners.push_back(node + first_point);
  return corners;
}

void add_cells(VtkCell cell, const auto& elements, int first_point, VtuGrid& grid) {
  if (elements.cols() > 0) grid.cells.push_back({cell, corners_of(elements, first_point)});
}

void add_solids(const SceneSystem& built, VtuGrid& grid) {
  for (const SolidPiece& solid : built.solids) {
    add_cells(VtkCell::tetrahedron, solid.mesh.tetrahedra, solid.first_point, grid);
    add_cells(VtkCell::hexahedron, solid.mesh.hexahedra, solid.first_point, grid);
  }
}

std::string vtu_bytes(const Simulation& simulation) {
  VtuGrid grid;
  grid.points = cloth_points(simulation);
  for (const ClothPiece& cloth : simulation.built().cloths) {
    add_cells(VtkCell::triangle, cloth.mesh.triangles, cloth.first_point, grid);
  }
  add_solids(simulation.built(), grid);
  for (const auto& [name, values] : all_fields(simulation)) {
    grid.point_data.push_back({name, 1, numbers(values)});
  }
  return write_vtu(grid);
}

std::string clip_table(const Simulation& simulation) {
  const std::vector<SceneClip>& clips = simulation.scene().clips;
  const SimulationState& now = simulation.now();
  std::string table = "frame,time_s,clip,tx,ty,tz,qw,qx,qy,qz,fx,fy,fz\n";
  for (size_t i = 0; i < now.clips.size(); ++i) {
    const size_t frame = i / clips.size();
    const ClipRow& row = now.clips[i];
    table += fmt::format("{},{},{},{},{},{}\n", frame, now.energies[frame].time,
                         clips[i % clips.size()].name, fmt::join(row.translation, ","),
                         fmt::join(row.rotation, ","), fmt::join(row.force, ","));
  }
  return table;
}

std::string pvd_text(const Simulation& simulation) {
  std::vector<PvdFrame> frames;
  for (const EnergyRow& row : simulation.now().energies) {
    frames.push_back({row.time, fmt::format("frames/{:06}.vtu", frames.size())});
  }
  return write_pvd(frames);
}

/// Corners of one vertex at one place of the rest plane share a texture point.
void add_rest_plane(const TriangleMesh& mesh, ObjMesh& obj) {
  std::map<std::pair<int, Point2>, int> points;
  for (Eigen::Index c = 0; c < mesh.rest_corners.cols(); ++c) {
    const Point2 place{mesh.rest_corners(0, c), mesh.rest_corners(1, c)};
    const auto next = static_cast<int>(obj.texture_points.size());
    const auto [found, added] = points.try_emplace({mesh.triangles(c), place}, next);
    if (added) obj.texture_points.push_back(place);
    obj.texture_corners.push_back(found->second);
  }
}

// Of a strain or a stress of friction.
const char* unit_of_field(const std::string& name) {
  const size_t dot = name.find('.');
  const std::string component = name.substr(dot + 1);
  const bool bending = component.starts_with("bend.");
  if (!name.starts_with("friction.")) return bending ? "1/m" : "1";
  if (units_of(component) == LawUnits::solid) return "Pa";
  return bending ? "N" : "N/m";
}

}  // namespace

std::vector<Point3> cloth_points(const Simulation& simulation) {
  const Eigen::Matrix3Xd& positions = simulation.now().state.configuration.positions;
  std::vector<Point3> points;
  for (int i = 0; i < simulation.built().vertices; ++i) {
    points.push_back({positions(0, i), positions(1, i), positions(2, i)});
  }
  return points;
}

std::map<std::string, std::string> frame_fields(const Simulation& simulation) {
  std::map<std::string, std::string> fields;
  for (const auto& [name, values] : all_fields(simulation)) {
    fields.emplace(name, unit_of_field(name));
  }
  return fields;
}

std::vector<NamedFile> frame_files(const Simulation& simulation, int index) {
  std::vector<NamedFile> files;
  if (simulation.scene().output.has(FrameFormat::ply)) {
    files.emplace_back(fmt::format("frames/{:06}.ply", index), ply_bytes(simulation));
  }
  if (simulation.scene().output.has(FrameFormat::vtu)) {
    files.emplace_back(fmt::format("frames/{:06}.vtu", index), vtu_bytes(simulation));
  }
  if (has_moving_obstacles(simulation.scene().obstacles)) {
    files.emplace_back(fmt::format("obstacles/{:06}.obj", index), obstacles_obj(simulation));
  }
  return files;
}

std::vector<NamedFile> series_files(const Simulation& simulation) {
  std::vector<NamedFile> files{{"energy.csv", energy_table(simulation.now().energies)}};
  if (!simulation.scene().clips.empty()) files.emplace_back("clips.csv", clip_table(simulation));
  if (simulation.scene().output.has(FrameFormat::vtu)) {
    files.emplace_back("simulation.pvd", pvd_text(simulation));
  }
  return files;
}

std::string cloth_obj(const Simulation& simulation) {
  ObjMesh obj;
  obj.positions = cloth_points(simulation);
  obj.faces = faces_of(simulation);
  for (const ClothPiece& cloth : simulation.built().cloths) {
    add_rest_plane(cloth.mesh, obj);
  }
  // Surfaces of solids have no rest plane.
  if (!obj.texture_corners.empty()) obj.texture_corners.resize(obj.faces.corners.size(), -1);
  return write_obj(obj);
}

std::string solids_vtu(const Simulation& simulation) {
  VtuGrid grid;
  grid.points = cloth_points(simulation);
  add_solids(simulation.built(), grid);
  return write_vtu(grid);
}

std::string obstacles_obj(const Simulation& simulation) {
  Eigen::AlignedBox3d box;
  for (const ClothPiece& cloth : simulation.built().cloths) {
    box.extend(Eigen::AlignedBox3d(cloth.mesh.positions.rowwise().minCoeff(),
                                   cloth.mesh.positions.rowwise().maxCoeff()));
  }
  for (const SolidPiece& solid : simulation.built().solids) {
    box.extend(
        Eigen::AlignedBox3d(solid.placed.rowwise().minCoeff(), solid.placed.rowwise().maxCoeff()));
  }
  return write_obj(obstacle_mesh(simulation.scene().obstacles, simulation.built().bodies, box,
                                 simulation.now().state.time));
}

}  // namespace pliant
