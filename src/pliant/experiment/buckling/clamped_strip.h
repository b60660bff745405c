#pragma once

#include "pliant/experiment/buckling/buckling_side.h"
#include "pliant/solver/elastica/elastica.h"

namespace pliant {

/// A strip clamped flat at both ends between clamps that come nearer and go back. It starts
/// straight and free of friction, and buckles to one side; its halves are mirror images.
class ClampedStrip {
 public:
  /// @param law       outlives the strip
  /// @param weight    per area (N/m^2)
  /// @param length    between the clamps (m)
  /// @param elements  of the line of a half
  ClampedStrip(const ComponentLaw& law, double weight, double length, BucklingSide side,
               int elements);

  /// Moves the clamps to a distance (m), below the strip's length; the first time in several steps,
  /// in which the strip rises evenly.
  /// @return false when no equilibrium is found there
  bool move_to(double distance, bool with_derivatives);

  /// The half at the first clamp: its far load along x is the force per width, pulling positive.
  const StripShape& shape() const { return shape_; }

 private:
  bool go_to(double distance, bool with_derivatives);
  bool step_to(double distance, bool with_derivatives);

  const ComponentLaw& law_;
  double weight_;
  double length_;
  Elastica half_;
  StripHistory history_;
  StripShape shape_;
  double distance_;
  bool moved_ = false;
};

/// Half of the rise of a strip without weight between clamps that are nearer than its length: it is
/// nearly one wave of a cosine.
double half_rise(double length, double distance);

}  // namespace pliant
