#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pliant/contact/obstacle_contact.h"
#include "pliant/scene/scene.h"

namespace pliant {

/// Cloth as obstacles see it.
struct TouchingCloth {
  std::vector<int> points;  ///< that move freely, alone or with a clip
  std::vector<int> led;     ///< with an axis or more that is told where to be; rising
  Eigen::Matrix3Xd positions;
  const Eigen::Matrix3Xi& faces;  ///< of all cloth
  Eigen::VectorXd masses;         ///< kg, one a point of the system
  double longest_edge = 0;        ///< at rest, m
};

/// The contacts of a cloth's points with the convex obstacles of a scene, in their order. The
/// barrier of a point is as stiff as would stop its mass within a few time steps: 4 m / step^2.
/// Those that are led have the numbers of bodies in the order in which they stand.
/// @param warnings  gets what faces may do between their vertices
/// @throws InputError where cloth begins inside an obstacle, with a vertex, or between some deeper
/// than where it lies over one
std::vector<std::shared_ptr<ObstacleContact>> obstacle_contacts(const Scene& scene,
                                                                const TouchingCloth& cloth,
                                                                std::vector<std::string>& warnings);

}  // namespace pliant
