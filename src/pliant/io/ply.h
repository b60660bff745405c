#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/io/mesh_data.h"

namespace pliant {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };

/// Types of a property in the file; `double` holds all of their values.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// A property with one number for each vertex or face.
struct PlyColumn {
  std::string name;  ///< one word
  std::vector<double> values;
  PlyType type = PlyType::float64;
};

/// What a PLY file says about a mesh: positions, faces and further properties by name.
struct PlyMesh {
  std::vector<Point3> positions;
  Polygons faces;
  std::vector<PlyColumn> vertex_columns;  ///< without x, y, z
  std::vector<PlyColumn> face_columns;
  std::vector<std::string> comments;  ///< one line each
  /// After reading: what else the file holds, in words fit for a warning.
  std::vector<std::string> ignored;
};

struct PlyOptions {
  PlyFormat format = PlyFormat::binary_little_endian;
  PlyType coordinates = PlyType::float64;  ///< float32 or float64
};

/// Whether a position may be something else than finite numbers.
enum class PlyPositions { finite, any };

/// Reads ASCII and binary PLY. Elements other than `vertex` and `face` and properties that are
/// lists (but for the corners of faces) are ignored and named in `ignored`. In ASCII files each
/// vertex and face stands on a line of its own.
/// @throws InputError with the line, or the number of the vertex or face, counted from 0: a header
///         that makes no sense or claims more than the file can hold, a position that is not
///         finite where it must be, a face without three corners, a corner that is no vertex
PlyMesh read_ply(const std::filesystem::path& path, PlyPositions positions = PlyPositions::finite);
PlyMesh parse_ply(std::string_view bytes, const std::string& file,
                  PlyPositions positions = PlyPositions::finite);

/// The bytes of a PLY file. Numbers come back from `read_ply` as they are here, to the bit (those
/// of float32 columns rounded to it).
std::string write_ply(const PlyMesh& mesh, const PlyOptions& options = {});

}  // namespace pliant
