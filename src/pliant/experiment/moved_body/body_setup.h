#pragma once

#include <vector>

#include "pliant/geometry/nearest_on_surface.h"
#include "pliant/geometry/volume_mesh.h"
#include "pliant/mechanics/solid_potentials.h"
#include "pliant/mechanics/system.h"

namespace pliant {

/// A body of which some nodes are held and others are moved along together.
struct BodySetup {
  VolumeMesh mesh;
  std::vector<int> held, moved;  ///< nodes, rising; none in common
};

/// The system of such a body; what is moved has its places from controls.
class HeldBody {
 public:
  /// @param setup  outlives it
  HeldBody(const BodySetup& setup, const SolidLaw& law);

  const BodySetup& setup() const { return setup_; }
  const System& system() const { return system_; }
  /// Forces on nodes that leave an equilibrium one (N).
  double tolerance() const { return tolerance_; }
  /// What is moved by some way (m) from where it is at rest.
  Controls controls(const Eigen::Vector3d& shift) const;
  /// Motions of all nodes in which what is moved goes along x, y and z: 3 nodes x 3.
  Eigen::MatrixXd moves() const;
  /// The force that moves the body, from forces on all nodes (N).
  Eigen::Vector3d force(const Eigen::Matrix3Xd& gradient) const;

 private:
  const BodySetup& setup_;
  System system_;
  double tolerance_;
};

}  // namespace pliant
