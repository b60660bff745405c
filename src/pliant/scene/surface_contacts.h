#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pliant/contact/surface_contact.h"
#include "pliant/scene/scene.h"
#include "pliant/scene/scene_crossings.h"

namespace pliant {

/// All cloth of a scene, and its bodies of triangles, as they meet.
struct SceneSurfaces {
  Eigen::Matrix3Xd positions;  ///< of all points of the system, those of bodies last (m)
  Eigen::Matrix3Xi faces;      ///< of all cloth
  const std::vector<BodyPiece>& bodies;
  std::vector<bool> moves;     ///< whether a point is not prescribed
  Eigen::VectorXd masses;      ///< kg, one a point
  Eigen::VectorXd resistance;  ///< of the cloth around each point to stretch, at rest (N/m)
  double shortest_edge = 0;    ///< of cloth at rest, m
};

/// The contact of cloth with bodies of triangles, and where the scene states a friction of cloth on
/// cloth, with itself and other cloth; null where it meets neither. The barrier of a point is as
/// stiff as would stop its mass within a few steps in time, and a share of its cloth's resistance
/// to stretch.
/// @param warnings  gets how many pairs begin nearer than the thickness
/// @throws InputError where cloth begins passing through what it meets, or for a thickness of half
///         an edge and more where it meets cloth
std::shared_ptr<SurfaceContact> surface_contact(const Scene& scene, const SceneSurfaces& surfaces,
                                                std::vector<std::string>& warnings);

}  // namespace pliant
