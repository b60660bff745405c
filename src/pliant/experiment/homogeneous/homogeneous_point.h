#pragma once

#include <optional>

#include <Eigen/Core>

#include "pliant/experiment/homogeneous/homogeneous_rows.h"
#include "pliant/material/density/density.h"

namespace pliant {

/// The nominal stress along 1 at a row.
struct HomogeneousStress {
  double value = 0;           ///< Pa
  Eigen::RowVectorXd by;      ///< d value / d parameters of the law; empty unless asked for
  Eigen::Vector3d stretches;  ///< along the three axes
};

/// A material point of a solid that is deformed along its axes, row after row.
///
/// Stretches along free sides are those that make the energy least: there the stress vanishes. Of
/// an incompressible solid the product of the stretches is one, and the pressure is what makes the
/// stress along 3, which is free in all modes, vanish. Limits of energy hold: barriers are followed
/// down. What the law remembers goes along, with its
/// derivatives by the parameters (forward sensitivities, [T] Eq. 3.7).
class HomogeneousPoint {
 public:
  /// @param law  on six strains; outlives the point
  HomogeneousPoint(const ParametricDensity& law, bool incompressible, bool derivatives);

  /// Goes from where it is to a row and stays there.
  /// @return nothing where no equilibrium of the free sides is found, or the row is beyond a limit
  std::optional<HomogeneousStress> move_to(const HomogeneousRow& row);

 private:
  struct Response3;
  struct Free;

  Response3 respond(const Eigen::Vector3d& logs) const;
  std::optional<Eigen::Vector3d> equilibrium(const Free& free);
  std::optional<Eigen::Vector3d> within_limits(const Free& free);
  std::optional<Eigen::VectorXd> search(const Free& free, Eigen::VectorXd at) const;
  double share_left(const Eigen::Vector3d& logs) const;
  HomogeneousStress stress_of(const Free& free, const Eigen::Vector3d& logs);
  void advance(const Eigen::Matrix<double, 6, 1>& strain);

  const ParametricDensity& law_;
  bool incompressible_;
  bool derivatives_;
  LimitBarrier limits_;
  double seconds_ = 0;                // that the way to the present row takes
  Eigen::Matrix<double, 6, 1> last_;  // strain
  Eigen::VectorXd history_;
  Eigen::MatrixXd last_by_, history_by_;  // by the parameters
};

}  // namespace pliant
