#pragma once

#include <optional>
#include <vector>

#include "pliant/material/material.h"
#include "pliant/measurement/session.h"
#include "pliant/mechanics/cloth_potentials.h"
#include "pliant/mechanics/system.h"

namespace pliant {

/// The nodes of a session's rest mesh that do not move freely: those in clips, and those on the
/// table where it reaches to `edge` (m, rest plane).
std::vector<int> held_nodes(const Session& session, const std::optional<double>& edge);

/// The sheet of a session as a mechanical system: its material and its weight on the rest mesh,
/// with some nodes held. The session's frames say where those are ([T] 3.4.1). Constant: any number
/// of threads may look for its equilibria.
class SheetSystem {
 public:
  /// @param session   on the mesh that is simulated; outlives the system
  /// @param material  complete; its stiffness goes on beyond its range
  SheetSystem(const Session& session, const Material& material, const DensityOptions& options,
              std::vector<int> held);

  const System& system() const { return system_; }
  bool has_clips() const { return !session_.clips.empty(); }
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// The strains of a component in all elements that measure it, the nodes being at `positions`.
  std::vector<double> strains(const std::string& component,
                              const Eigen::Matrix3Xd& positions) const;

  /// Largest force that an equilibrium leaves on a node: 10 uN ([T] 3.4.1), but never more than a
  /// thousandth of what a node weighs, without which a fine mesh would not notice gravity (N).
  double tolerance() const;

  /// Held nodes where a frame has them.
  Controls controls(int frame) const;
  /// Held nodes move evenly from frame to frame. Frame f is at the time f + 1; at the time 0 the
  /// sheet lies at rest. The sheet outlives the schedule.
  Schedule schedule() const;
  /// `start` with the held nodes where a frame has them.
  Configuration configuration(int frame, Eigen::Matrix3Xd start) const;

  /// Forces that hold each clip: of the cloth and the weights of cloth and clip, as its cords give
  /// them (N, one column a clip).
  /// @param gradient  dE / d points at an equilibrium
  Eigen::Matrix3Xd clip_forces(const Eigen::Matrix3Xd& gradient) const;
  /// Their derivatives (3 clips x parameters) from those of the forces (3 points x parameters).
  Eigen::MatrixXd clip_forces_by_parameter(const Eigen::MatrixXd& forces) const;
  /// Moments of the same about the middle of each clip's vertices, where its weight acts (N m, one
  /// column a clip).
  Eigen::Matrix3Xd clip_moments(const Eigen::Matrix3Xd& positions,
                                const Eigen::Matrix3Xd& gradient) const;

 private:
  /// What a metric of solids shows of each triangle, or values it shows.
  std::vector<double> metric_strains(const std::string& metric,
                                     const Eigen::Matrix3Xd& positions) const;
  /// Of the held nodes in a frame: clamped ones where the pose of their clip puts them, those on
  /// the table where they rest (m, one column each); at rest for frame -1.
  Eigen::Matrix3Xd places(int frame) const;
  Controls controls(const Eigen::Matrix3Xd& places) const;

  const Session& session_;
  std::vector<int> held_;
  std::vector<int> clip_of_held_;  // -1: on the table
  System system_;
  std::vector<ShownPotential> shown_;
  std::vector<std::string> warnings_;
};

}  // namespace pliant
