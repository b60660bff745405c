#pragma once

#include "pliant/material/density/dahl.h"
#include "pliant/material/density/density.h"

namespace pliant {

/// Dahl friction on one strain component linearised once a step, as published ([T] Eq. 5.9): the
/// stress is a linear function of the new strain, with a slope that supposes the direction of the
/// last step. Kept for comparison; its large steps may gain energy.
///
/// The increment of strain of the last step stands for the papers' rate times time step. At
/// accepted steps the stress becomes the exact solution along the step's strain, step 1 of the
/// papers' algorithm (which uses the approximate Eq. 5.3).
///
/// History: the friction stress.
class LinearizedDahlFriction : public Density {
 public:
  /// @param component  the strain that it acts on
  LinearizedDahlFriction(int component, const DahlBySide& dahl);

  int history_size() const override { return 1; }
  void add(const Samples& samples, const StepTime& time, Response& response) const override;
  void add_stored(const Samples&, Lane&) const override {}
  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override;

 private:
  int component_;
  DahlBySide dahl_;
};

}  // namespace pliant
