// The PLY reader on arbitrary bytes: it gives a mesh that is sound, or an InputError. What it gives
// is the same after writing and reading it again.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "pliant/base/errors.h"
#include "pliant/io/ply.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void require_sound(const pliant::PlyMesh& mesh) {
  for (const int corner : mesh.faces.corners) {
    require(corner >= 0 && static_cast<std::size_t>(corner) < mesh.positions.size());
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) require(mesh.faces[i].size() >= 3);
  for (const auto& column : mesh.vertex_columns) {
    require(column.values.size() == mesh.positions.size());
  }
  for (const auto& column : mesh.face_columns) require(column.values.size() == mesh.faces.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pliant::PlyMesh mesh;
  try {
    mesh = pliant::parse_ply({reinterpret_cast<const char*>(data), size}, "fuzz.ply");
  } catch (const pliant::InputError&) {
    return 0;
  }
  require_sound(mesh);
  // An InputError from here on is a defect, so it is not caught.
  for (const auto format : {pliant::PlyFormat::ascii, pliant::PlyFormat::binary_big_endian}) {
    const pliant::PlyMesh again = pliant::parse_ply(pliant::write_ply(mesh, {format}), "again.ply");
    require(again.positions == mesh.positions);
    require(again.faces == mesh.faces);
    require(again.vertex_columns.size() == mesh.vertex_columns.size());
  }
  return 0;
}
