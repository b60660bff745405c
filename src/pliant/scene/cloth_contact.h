#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pliant/contact/surface_contact.h"
#include "pliant/scene/scene.h"

namespace pliant {

/// All cloth of a scene as other cloth sees it.
struct ClothSurface {
  Eigen::Matrix3Xd positions;  ///< of all points of the system (m)
  Eigen::Matrix3Xi faces;
  std::vector<bool> moves;     ///< whether a point is not prescribed
  Eigen::VectorXd masses;      ///< kg, one a point
  Eigen::VectorXd resistance;  ///< of the cloth around each point to stretch, at rest (N/m)
  double shortest_edge = 0;    ///< at rest, m
};

/// The contact of cloth with itself and with other cloth. The barrier of a point is as stiff as
/// would stop its mass within a few steps in time, and a share of its cloth's resistance to
/// stretch.
/// @param scene     with a friction of cloth on cloth
/// @param warnings  gets how many pairs begin nearer than the thickness
/// @throws InputError where cloth begins passing through cloth, or for a thickness of half an edge
///         and more
std::shared_ptr<SurfaceContact> cloth_contact(const Scene& scene, const ClothSurface& cloth,
                                              std::vector<std::string>& warnings);

}  // namespace pliant
