#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/progress.h"
#include "pliant/experiment/session/equilibrium_work.h"
#include "pliant/mechanics/cloth_potentials.h"

namespace pliant {

/// A frame of a session as a material predicts it.
struct SheetShape {
  Eigen::Matrix3Xd positions;    ///< of the nodes (m)
  Eigen::Matrix3Xd clip_forces;  ///< that the cords of each clip pull with, as their load cells
                                 ///< show it (N)

  /// @name Derivatives by chosen parameters: 3 nodes and 3 clips x parameters; empty unless asked
  /// for
  /// @{
  Eigen::MatrixXd positions_by_parameter;
  Eigen::MatrixXd clip_forces_by_parameter;
  /// @}

  Eigen::Matrix3Xd clip_moments;  ///< of the cords about the middle of the clip's vertices (N m)
};

/// A shape between two, of which the second has a share from 0 to 1; with derivatives where the
/// first has them.
SheetShape between(SheetShape first, const SheetShape& second, double share);

/// Predicts the frames of a session with a material whose parameters change, for estimation.
class SheetPredictor {
 public:
  virtual ~SheetPredictor() = default;

  const std::vector<std::string>& parameter_names() const { return parameters_.names; }
  /// Those of the material that it was made with.
  Eigen::VectorXd parameters() const {
    return Eigen::Map<const Eigen::VectorXd>(parameters_.values.data(),
                                             static_cast<Eigen::Index>(parameters_.values.size()));
  }
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// Of all predictions until now; the seconds of threads that work at once are added up. What
  /// differences would have needed is left at zero: that depends on what is unknown.
  const EquilibriumWork& work() const { return work_; }

  /// Each frame, or nothing where no equilibrium of it is found.
  /// @param parameters  one for each of `parameter_names()`
  /// @param by          those that derivatives are wanted by; empty: none are
  virtual std::vector<std::optional<SheetShape>> predict_each(const Eigen::VectorXd& parameters,
                                                              const std::vector<int>& by,
                                                              int threads,
                                                              const StopToken& stop) = 0;

  /// All frames.
  /// @return nothing where one of them has no equilibrium
  std::optional<std::vector<SheetShape>> predict(const Eigen::VectorXd& parameters,
                                                 const std::vector<int>& by, int threads,
                                                 const StopToken& stop);

  /// Where the search for each equilibrium begins when it has not been found before: the positions
  /// of all nodes, or nothing for the measured shape.
  virtual void begin_at(std::vector<Eigen::Matrix3Xd> guesses) { static_cast<void>(guesses); }
  virtual std::vector<Eigen::Matrix3Xd> guesses() const { return {}; }

 protected:
  ParameterList parameters_;
  std::vector<std::string> warnings_;
  EquilibriumWork work_;
};

}  // namespace pliant
