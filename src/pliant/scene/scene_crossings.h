#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/scene/mesh_body.h"

namespace pliant {

/// Faces of cloth that pass through others.
struct SceneCrossings {
  std::vector<std::array<int, 2>> of_cloth;  ///< with faces of cloth, counted over all cloth
  struct OfBody {
    std::string name;
    std::vector<std::array<int, 2>> faces;  ///< of cloth, of the body
  };
  std::vector<OfBody> of_bodies;  ///< of those that cloth passes through

  std::size_t count() const;
  /// "2 pairs of faces, the first of them 3 and 18, counted from 0 over all cloth"; "" for none.
  std::string text() const;
};

/// By an exact test that knows nothing of contact.
/// @param positions  of all points of the system (m)
/// @param faces      of all cloth
/// @return nothing where the program was built without CGAL
std::optional<SceneCrossings> scene_crossings(const Eigen::Matrix3Xd& positions,
                                              const Eigen::Matrix3Xi& faces,
                                              const std::vector<BodyPiece>& bodies);

}  // namespace pliant
