#pragma once

#include <optional>
#include <vector>

#include "pliant/experiment/body_path_options.h"
#include "pliant/experiment/moved_body/body_setup.h"
#include "pliant/solver/objective.h"
#include "pliant/solver/workspace.h"

namespace pliant {

/// An equilibrium of a body that is moved.
struct BodyPoint {
  Eigen::Matrix3Xd positions;      ///< of the nodes (m)
  Eigen::Vector3d force{0, 0, 0};  ///< that moves it (N)
  Eigen::MatrixXd positions_by;    ///< 3 nodes x chosen parameters
  Eigen::MatrixXd force_by;        ///< 3 x chosen parameters
};

/// Equilibria of a body that remembers, one after the other.
class MovedBodyPath {
 public:
  /// From the body at rest. `body` outlives it.
  MovedBodyPath(const HeldBody& body, BodyPathOptions options);

  /// @param guess  nodes of an equilibrium that is near; null: none is known
  /// @return nothing where no equilibrium is found; the path is then of no more use
  std::optional<BodyPoint> go_to(const Eigen::Vector3d& shift,
                                 const Eigen::Matrix3Xd* guess = nullptr);

 private:
  std::optional<Configuration> equilibrium(Configuration guess, const Eigen::Vector3d& shift);
  std::optional<BodyPoint> step(const Eigen::Vector3d& shift, int halvings);
  std::optional<BodyPoint> accept(const Configuration& at, const Eigen::Vector3d& shift);
  bool differentiate(const Objective& objective, const Configuration& at, BodyPoint& point);

  const HeldBody& body_;
  BodyPathOptions options_;
  Workspace workspace_;
  State state_;
  Eigen::MatrixXd history_by_;
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero();
};

}  // namespace pliant
