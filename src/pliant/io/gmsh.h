#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "pliant/io/volume_data.h"

namespace pliant {

/// Reads a mesh of gmsh (.msh, ASCII, format 2.2 or 4.1): tetrahedra and hexahedra of first order.
/// Physical volumes are the labels of elements; named physical points, lines and surfaces are
/// groups of points. Elements without a physical volume have the label 0.
/// @throws InputError with the line, also for binary files, other formats, elements of higher
/// order,
///         prisms and pyramids
VolumeData read_gmsh(const std::filesystem::path& path);
VolumeData parse_gmsh(std::string_view text, const std::string& file);

/// The text of a file of format 2.2; `read_gmsh` gives back points, elements, labels and groups to
/// the bits.
std::string write_gmsh(const VolumeData& data);

}  // namespace pliant
