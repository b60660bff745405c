#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/material/component_law.h"
#include "pliant/solver/elastica/gauss_line.h"
#include "pliant/solver/elastica/line_factor.h"
#include "pliant/solver/elastica/strip_profile.h"

namespace pliant {

/// How a strip is held. It leaves its clamp, the origin, in the direction `clamp_angle` against +x;
/// gravity pulls along -y. What is not given of the far end is free.
struct StripEnds {
  double clamp_angle = 0;           ///< rad
  std::optional<double> far_angle;  ///< rad, counted on from the clamp's
  std::optional<double> far_x;      ///< m
  std::optional<double> far_y;      ///< m
};

/// What the material points of a strip remember of their path, one a point of the line, with the
/// derivatives by the parameters (columns: those of the law, then the weight).
struct StripHistory {
  Eigen::VectorXd curvature;  ///< 1/m
  Eigen::VectorXd friction;   ///< friction stress (N)
  Eigen::MatrixXd curvature_by_parameter;
  Eigen::MatrixXd friction_by_parameter;
  /// What the law's addends remember, a row a point, one after the other; no columns: nothing.
  Eigen::MatrixXd memory;
  std::vector<Eigen::MatrixXd> memory_by_parameter;  ///< of each point, a row a number
};

/// An equilibrium of a strip. Its derivatives are empty unless asked for.
struct StripShape {
  Eigen::VectorXd curvature;  ///< 1/m, at the points of the line
  Eigen::Vector3d far_load =
      Eigen::Vector3d::Zero();  ///< force x, y (N/m) and moment (N) that hold the far end
  Eigen::MatrixXd curvature_by_parameter;
  Eigen::MatrixXd far_load_by_parameter;
  bool jumps = false;  ///< its curvature does, at one front (see settle_fronts)
};

/// A strip bent in a plane under its own weight; everything is per width. The moment at a point is
/// M = k(eps) eps + sigma with eps = 3 kappa ([P] 4.3); it does not stretch or touch itself.
///
/// The curvatures at the points of a line minimise the energy of bending, of the weight and the
/// work against friction since the history: the incremental potential of the same law that cloth
/// uses.
class Elastica {
 public:
  /// @param length    of the strip (m)
  /// @param elements  of the line: its curvature is a polynomial of degree five in each
  explicit Elastica(double length, int elements = 10);

  const GaussLine& line() const { return line_; }

  /// Flat and at rest.
  StripHistory rested(const ComponentLaw& law) const;
  /// Bent from rest to one curvature everywhere.
  StripHistory rolled(const ComponentLaw& law, double curvature) const;

  /// Finds the equilibrium that a guess leads to.
  /// @param weight  per area (N/m^2)
  /// @param held    moments (N) that hold the points; empty for none
  /// @return nothing when there is none nearby
  std::optional<StripShape> equilibrium(const ComponentLaw& law, double weight,
                                        const StripEnds& ends, const StripHistory& history,
                                        const StripShape& guess,
                                        const Eigen::VectorXd& held = {}) const;

  /// Whether an equilibrium is a minimum of the energy in every direction that the far end allows,
  /// and no saddle.
  bool is_stable(const ComponentLaw& law, double weight, const StripEnds& ends,
                 const StripHistory& history, const StripShape& shape) const;

  /// Moments (N) that hold the points in the shape of their history.
  Eigen::VectorXd holding_moments(const ComponentLaw& law, double weight, const StripEnds& ends,
                                  const StripHistory& history) const;

  /// Fills in the derivatives of an equilibrium by the parameters of the law and by the weight.
  /// @param least_tangent  of d moment / d curvature (N m) at the points; empty for that of the law
  void differentiate(const ComponentLaw& law, double weight, const StripEnds& ends,
                     const StripHistory& history, StripShape& shape,
                     const Eigen::VectorXd& least_tangent = {}) const;

  /// d position of the free end / d length, of a strip that came to its equilibrium in one stretch
  /// from a history that is the same at all points.
  Eigen::Vector2d tip_by_length(const ComponentLaw& law, double weight, const StripEnds& ends,
                                const StripHistory& history, const StripShape& shape) const;

  /// Changes of the curvatures (1/m) of a strip with a free far end that balance it again where its
  /// points are turned by small angles.
  /// @param turns          rad, a column each
  /// @param least_tangent  as above
  Eigen::MatrixXd response_to_turns(const ComponentLaw& law, double weight, const StripEnds& ends,
                                    const StripHistory& history, const StripShape& shape,
                                    const Eigen::MatrixXd& turns,
                                    const Eigen::VectorXd& least_tangent) const;

  /// What the material remembers after a step that ended at `shape`, with derivatives where the
  /// shape has them.
  StripHistory accepted(const ComponentLaw& law, const StripHistory& history,
                        const StripShape& shape) const;

  StripProfile profile(const StripEnds& ends, const StripShape& shape) const;

 private:
  struct Balance;
  /// Of the energy, by curvature and by angle, at the points; integrated.
  struct Stiffness {
    Eigen::VectorXd bending, turning;
  };

  Balance balance(const ComponentLaw& law, double weight, const StripEnds& ends,
                  const StripHistory& history, const Eigen::VectorXd& held,
                  const StripShape& shape) const;
  Stiffness stiffness(const Balance& balance, bool convex) const;
  Eigen::MatrixXd matrix(const Stiffness& stiffness) const;
  LineFactor factor(const Stiffness& stiffness) const;
  Eigen::MatrixXd bordered(const Balance& balance) const;
  std::optional<Eigen::VectorXd> newton_step(const Balance& balance) const;
  Eigen::MatrixXd respond(const Balance& balance, const Eigen::MatrixXd& right) const;

  GaussLine line_;
};

}  // namespace pliant
