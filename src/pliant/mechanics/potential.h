#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "pliant/material/density/density.h"
#include "pliant/math/block_matrix.h"
#include "pliant/mechanics/controls.h"
#include "pliant/mechanics/coordinates.h"
#include "pliant/mechanics/search_costs.h"

namespace pliant {

/// Energy in two parts: what positions alone decide, and work done since the last accepted step
/// against friction, damping and drag.
struct Energy {
  double stored = 0;   ///< J
  double work = 0;     ///< J
  double contact = 0;  ///< of what is stored, in contacts
  double rubbing = 0;  ///< of the work, against the friction of contacts

  double total() const { return stored + work; }
  Energy& operator+=(const Energy& other) {
    stored += other.stored;
    work += other.work;
    contact += other.contact;
    rubbing += other.rubbing;
    return *this;
  }
  void add_contact(double energy) {
    stored += energy;
    contact += energy;
  }
  void add_rubbing(double energy) {
    work += energy;
    rubbing += energy;
  }
};

/// What second derivatives an evaluation gives.
enum class Curvature {
  exact,   ///< may be indefinite
  convex,  ///< a positive semidefinite stand-in, element by element
};

/// Where a potential is evaluated, and under what.
struct Evaluation {
  const Configuration& configuration;
  const double* history = nullptr;         ///< of the potential, at the last accepted step
  const ParametricDensity* law = nullptr;  ///< of the potential; null: the one that it has itself
  const Controls& controls = kNoControls;
  StepTime time = {};
  Curvature curvature = Curvature::exact;
  SearchCosts* costs = nullptr;  ///< where they are counted; null: nowhere
};

/// Second derivatives in a system's generalised coordinates (N/m).
struct Hessian {
  const Coordinates& coordinates;
  BlockMatrix matrix;
};

/// What an evaluation adds to; parts that are null are not asked for.
struct Derivatives {
  Energy energy;
  Eigen::Matrix3Xd* gradient = nullptr;  ///< N, one column a point
  Hessian* hessian = nullptr;
};

/// How much of their straight ways points may go at once.
struct WayLimits {
  Eigen::VectorXd shares;   ///< of the ways, one a point, in [0, 1]; only ever lowered
  bool obstructed = false;  ///< something in the way keeps a point from where it would go
  double kept = 0;          ///< share of its distance that what comes near something keeps
};

/// An energy of the points of a system: elasticity, friction, gravity, inertia of a time step, ...
///
/// It may keep a history, numbers that change at accepted steps only; the system's State holds
/// them. Once bound it is constant, and evaluated by several threads at once.
class Potential {
 public:
  virtual ~Potential() = default;

  /// Pairs of points that its Hessian couples.
  virtual std::vector<std::pair<int, int>> couplings() const = 0;

  /// Learns where its part of the Hessian goes; called before any evaluation.
  virtual void bind(const Coordinates& coordinates, const BlockPattern& pattern) = 0;

  /// Moves points out of the way of what is led from outside: to where the step may begin.
  /// @param at         its configuration: of the last accepted step
  /// @param positions  to be moved; what is led, and others before, may have moved some (m)
  /// @return false where it found no room
  virtual bool make_way(const Evaluation& at, Eigen::Matrix3Xd& positions) const {
    static_cast<void>(at), static_cast<void>(positions);
    return true;
  }

  /// Whether it ever shortens ways.
  virtual bool obstructs() const { return false; }

  /// Shortens the straight ways of points to what each may go at once.
  /// @param to  where the points of `from` would go
  virtual void limit(const Evaluation& from, const Eigen::Matrix3Xd& to, WayLimits& limits) const {
    static_cast<void>(from), static_cast<void>(to), static_cast<void>(limits);
  }

  /// Whether energies of it have a limit ([T] Eq. 4.5).
  virtual bool is_limited() const { return false; }

  /// The least share of their limits that limited energies are below them; below 0 beyond.
  virtual double share_left(const Evaluation& at) const {
    static_cast<void>(at);
    return 1;
  }

  /// Adds to the energy and to the derivatives that are asked for. The energy is infinite where
  /// points must not be.
  virtual void evaluate(const Evaluation& at, Derivatives& derivatives) const = 0;

  /// Work that what comes from outside, other than points and clips, does by it during a step (J):
  /// bodies that are led against the forces of the step's end, forces and ends of cords that change
  /// where it began.
  /// @param at      the end of the step
  /// @param from    where it began, with `before` from outside
  virtual double outside_work(const Evaluation& at, const Configuration& from,
                              const Controls& before) const {
    static_cast<void>(at), static_cast<void>(from), static_cast<void>(before);
    return 0;
  }
};

/// By how much the energy of a potential without history changes at a place when what comes from
/// outside does (J).
double energy_by_controls(const Potential& potential, const Configuration& at,
                          const Controls& before, const Controls& now);

/// A potential whose value depends on the path.
class HistoryPotential : public Potential {
 public:
  virtual Eigen::Index history_size() const = 0;
  /// The history of a body that was brought from its rest shape to `at.configuration`, each strain
  /// on the straight way, and stands still.
  virtual Eigen::VectorXd initial_history(const Evaluation& at) const = 0;
  /// The history after a step that is accepted at `at.positions`.
  /// @param next  `history_size()` numbers; not `at.history`
  /// @return what is stored then, and the work done during the step against friction and damping
  virtual Energy advance(const Evaluation& at, double* next) const = 0;
};

}  // namespace pliant
