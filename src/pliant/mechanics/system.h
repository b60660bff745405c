#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "pliant/mechanics/coordinates.h"
#include "pliant/mechanics/parametric_potential.h"
#include "pliant/mechanics/potential.h"
#include "pliant/mechanics/state.h"

namespace pliant {

/// A mechanical system: points with mass, their generalised coordinates, and the potentials that
/// they feel.
///
/// Made in three steps: construct it, add clips, prescribed points, potentials and drives, then
/// `finish` it; from then on it does not change except through what a drive or a parameter sets.
/// All that changes from step to step is in a State.
class System {
 public:
  /// Sets what comes from outside at a time (s): prescribed positions and poses in the
  /// configuration, ends of cords, forces.
  using Drive = std::function<void(double time, Configuration& configuration)>;

  /// @param positions  m, one column a point
  /// @param masses     kg, one a point; zero is allowed in statics
  System(Eigen::Matrix3Xd positions, Eigen::VectorXd masses);
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  Coordinates& coordinates() { return coordinates_; }
  const Coordinates& coordinates() const { return coordinates_; }
  void add(std::shared_ptr<Potential> potential);
  void add_drive(Drive drive) { drives_.push_back(std::move(drive)); }
  void finish();

  /// How many threads an evaluation may use; its results do not depend on it.
  void set_threads(int threads) { threads_ = threads; }

  int points() const { return static_cast<int>(masses_.size()); }
  const Eigen::VectorXd& masses() const { return masses_; }

  /// At rest where the points were put, brought there from the rest shape.
  State initial_state() const;
  /// Applies the drives of a time.
  void drive(double time, Configuration& configuration) const;

  /// Where the history of a potential of the system begins in that of a state.
  const double* history_of(const Potential& potential, const State& state) const;

  /// A Hessian of the right pattern, zero.
  Hessian make_hessian() const;

  /// Adds the energy and the derivatives of all potentials.
  /// @param from  what the potentials remember
  void evaluate(const Configuration& at, const State& from, const StepTime& time,
                Curvature curvature, Derivatives& derivatives) const;

  /// Ends a step from `from` at `at`.
  /// @param history  from then on; not that of `from`
  /// @return the work done during the step against friction and damping (J)
  double advance_history(const Configuration& at, const State& from, const StepTime& time,
                         Eigen::VectorXd& history) const;

  /// @name Parameters of the material
  /// @{
  int parameter_count() const { return parameter_count_; }
  /// Derivatives are by all of them until some are chosen.
  void set_parameter_count(int count);
  void set_parameters(const Eigen::VectorXd& values);
  /// Takes the derivatives below by these parameters alone, in this order.
  void differentiate_by(const std::vector<int>& parameters);
  int derivative_count() const { return derivative_count_; }
  /// Adds d gradient / d parameters at fixed positions (3 points x chosen parameters).
  void add_force_sensitivity(const Configuration& at, const State& from,
                             const Eigen::MatrixXd& history_by_parameter,
                             Eigen::MatrixXd& gradient_by_parameter) const;
  /// Carries d history / d parameters over an accepted step that ended at `at`.
  void advance_sensitivity(const Configuration& at, const State& from,
                           const Eigen::MatrixXd& positions_by_parameter,
                           Eigen::MatrixXd& history_by_parameter) const;
  /// @}

 private:
  struct Part {
    std::shared_ptr<Potential> potential;
    const HistoryPotential* with_history = nullptr;  // the same, where it has
    ParametricPotential* parametric = nullptr;       // the same, where it is
    Eigen::Index first_history = 0;
    Eigen::Index history_size = 0;
  };

  Evaluation evaluation(const Part& part, const Configuration& at, const State& from,
                        const StepTime& time, Curvature curvature) const {
    return {at, from.history.data() + part.first_history, time, curvature, threads_};
  }

  Eigen::VectorXd masses_;
  Coordinates coordinates_;
  Configuration initial_;
  std::vector<Part> parts_;
  std::vector<Drive> drives_;
  std::shared_ptr<const BlockPattern> pattern_;
  Eigen::Index history_size_ = 0;
  int parameter_count_ = 0, derivative_count_ = 0;
  int threads_ = 1;
};

}  // namespace pliant
