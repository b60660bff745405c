#pragma once

#include <optional>
#include <vector>

#include "pliant/base/progress.h"
#include "pliant/experiment/body_path_options.h"
#include "pliant/experiment/press/pressed_body.h"
#include "pliant/experiment/session/equilibrium_work.h"
#include "pliant/solver/newton.h"

namespace pliant {

/// How an equilibrium moves: the body's points (3 points, column-major) and the indenter.
struct PressMotion {
  Eigen::MatrixXd positions_by;  ///< by the chosen parameters, at what was set
  Eigen::RowVectorXd travel_by;  ///< the same; zero where the travel was set
  Eigen::Matrix3Xd positions_by_travel;
  double area_by_travel = 0;  ///< m; of areas alone
};

/// An equilibrium of a pressed body.
struct PressPoint {
  double travel = 0;            ///< of the indenter from where it first touches (m)
  double force = 0;             ///< N
  double area = 0;              ///< that touches, smoothed (m^2)
  Eigen::RowVectorXd force_by;  ///< by the chosen parameters
  PressMotion motion;           ///< where derivatives were wanted, and at areas
};

/// An equilibrium where a path stands, with what is remembered there.
struct PressStand {
  PressPoint point;
  State state;
};

/// The way of an indenter into a body that remembers: equilibria one after the other.
///
/// It goes on in steps of a quarter of an edge at most, which end where all paths have an end, so
/// that what friction remembers depends on the parameters by the given places alone.
class PressPath {
 public:
  /// From the body at rest. `body` outlives it.
  PressPath(const PressedBody& body, BodyPathOptions options);
  PressPath(const PressedBody& body, BodyPathOptions options, Workspace workspace);
  /// From where another path of the body stands, whose law remembers nothing.
  PressPath(const PressedBody& body, BodyPathOptions options, Workspace workspace, PressStand from);

  /// @return nothing where no equilibrium is found; the path is then of no more use
  std::optional<PressPoint> go_to_travel(double travel);
  /// Moves the indenter until a given area touches. The travel depends on the parameters then, and
  /// the force at the given area by F_p - F_s A_p / A_s.
  std::optional<PressPoint> go_to_area(double area);

  /// The equilibrium beside that of other parameters where the path was begun: what is set is the
  /// same, and no steps lead there.
  /// @param change  of the parameters that its motion is by; empty: it is not moved first
  /// @return nothing where none is found in a few iterations; the path then stands where it did
  std::optional<PressPoint> settle_at_travel(const Eigen::VectorXd& change);
  std::optional<PressPoint> settle_at_area(const Eigen::VectorXd& change);

  const Eigen::Matrix3Xd& positions() const { return state_.configuration.positions; }
  PressStand stand() const { return {point_, state_}; }
  const EquilibriumCounts& counts() const { return counts_; }

 private:
  /// An equilibrium that is not accepted.
  struct Trial {
    double travel = 0;
    Configuration at;
    double area = 0;
  };
  std::optional<Trial> trial(double travel);
  std::optional<Trial> trial_near(Configuration guess, double travel, int max_iterations);
  std::optional<Trial> trial_of_stop(double travel);
  std::optional<Trial> trial_from(Configuration guess, double travel, int max_iterations);
  std::optional<Trial> trial_between(const Trial& low, const Trial& high, double travel);
  std::optional<Trial> trial_of_area(double area, Trial low, Trial high);
  std::optional<Trial> trial_by_secants(double area, Configuration guess, double travel);
  std::optional<PressPoint> go_by_secants(double area);
  std::optional<PressPoint> step(double travel, int halvings);
  bool walk(double travel);
  double next_stop(int way) const;
  std::optional<PressPoint> accept(const Trial& trial, std::optional<double> area = {});
  /// @return whether the Hessian there, or its convex stand-in, is positive definite
  bool differentiate(const Trial& trial, const std::optional<double>& area, PressPoint& point);

  const PressedBody& body_;
  BodyPathOptions options_;
  Workspace workspace_;
  State state_;
  Eigen::MatrixXd history_by_;
  double travel_;
  PressPoint point_;  // where it stands
  EquilibriumCounts counts_;
  Trial ahead_;  // of a stop beyond the last area
};

}  // namespace pliant
