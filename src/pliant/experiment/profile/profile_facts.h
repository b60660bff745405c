#pragma once

#include "pliant/experiment/test_facts.h"
#include "pliant/experiment/test_type.h"

namespace pliant {

/// What holds of tests of strips' profiles.
inline TestFacts profile_facts() {
  return {.deformation = Deformation::bend,
          .measures_profiles = true,
          .bends_by_weight = true,
          .needs_density = true,
          .is_sparse = true,
          .assumption =
              "the strip bends in a plane, is clamped level, does not stretch or touch itself, and "
              "comes to rest quietly; the noise is in the positions, alike in all directions"};
}

/// Whether a table has profiles.
inline bool has_profiles(const TableColumns& columns) {
  return columns.has("x", Dimension::length) && columns.has("y", Dimension::length);
}

}  // namespace pliant
