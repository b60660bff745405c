#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/io/obj.h"

namespace pliant {

std::string write_obj(const ObjMesh& mesh) {
  const bool textured = !mesh.texture_corners.empty();
  PLIANT_ASSERT(!textured || mesh.texture_corners.size() == mesh.faces.corners.size(),
                "every corner has a texture point or -1");
  std::string text;
  for (const Point3& p : mesh.positions) text += fmt::format("v {} {} {}\n", p[0], p[1], p[2]);
  for (const Point2& p : mesh.texture_points) text += fmt::format("vt {} {}\n", p[0], p[1]);
  for (std::size_t face = 0, corner = 0; face < mesh.faces.size(); ++face) {
    text += 'f';
    for (; corner < mesh.faces.ends[face]; ++corner) {
      text += fmt::format(" {}", mesh.faces.corners[corner] + 1L);
      const int point = textured ? mesh.texture_corners[corner] : -1;
      if (point >= 0) text += fmt::format("/{}", point + 1L);
    }
    text += '\n';
  }
  return text;
}

}  // namespace pliant
