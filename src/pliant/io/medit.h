#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "pliant/io/volume_data.h"

namespace pliant {

/// Reads a mesh of Medit, as TetGen, Mmg and CGAL write it (.mesh, ASCII): tetrahedra and
/// hexahedra, whose references are their labels.
/// @throws InputError with the line, also for elements of another kind
VolumeData read_medit(const std::filesystem::path& path);
VolumeData parse_medit(std::string_view text, const std::string& file);

/// The text of such a file; `read_medit` gives back points, elements and labels to the bits.
std::string write_medit(const VolumeData& data);

}  // namespace pliant
