#pragma once

#include <optional>

#include "pliant/mechanics/air_drag.h"
#include "pliant/solver/integration.h"
#include "pliant/solver/led_motion.h"
#include "pliant/solver/newton.h"

namespace pliant {

struct TimeStepOptions {
  double step = 0.001;  ///< s, > 0
  Integrator integrator = Integrator::backward_euler;
  StepSolve solve = StepSolve::iterated;
  double tolerance = 1e-5;         ///< largest force left by a converged step (N)
  double motion_tolerance = 3e-5;  ///< an iterated step ends where no point moves further (m)
  double linear_tolerance = 1e-4;  ///< relative, of the equations of a linearised step
  bool mend_growth = true;         ///< a linearised step that gains energy is solved once more
  std::optional<Air> air;          ///< vacuum when absent
  Schedule schedule = {};          ///< what comes from outside; nothing where empty
};

/// How a time step went.
struct StepSummary {
  bool converged = true;  ///< the linear solve, the search for less energy, or Newton's method
  bool has_room = true;   ///< false: bodies that are led meet where points are
  bool gained = false;  ///< backward Euler only: what meets something has more energy, nothing led
  int newton_iterations = 1;
  int linear_iterations = 0;
  double residual = 0;     ///< largest force left (N); unless converged, that of the linear system
  double work = 0;         ///< done against friction and damping during the step (J)
  double drag = 0;         ///< done against the air (J)
  double rubbing = 0;      ///< of the work, against the friction of contacts (J)
  double outside = 0;      ///< done by what is led from outside (J)
  SearchCosts costs = {};  ///< without what the phases do not name
};

/// Steps a system through time by minimising its incremental potential: |x - x^|^2_M / (2 t^2) plus
/// the potentials, x^ being where inertia alone would lead.
///
/// Friction history and all other memory changes when a step is accepted, at its end.
class TimeStepper {
 public:
  /// @param faces  points of the triangles that the air acts on
  /// @throws AssertionError for a step of 0 or a free point without mass
  TimeStepper(const System& system, const TimeStepOptions& options, Eigen::Matrix3Xi faces = {});
  ~TimeStepper();

  /// Takes one step, of the options' size or another.
  /// @throws SolverError when the result is not finite; `state` is then as it was
  StepSummary advance(State& state) { return advance(state, options_.step); }
  StepSummary advance(State& state, double step);
  /// The same from one state to another, whose memory is used again.
  /// @param to  not `from`; where the step came to, also where it does not converge: its places and
  ///            time tell what is in its way. Without meaning after a SolverError
  StepSummary advance(const State& from, double step, State& to);

 private:
  struct Scheme;  // the weights of the step's formula

  struct Trial;  // a step before it is accepted
  struct Begin {
    Configuration at;
    Eigen::VectorXd way;  // the change of the unknowns since the last step
  };

  std::optional<Begin> beginning(const Objective& objective, const Configuration& end) const;

  StepSummary linearized(const Trial& trial, Configuration at, State& to);
  StepSummary searched(const Trial& trial, LedMotion led, Configuration at, State& to);
  StepSummary searched_at(const Trial& trial, Configuration& at);
  StepSummary searched_from(const Trial& trial, const Eigen::VectorXd& guess, double most_energy,
                            Configuration& at);
  double settle(const Trial& trial, Configuration at, State& to, StepSummary& summary) const;

  const System& system_;
  TimeStepOptions options_;
  Eigen::Matrix3Xi faces_;
  Workspace workspace_;
};

}  // namespace pliant
