#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <variant>

#include "pliant/geometry/fingertip.h"
#include "pliant/geometry/volume_mesh.h"
#include "pliant/io/fields.h"

namespace pliant {

/// A volume mesh in a file.
struct VolumeFileSource {
  std::filesystem::path file;
  double unit = 0;       ///< m per unit of the coordinates
  std::string up = "z";  ///< the axis that becomes the world's z
};

/// A block from (0, 0, 0) to `size`, cut into cells.
struct BlockSource {
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< m
  std::array<int, 3> cells{};                      ///< along x, y and z
  bool of_tetrahedra = false;                      ///< each cell cut into six; else hexahedra
};

/// Tetrahedra in the closed surface of a file.
struct SurfaceSource {
  std::filesystem::path file;
  double unit = 0;       ///< m per unit of the coordinates
  std::string up = "z";  ///< the axis that becomes the world's z
  double edge = 0;       ///< length that edges aim at, m
};

/// Tetrahedra in the regions of a segmented image.
struct LabelSource {
  std::filesystem::path file;
  double unit = 0;  ///< m per unit of the file's lengths
  double edge = 0;  ///< length that edges aim at, m
};

/// How a body comes by its mesh.
struct VolumeSource {
  std::variant<VolumeFileSource, BlockSource, SurfaceSource, LabelSource, Fingertip> kind;
  Location where;

  /// The file that it names; empty for none.
  std::filesystem::path file() const;
};

/// `{file, unit, up}`, `{block, cells, elements}`, `{surface, unit, up, edge}`,
/// `{labels, unit, edge}` or `{fingertip, edge}`.
/// @throws InputError, also for a file that does not exist; its content is not looked at
VolumeSource read_volume_source(const Value& value);

/// The mesh, in the body's own coordinates.
/// @throws InputError, also for a mesh that is unfit for simulation
VolumeMesh make_volume_mesh(const VolumeSource& source);

}  // namespace pliant
