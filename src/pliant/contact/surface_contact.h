#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "pliant/contact/near_pairs.h"
#include "pliant/contact/touching.h"
#include "pliant/mechanics/potential.h"

namespace pliant {

/// A body of triangles that cloth meets.
struct ContactBody {
  int first_point = 0;  ///< of the system
  double friction = 0;  ///< coefficient, of cloth on it
};

/// How surfaces that meet push and rub.
struct SurfaceContactLaw {
  double thickness = 0;                  ///< distance at which the barrier begins (m)
  double friction = 0;                   ///< coefficient, of cloth on cloth
  std::vector<ContactBody> bodies = {};  ///< their points stand behind all others, in this order
};

/// Surfaces that keep each other out, and rub against each other: cloth against itself, other cloth
/// and bodies of triangles that are led.
///
/// A barrier acts between a vertex and a face, and between two edges, that are nearer to each other
/// than a thickness; edges that are nearly parallel are left to their ends' vertices. No pair meets
/// on a way that `limit` leaves. Friction is Coulomb's, with the pairs, normals and normal forces
/// that the step begins with: elastic up to `kSlipLength` in a step.
class SurfaceContact : public HistoryPotential {
 public:
  /// @param built      all points of the system, with edges as long as they usually are (m)
  /// @param stiffness  of the barrier, one a point that is of no body: pairs have the mean of
  ///                   theirs (N/m)
  SurfaceContact(std::shared_ptr<const ContactSurface> surface, Eigen::Matrix3Xd built,
                 Eigen::VectorXd stiffness, const SurfaceContactLaw& law);
  ~SurfaceContact() override;

  std::vector<std::pair<int, int>> couplings() const override { return {}; }
  void bind(const Coordinates&, const BlockPattern&) override {}
  /// What would meet goes on together: with what is led, else with that which goes furthest.
  bool make_way(const Evaluation& at, Eigen::Matrix3Xd& positions) const override;
  bool obstructs() const override { return true; }
  void limit(const Evaluation& from, const Eigen::Matrix3Xd& to, WayLimits& limits) const override;
  void evaluate(const Evaluation& at, Derivatives& derivatives) const override;

  /// Where all points were at the last accepted step.
  Eigen::Index history_size() const override { return built_.size(); }
  Eigen::VectorXd initial_history(const Evaluation& at) const override;
  Energy advance(const Evaluation& at, double* next) const override;

  /// Pairs nearer than the thickness, and the least distance of those: of cloth with cloth first,
  /// then of cloth with each body.
  std::vector<Touching> touching(const Eigen::Matrix3Xd& positions) const;

 private:
  struct Rubbing;
  struct Lagged;
  struct Push;

  double stiffness_of(const SurfacePair& pair) const;
  size_t met_by(const SurfacePair& pair) const;
  double friction_of(const SurfacePair& pair) const;
  Eigen::Vector3d common_way(const SurfacePair& pair, const Eigen::Matrix3Xd& start,
                             const Eigen::Matrix3Xd& ways) const;
  double free_share_of(const SurfacePair& pair, const Eigen::Matrix3Xd& from,
                       const Eigen::Matrix3Xd& ways, double kept) const;
  Push push_of(const SurfacePair& pair, const Eigen::Matrix3Xd& positions) const;
  /// Of all pairs that push, in their order.
  std::vector<std::pair<SurfacePair, Push>> pushes_at(const Eigen::Matrix3Xd& positions,
                                                      SearchCosts* costs) const;
  void add_push(const SurfacePair& pair, const Push& push, const Evaluation& at,
                Derivatives& derivatives) const;
  void add_friction(const Rubbing& rubbing, const Evaluation& at, Derivatives& derivatives) const;
  std::shared_ptr<const Lagged> lagged(const Evaluation& at) const;

  NearPairs near_;
  Eigen::Matrix3Xd built_;
  Eigen::VectorXd stiffness_;
  SurfaceContactLaw law_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const Lagged> lagged_;  // the last that was made
};

}  // namespace pliant
