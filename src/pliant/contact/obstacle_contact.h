#pragma once

#include <vector>

#include "pliant/contact/coulomb.h"
#include "pliant/contact/obstacle_shape.h"
#include "pliant/mechanics/potential.h"

namespace pliant {

/// Points that a solid body keeps out, and rubs against.
///
/// A barrier acts on each point that is nearer to the surface than a thickness; no point reaches
/// the surface, nor passes through the body during a step. Friction is Coulomb's, with the normal
/// forces and normals that the step begins with: elastic up to `kSlipLength`, of which each point
/// keeps its part from step to step, so that what rests does not creep.
class ObstacleContact : public HistoryPotential {
 public:
  /// @param points     of the system
  /// @param stiffness  of the barrier, one a point (N/m)
  /// @param thickness  distance at which the barrier begins (m)
  ObstacleContact(ObstacleShape shape, std::vector<int> points, Eigen::VectorXd stiffness,
                  double thickness, const CoulombFriction& friction);

  std::vector<std::pair<int, int>> couplings() const override { return {}; }
  void bind(const Coordinates&, const BlockPattern&) override {}
  /// The energy is infinite where `admits` says no.
  void evaluate(const Evaluation& at, Derivatives& derivatives) const override;
  bool admits(const Evaluation& at) const override;

  Eigen::Index history_size() const override;
  Eigen::VectorXd initial_history(const Evaluation& at) const override;
  Energy advance(const Evaluation& at, double* next) const override;

  /// Of all its points (m); negative where one is inside.
  double least_distance(const Eigen::Matrix3Xd& positions) const;

 private:
  struct Memory;

  void evaluate_point(size_t i, const Evaluation& at, Derivatives& derivatives) const;
  bool admits_point(size_t i, const Evaluation& at) const;
  SlipEnergy slip_of(const Memory& memory, const Eigen::Vector3d& position) const;

  ObstacleShape shape_;
  std::vector<int> points_;
  Eigen::VectorXd stiffness_;
  double thickness_;
  CoulombFriction friction_;
};

}  // namespace pliant
