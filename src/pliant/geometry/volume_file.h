#pragma once

#include <filesystem>
#include <string>

#include "pliant/geometry/volume_mesh.h"
#include "pliant/geometry/volume_quality.h"
#include "pliant/io/volume_data.h"

namespace pliant {

/// What a file of a volume mesh does not say about itself.
struct VolumeFileOptions {
  double unit = 0;       ///< m per unit of the coordinates; must be given
  std::string up = "z";  ///< the axis of the file that becomes the world's z
};

/// Whether the ending of a file's name is one of a volume mesh that can be read: .msh, .mesh,
/// .vtu.
bool is_volume_file(const std::filesystem::path& path);

/// A volume mesh as its file has it.
struct VolumeFile {
  VolumeMesh mesh;
  VolumeNumbering numbering;
  std::map<std::string, int> ignored;  ///< what was left out, and how often
};

/// Reads a file by the ending of its name (.msh of gmsh, .mesh of Medit, .vtu of VTK). The mesh is
/// not judged.
/// @throws InputError
VolumeFile read_volume_file(const std::filesystem::path& path, const VolumeFileOptions& options);

/// The mesh of a file, fit for simulation.
/// @throws InputError, also for what `find_volume_problems` finds
VolumeMesh read_volume_mesh(const std::filesystem::path& path, const VolumeFileOptions& options);

/// The text of a file of a mesh (m), by the ending of its name.
/// @throws InputError for another ending
std::string volume_file_text(const VolumeMesh& mesh, const std::filesystem::path& path);

}  // namespace pliant
