#pragma once

#include "pliant/material/density/density.h"

namespace pliant {

/// Damping of the rate of one strain component (Baraff and Witkin 1998): stress coefficient times
/// rate, as the derivative of an incremental potential. Nothing in statics.
class Damping : public Density {
 public:
  /// @param component    the strain that it acts on
  /// @param coefficient  stress per rate of strain (N s/m for membranes, N m s for bending), >= 0
  Damping(int component, double coefficient);

  int history_size() const override { return 0; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void add_stored(const Samples&, Lane&) const override {}
  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override;

 private:
  Lane way(const Samples& samples, const StepTime& time) const;

  int component_;
  double coefficient_;
};

}  // namespace pliant
