#pragma once

#include "pliant/mechanics/potential.h"

namespace pliant {

/// Air that faces move through.
struct Air {
  double drag = 0;                                 ///< drag coefficient, dimensionless
  double density = 1.2;                            ///< kg/m^3
  Eigen::Vector3d wind = Eigen::Vector3d::Zero();  ///< m/s
};

/// Drag of the air during one time step: a face of area A that moves against the air with v_n along
/// its normal n feels the force -drag density A |v_n| v_n / 2 along n.
///
/// Normal, area and |v_n| are those at the start of the step, which makes the force linear in the
/// velocity and the derivative of a convex potential.
class AirDrag : public Potential {
 public:
  /// @param faces       points of the faces, one column each
  /// @param start       positions that the step's velocity is counted from, m
  /// @param velocities  at the start of the step, m/s
  /// @param time        (position - start) / time is the velocity at the end of the step, s
  AirDrag(const Air& air, const Eigen::Matrix3Xi& faces, const Eigen::Matrix3Xd& start,
          const Eigen::Matrix3Xd& velocities, double time);

  std::vector<std::pair<int, int>> couplings() const override { return {}; }
  void bind(const Coordinates&, const BlockPattern&) override {}
  void evaluate(const Evaluation& at, Derivatives& derivatives) const override;

  /// Work that a step between two configurations does against the air (J).
  double work(const Configuration& from, const Configuration& to) const;

 private:
  // How far a corner of a face is from where the air would have taken it, along the normal.
  double way(Eigen::Index face, int corner, const Configuration& at) const {
    return normals_.col(face).dot(at.positions.col(faces_(corner, face))) -
           targets_(3 * face + corner);
  }

  const Eigen::Matrix3Xi& faces_;
  Eigen::Matrix3Xd normals_;
  Eigen::VectorXd stiffness_;  // of each corner against its target along the normal, N/m
  Eigen::VectorXd targets_;    // along the normal: one number a corner, m
};

}  // namespace pliant
