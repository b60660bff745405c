#pragma once

#include "pliant/experiment/profile/virtual_profiles.h"

namespace pliant {

/// Strips that stick out of a clamp, at several overhangs.
const TestType& cantilever_type();

/// The data tell the length.
struct CantileverSpec : TestSpec {
  bool density_is_known = true;  ///< else it is estimated along

  const TestType& type() const override { return cantilever_type(); }
  WrittenFields fields() const override;
};

/// At overhangs (m).
struct VirtualCantilever : VirtualProfiles {
  const TestType& type() const override { return cantilever_type(); }

 protected:
  Strip strip(double overhang) const override { return {overhang, 0}; }
  const char* setting_column() const override { return "overhang_mm"; }
  WrittenFields own_description() const override { return {{"overhangs", profiles_text()}}; }
};

}  // namespace pliant
