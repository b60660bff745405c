#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pliant/mechanics/controls.h"
#include "pliant/mechanics/coordinates.h"
#include "pliant/mechanics/parameters.h"
#include "pliant/mechanics/parametric_potential.h"
#include "pliant/mechanics/potential.h"
#include "pliant/mechanics/state.h"

namespace pliant {

/// What a system is evaluated under besides where it is. The parts outlive it.
struct Conditions {
  const State& from;  ///< whose history the potentials remember
  const Parameters& parameters = kAsBuilt;
  const Controls& controls = kNoControls;
  StepTime time = {};
  SearchCosts* costs = nullptr;  ///< where they are counted; null: nowhere
};

/// A mechanical system: points with mass, their generalised coordinates, and the potentials that
/// they feel.
///
/// Made in three steps: construct it, add clips, prescribed points and potentials, then `finish`
/// it. From then on it is constant, and serves any number of threads: parameters and what comes
/// from outside are given with each evaluation, all that changes from step to step is in a State,
/// and room for Hessians and their factors belongs to the solvers.
class System {
 public:
  /// @param positions  m, one column a point
  /// @param masses     kg, one a point; zero is allowed in statics
  System(Eigen::Matrix3Xd positions, Eigen::VectorXd masses);
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  Coordinates& coordinates() { return coordinates_; }
  const Coordinates& coordinates() const { return coordinates_; }
  void add(std::shared_ptr<Potential> potential);
  /// @return where the parameters stand among those of the system
  std::vector<int> add_parameters(const std::vector<std::string>& names,
                                  const Eigen::VectorXd& values);
  void finish();

  int points() const { return static_cast<int>(masses_.size()); }
  const Eigen::VectorXd& masses() const { return masses_; }

  const ParameterList& parameters() const { return parameters_; }
  /// The numbers of all parameters.
  std::vector<int> all_parameters() const;
  /// @param values  of all parameters, in the order of `parameters()`
  Parameters with(const Eigen::VectorXd& values) const;

  /// At rest where the points were put, brought there from the rest shape.
  State initial_state(const Parameters& parameters = kAsBuilt) const;

  /// Where the history of a potential of the system begins in that of a state.
  const double* history_of(const Potential& potential, const State& state) const;

  /// A Hessian of the right pattern, zero.
  Hessian make_hessian(Precision precision = Precision::full) const;

  /// How far each point has to move before a step begins, so that nothing that is led from outside
  /// has passed it (m); nothing where there is no room.
  /// @param led  where the last step ended, but for points that are led: those may be where they go
  std::optional<Eigen::Matrix3Xd> made_way(const Eigen::Matrix3Xd& led,
                                           const Conditions& under) const;
  /// Whether anything may be in a point's way.
  bool obstructs() const;
  /// Whether energies of it have a limit.
  bool is_limited() const;
  /// The least share of their limits that limited energies are below them; below 0 beyond.
  double share_left(const Configuration& at, const Conditions& under) const;
  /// How much of its straight way each point may go at once.
  /// @param kept  share of its distance that what comes near something keeps
  WayLimits way_limits(const Configuration& from, const Configuration& to, const Conditions& under,
                       double kept) const;
  /// What bodies, forces and cords do to it during a step that ends at `at` (J).
  /// @param before  what came from outside where the step began
  double outside_work(const Configuration& at, const Conditions& under,
                      const Controls& before) const;
  /// Adds the energy and the derivatives of all potentials.
  void evaluate(const Configuration& at, const Conditions& under, Curvature curvature,
                Derivatives& derivatives) const;

  /// Ends a step at `at`.
  /// @param history  from then on; not that of `under.from`
  /// @return what is stored at `at`, and the work done during the step against friction and damping
  Energy advance_history(const Configuration& at, const Conditions& under,
                         Eigen::VectorXd& history) const;

  /// @name Derivatives by some of the parameters of the material, in statics
  /// @{
  /// Adds d gradient / d parameters at fixed positions (3 points x by).
  void add_force_sensitivity(const Configuration& at, const Conditions& under,
                             const std::vector<int>& by,
                             const Eigen::MatrixXd& history_by_parameter,
                             Eigen::MatrixXd& gradient_by_parameter) const;
  /// Carries d history / d parameters over an accepted step that ended at `at`.
  void advance_sensitivity(const Configuration& at, const Conditions& under,
                           const std::vector<int>& by,
                           const Eigen::MatrixXd& positions_by_parameter,
                           Eigen::MatrixXd& history_by_parameter) const;
  /// @}

 private:
  struct Part {
    std::shared_ptr<Potential> potential;
    const HistoryPotential* with_history = nullptr;   // the same, where it has
    const ParametricPotential* parametric = nullptr;  // the same, where it is
    size_t number = 0;
    Eigen::Index first_history = 0;
    Eigen::Index history_size = 0;
  };

  static Evaluation evaluation(const Part& part, const Configuration& at, const Conditions& under,
                               Curvature curvature = Curvature::exact) {
    return {at,
            under.from.history.data() + part.first_history,
            under.parameters.law(part.number),
            under.controls,
            under.time,
            curvature,
            under.costs};
  }

  Eigen::VectorXd masses_;
  Coordinates coordinates_;
  Configuration initial_;
  std::vector<Part> parts_;
  ParameterList parameters_;
  std::shared_ptr<const BlockPattern> pattern_;
  Eigen::Index history_size_ = 0;
};

}  // namespace pliant
