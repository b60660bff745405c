#include "pliant/scene/scene_crossings.h"

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/crossings.h"

namespace pliant {

std::size_t SceneCrossings::count() const {
  std::size_t count = of_cloth.size();
  for (const OfBody& body : of_bodies) count += body.faces.size();
  return count;
}

std::string SceneCrossings::text() const {
  if (count() == 0) return "";
  const auto pairs = count() == 1 ? "1 pair of faces, "
                                  : fmt::format("{} pairs of faces, the first of them ", count());
  if (!of_cloth.empty()) {
    return fmt::format("{}{} and {}, counted from 0 over all cloth", pairs, of_cloth.front()[0],
                       of_cloth.front()[1]);
  }
  const OfBody& body = of_bodies.front();
  return fmt::format("{}{}, counted from 0 over all cloth, and {} of {}", pairs,
                     body.faces.front()[0], body.faces.front()[1], quoted_value(body.name));
}

std::optional<SceneCrossings> scene_crossings(const Eigen::Matrix3Xd& positions,
                                              const Eigen::Matrix3Xi& faces,
                                              const std::vector<BodyPiece>& bodies) {
  const auto of_cloth = crossing_triangles(positions, faces);
  if (!of_cloth) return std::nullopt;
  SceneCrossings crossings{*of_cloth, {}};
  for (const BodyPiece& piece : bodies) {
    const auto pairs = crossing_triangles(positions, faces, piece.triangles());
    if (!pairs->empty()) crossings.of_bodies.push_back({piece.name, *pairs});
  }
  return crossings;
}

}  // namespace pliant
