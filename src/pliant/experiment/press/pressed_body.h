#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pliant/contact/obstacle_contact.h"
#include "pliant/experiment/press/touching_area.h"
#include "pliant/geometry/volume_mesh.h"
#include "pliant/mechanics/solid_potentials.h"

namespace pliant {

/// A body that is held somewhere, and a rigid plane or sphere that is led against it.
struct PressSetup {
  VolumeMesh mesh;
  std::vector<int> held;                              ///< nodes, rising
  Eigen::Vector3d direction{0, 0, -1};                ///< in which the indenter moves; unit length
  std::optional<double> radius;                       ///< of a sphere (m); absent: a plane
  Eigen::Vector3d through = Eigen::Vector3d::Zero();  ///< a place on the way of a sphere's centre
};

/// Nodes of a mesh that an indenter can touch: those of its surface that are not held.
std::vector<int> nodes_to_touch(const PressSetup& setup);

/// Area of the surface that an indenter can touch, at rest (m^2).
double area_to_touch(const PressSetup& setup);

/// How far the indenter's surface is along its direction where it first touches a node at rest (m):
/// of a plane from the origin, of a sphere's centre from `through`.
/// @return nothing where a sphere passes beside the body
std::optional<double> first_touch(const PressSetup& setup);

/// The system of a pressed body: elastic, held, and kept out of the indenter without friction.
///
/// The indenter is drawn back by the distance at which its barrier begins, 1/5000 of an edge, so
/// that it pushes from where the surfaces touch at rest: travel 0.
class PressedBody {
 public:
  /// @param setup     outlives it; its indenter meets the body
  /// @param pressure  of the size that is to be expected (Pa): what the barrier's stiffness is made
  ///                  for
  PressedBody(const PressSetup& setup, const SolidLaw& law, double pressure);

  const System& system() const { return system_; }
  /// Whether its law does.
  bool remembers() const { return remembers_; }
  const Eigen::Vector3d& direction() const { return setup_.direction; }
  /// Length of an edge of the surface (m).
  double edge() const { return edge_; }
  double extent() const { return extent_of(setup_.mesh); }
  /// Where nothing is touched and no place counts as touching (m, < 0).
  double clear_travel() const { return -(thickness_ + fading_); }
  /// Forces on nodes that leave an equilibrium one (N).
  double tolerance() const { return tolerance_; }

  Controls controls(double travel) const;
  SmoothedArea area(const Eigen::Matrix3Xd& positions, double travel) const;
  /// Force with which the body holds the indenter back (N).
  double force(const Evaluation& at) const;
  /// How dE / d points changes with the travel at fixed points (N/m, one column a point).
  Eigen::Matrix3Xd change_by_travel(const Evaluation& at) const {
    return contact_->change_by_motion(at, setup_.direction);
  }
  const HistoryPotential& contact() const { return *contact_; }

 private:
  const PressSetup& setup_;
  Eigen::Matrix3Xi triangles_;  // of the surface
  bool remembers_;
  double edge_, thickness_, fading_, tolerance_;
  ObstacleShape indenter_;
  System system_;
  std::shared_ptr<ObstacleContact> contact_;
};

}  // namespace pliant
