#pragma once

#include <filesystem>
#include <string>

#include "pliant/io/volume_data.h"

namespace pliant {

/// Reads the tetrahedra and hexahedra of first order of a VTK unstructured grid (.vtu) of one
/// piece, as ParaView, meshio, gmsh and `simulate` write them: numbers as text, base64 or raw
/// bytes, within their tags or appended, packed with zlib or not. Labels of elements are the
/// cells' field `label` (or region, material, gmsh:physical, medit:ref, CellEntityIds), else the
/// only field of whole numbers that they have, else 0.
/// @throws InputError, also for cells of higher order, prisms and pyramids, other packers, and
///         bytes that are missing
VolumeData read_vtu_volume(const std::filesystem::path& path);

/// The text of such a file; `read_vtu_volume` gives back points, elements and labels to the bits.
std::string write_vtu_volume(const VolumeData& data);

}  // namespace pliant
