#pragma once

#include "pliant/experiment/virtual_table.h"

namespace pliant {

/// Strips that hang from a clamp, photographed: the table of their profiles.
///
/// Their lines are finer than those that a fit compares with. Their points stand evenly along the
/// strip; the first one, the clamp, is free of noise.
struct VirtualProfiles : VirtualTable {
  int points = 25;        ///< of a profile
  bool any_rest = false;  ///< a strip that may rest in several shapes is left in any, by chance

  std::string rows(const ComponentLaw& law, const ClothFacts& cloth,
                   RandomStream& random) const override;
  WrittenFields study_fields() const override;

 protected:
  /// A strip that hangs, and how it came to.
  struct Strip {
    double length = 0;  // m
    double rolled = 0;  // curvature that it was bent to (1/m)
  };
  virtual Strip strip(double setting) const = 0;
  /// Column of the setting, of which 1000 are an SI unit.
  virtual const char* setting_column() const = 0;
  std::string profiles_text() const;
};

/// Reads `points`, `repeats` and the instrument.
void read_photographs(Fields& fields, VirtualProfiles& test);

}  // namespace pliant
