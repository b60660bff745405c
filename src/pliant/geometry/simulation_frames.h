#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

struct SimulationFrame {
  int index = 0;    ///< number of its file
  double time = 0;  ///< s
};

/// The results of `simulate` as far as pictures need them.
struct SimulationFrames {
  std::filesystem::path directory;
  std::vector<SimulationFrame> frames;       ///< one or more, index and time increasing
  std::map<std::string, std::string> units;  ///< of fields, by name, where they are known
  std::filesystem::path mesh = {};  ///< the cloth with its rest plane; empty where not written
  /// Surfaces of obstacles: a file, or a folder with one for each frame; empty where there are
  /// none.
  std::filesystem::path obstacles = {};
  std::filesystem::path solids = {};  ///< elements of solids; empty where there are none

  std::filesystem::path file_of(const SimulationFrame& frame) const;
  /// Empty where there are no obstacles.
  std::filesystem::path obstacles_of(const SimulationFrame& frame) const;
};

/// The frame at a time (s), of two simulations whose steps are rounded; null where there is none.
const SimulationFrame* frame_at(const SimulationFrames& simulation, double time);

/// Reads `directory`/simulation.json.
/// @throws InputError
SimulationFrames read_simulation_frames(const std::filesystem::path& directory);

/// The cloth that all frames show, with its rest coordinates.
/// @param file  OBJ, triangles with texture coordinates in metres
/// @throws InputError
TriangleMesh read_cloth(const std::filesystem::path& file);

/// Surfaces of solid bodies.
struct SolidMesh {
  Eigen::Matrix3Xd positions;  ///< m
  Eigen::Matrix3Xi triangles;
};

/// @param file  OBJ
/// @throws InputError
SolidMesh read_obstacles(const std::filesystem::path& file);

/// The elements of solids as tetrahedra of the vertices of frames.
/// @param file  VTU
/// @throws InputError
Eigen::Matrix4Xi read_solids(const std::filesystem::path& file);

/// The surfaces of one frame; inner nodes of solids are vertices, too.
struct FrameMesh {
  Eigen::Matrix3Xd positions;                     ///< m
  Eigen::Matrix3Xi triangles;                     ///< polygons are cut into fans
  std::map<std::string, Eigen::VectorXd> fields;  ///< further properties of the vertices
};

/// @throws InputError
FrameMesh read_frame(const std::filesystem::path& file);

}  // namespace pliant
