#pragma once

#include <vector>

#include "pliant/contact/coulomb.h"
#include "pliant/contact/obstacle_shape.h"
#include "pliant/contact/touching.h"
#include "pliant/mechanics/potential.h"

namespace pliant {

/// Points that a solid body keeps out, and rubs against.
///
/// A barrier acts on each point that is nearer to the surface than a thickness; no point reaches
/// the surface, nor passes through the body on a way that `limit` leaves. Friction is Coulomb's,
/// with the normal forces and normals that the step begins with: elastic up to `kSlipLength`, of
/// which each point keeps its part from step to step, so that what rests does not creep. A body
/// that is led takes along what it meets; what it remembers of a point is in its own frame.
class ObstacleContact : public HistoryPotential {
 public:
  /// @param points     of the system
  /// @param stiffness  of the barrier, one a point (N/m)
  /// @param thickness  distance at which the barrier begins (m)
  /// @param body       its number among the bodies that are led; -1: it stands still
  ObstacleContact(ObstacleShape shape, std::vector<int> points, Eigen::VectorXd stiffness,
                  double thickness, const CoulombFriction& friction, int body = -1);

  std::vector<std::pair<int, int>> couplings() const override { return {}; }
  void bind(const Coordinates&, const BlockPattern&) override {}
  bool make_way(const Evaluation& at, Eigen::Matrix3Xd& positions) const override;
  bool obstructs() const override { return true; }
  /// A point keeps a share of its distance, or of half the thickness; one that slides stops where
  /// it may come to rest.
  void limit(const Evaluation& from, const Eigen::Matrix3Xd& to, WayLimits& limits) const override;
  /// The energy is infinite inside the body.
  void evaluate(const Evaluation& at, Derivatives& derivatives) const override;
  double outside_work(const Evaluation& at, const Configuration& from,
                      const Controls& before) const override;

  Eigen::Index history_size() const override;
  Eigen::VectorXd initial_history(const Evaluation& at) const override;
  Energy advance(const Evaluation& at, double* next) const override;

  /// How dE / d points changes as the body moves on, the points held where they are (N/m, one
  /// column a point of the system). Without friction.
  /// @param direction  of the body's motion, of unit length
  Eigen::Matrix3Xd change_by_motion(const Evaluation& at, const Eigen::Vector3d& direction) const;

  /// Points nearer than the thickness, and the least distance of all, negative inside.
  Touching touching(const Eigen::Matrix3Xd& positions, const Controls& controls) const;

 private:
  struct Memory;

  Memory memory_of(size_t i, const Evaluation& at) const;
  double free_share_of(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double kept) const;
  void evaluate_point(size_t i, const Pose& body, const Evaluation& at,
                      Derivatives& derivatives) const;
  double largest_friction(const Memory& memory) const;  // N
  Eigen::Vector3d slip_of(const Memory& memory, const Eigen::Vector3d& position) const;
  SlipEnergy rubbing(const Memory& memory, const Eigen::Vector3d& position) const;
  double share_to_standstill(const Memory& memory, const Eigen::Vector3d& from,
                             const Eigen::Vector3d& to) const;

  ObstacleShape shape_;
  std::vector<int> points_;
  Eigen::VectorXd stiffness_;
  double thickness_;
  CoulombFriction friction_;
  int body_;
};

}  // namespace pliant
