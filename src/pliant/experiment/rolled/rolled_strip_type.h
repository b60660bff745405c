#pragma once

#include "pliant/experiment/profile/virtual_profiles.h"
#include "pliant/experiment/specimen_fields.h"

namespace pliant {

/// Strips that were rolled around cylinders and released ([P] 4.3).
const TestType& rolled_strip_type();

struct RolledStripSpec : TestSpec {
  const TestType& type() const override { return rolled_strip_type(); }
  WrittenFields fields() const override { return written_size(*this); }
};

/// Around cylinders of radii (m), negative where they turn the strip right.
struct VirtualRolledStrip : VirtualProfiles {
  const TestType& type() const override { return rolled_strip_type(); }
  WrittenFields study_fields() const override;

 protected:
  Strip strip(double radius) const override { return {length, 1 / radius}; }
  const char* setting_column() const override { return "radius_mm"; }
  WrittenFields own_description() const override;
};

}  // namespace pliant
