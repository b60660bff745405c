#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/progress.h"
#include "pliant/experiment/session.h"
#include "pliant/experiment/sheet/sheet_states.h"
#include "pliant/material/material.h"

namespace pliant {

/// A frame of a session as a material predicts it.
struct SheetShape {
  Eigen::Matrix3Xd positions;    ///< of the nodes (m)
  Eigen::Matrix3Xd clip_forces;  ///< that the cords of each clip pull with (N)

  /// @name Derivatives by chosen parameters: 3 nodes and 3 clips x parameters; empty unless asked
  /// for
  /// @{
  Eigen::MatrixXd positions_by_parameter;
  Eigen::MatrixXd clip_forces_by_parameter;
  /// @}

  Eigen::Matrix3Xd clip_moments;  ///< of the cords about the middle of the clip's vertices (N m)
};

/// What equilibria have cost.
struct EquilibriumCounts {
  int equilibria = 0;  ///< found
  int iterations = 0;  ///< of Newton's method
  int factors = 0;     ///< of Hessians, derivatives included
  int unstable = 0;    ///< differentiated with a convex stand-in of their Hessian
};

/// The frames of a session as equilibria of an elastic material, each for itself ([T] 3.4.1).
///
/// A search begins where the parameters before have ended, moved along the derivatives there, and
/// at the measured shape where that fails.
class SheetEquilibria {
 public:
  /// @param session   on the mesh that is simulated; outlives this
  /// @param material  complete; friction is left out
  SheetEquilibria(const Session& session, const Material& material);
  ~SheetEquilibria();

  const std::vector<std::string>& parameter_names() const { return names_; }
  const Eigen::VectorXd& parameters() const { return parameters_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  const EquilibriumCounts& counts() const { return counts_; }
  int equilibria_each() const { return static_cast<int>(states_.states.size()); }

  /// Where the search for each equilibrium begins when it has not been found before: nothing, for
  /// the measured shape, or the positions of all nodes.
  void begin_at(std::vector<Eigen::Matrix3Xd> guesses) { guesses_ = std::move(guesses); }
  std::vector<Eigen::Matrix3Xd> guesses() const;

  /// All frames.
  /// @param parameters  one for each of `parameter_names()`
  /// @param by          those that derivatives are wanted by; empty: none are
  /// @return nothing where a frame has no equilibrium
  std::optional<std::vector<SheetShape>> predict(const Eigen::VectorXd& parameters,
                                                 const std::vector<int>& by, int threads,
                                                 const StopToken& stop);

 private:
  class Lane;      // a system with its solver
  struct Reached;  // an equilibrium with its derivatives

  std::unique_ptr<Lane> borrow(const std::vector<int>& held);
  void give_back(std::unique_ptr<Lane> lane);
  /// Shapes to begin a search at, one after the other.
  std::vector<Eigen::Matrix3Xd> starts(int state, const Eigen::VectorXd& parameters) const;
  bool find(int state, Lane& lane, const Eigen::VectorXd& parameters, Eigen::Matrix3Xd start);
  bool find_near_measured(int state, Lane& lane, const Eigen::VectorXd& parameters);
  void differentiate(int state, Lane& lane, const std::vector<int>& by);
  bool reach(int state, const Eigen::VectorXd& parameters, const std::vector<int>& by);
  SheetShape blended(int frame, bool derivatives) const;

  const Session& session_;
  Material material_;
  SheetStates states_;
  std::vector<std::string> names_;
  Eigen::VectorXd parameters_;
  std::vector<std::string> warnings_;
  std::vector<Reached> reached_;
  std::vector<Eigen::Matrix3Xd> guesses_;  // one a state, or none at all
  struct Pool;
  std::unique_ptr<Pool> pool_;
  EquilibriumCounts counts_;
};

}  // namespace pliant
