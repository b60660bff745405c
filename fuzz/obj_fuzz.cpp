// The OBJ reader on arbitrary bytes: it gives a mesh that is sound, or an InputError. What it gives
// is the same after writing and reading it again.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "pliant/base/errors.h"
#include "pliant/io/obj.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void require_sound(const pliant::ObjMesh& mesh) {
  for (const int corner : mesh.faces.corners) {
    require(corner >= 0 && static_cast<std::size_t>(corner) < mesh.positions.size());
  }
  for (const int corner : mesh.texture_corners) {
    require(corner >= -1 && corner < static_cast<long>(mesh.texture_points.size()));
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) require(mesh.faces[i].size() >= 3);
  require(mesh.face_lines.size() == mesh.faces.size());
  require(mesh.vertex_lines.size() == mesh.positions.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pliant::ObjMesh mesh;
  try {
    mesh = pliant::parse_obj({reinterpret_cast<const char*>(data), size}, "fuzz.obj");
  } catch (const pliant::InputError&) {
    return 0;
  }
  require_sound(mesh);
  // An InputError from here on is a defect, so it is not caught.
  const pliant::ObjMesh again = pliant::parse_obj(pliant::write_obj(mesh), "again.obj");
  require(again.positions == mesh.positions);
  require(again.texture_points == mesh.texture_points);
  require(again.faces == mesh.faces);
  require(again.texture_corners == mesh.texture_corners);
  return 0;
}
