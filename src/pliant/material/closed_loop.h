#pragma once

#include <optional>

#include "pliant/material/density/dahl.h"
#include "pliant/material/law_path.h"
#include "pliant/material/material.h"

namespace pliant {

/// The loop of stress over strain between two strains of one size, gone round until it has closed:
/// what testers of bending and shear draw, whose clamps go to both sides.
class ClosedLoop {
 public:
  /// @param component  its stiffness is given; its friction may differ between the sides
  /// @param reach      strain at which it turns, > 0
  ClosedLoop(const MaterialComponent& component, double reach);

  double loading(double strain) const { return stress(strain, lower_turn_); }
  double unloading(double strain) const { return stress(strain, upper_turn_); }

 private:
  struct Turn {
    LawPath others;  // what is no friction of the component's own
    FrictionState friction;

    double remembered() const;
  };

  double friction_at(double strain, const FrictionState& from) const;
  double stress(double strain, const Turn& from) const;
  Turn turned(Turn from, double strain) const;
  void close();

  double reach_;
  std::optional<DahlBySide> friction_;
  Turn lower_turn_, upper_turn_;
};

}  // namespace pliant
