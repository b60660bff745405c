#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// A number that is read off a body at an equilibrium, and how it changes ([T] Eq. 4.10).
struct BodyReadout {
  double value = 0;
  Eigen::Vector3d by_force = Eigen::Vector3d::Zero();         ///< 1/N
  std::vector<std::pair<int, Eigen::Vector3d>> by_node = {};  ///< 1/m; of nodes that it hangs on
};

/// What is measured on a moved body: rows as functions of where the nodes are at an equilibrium and
/// of the force that moves the body. It knows no material: equilibria and their derivatives are the
/// same whatever is measured, ways of marks and forces or intensities of pictures.
class BodyObservable {
 public:
  virtual ~BodyObservable() = default;

  /// @param row        of the experiment
  /// @param positions  of the nodes (m)
  /// @param force      that moves the body (N)
  virtual BodyReadout read(int row, const Eigen::Matrix3Xd& positions,
                           const Eigen::Vector3d& force) const = 0;
};

}  // namespace pliant
