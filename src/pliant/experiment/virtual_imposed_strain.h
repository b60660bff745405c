#pragma once

#include <memory>

#include "pliant/experiment/virtual_table.h"

namespace pliant {

/// What a machine that imposes strain writes down.
struct ImposedTable {
  const char* driver = "";  ///< column of what it moves at even speed
  double driver_per_si = 1;
  const char* measured = "";
};

/// A machine that imposes strain to and fro: 0, +peak, -peak, 0 in one cycle.
struct VirtualImposedStrain : VirtualCycles {
  std::string rows(const ComponentLaw& law, const ClothFacts& cloth,
                   RandomStream& random) const override;

 protected:
  virtual ImposedTable table() const = 0;
  /// The test on a path of what the machine moves.
  virtual std::unique_ptr<ComponentExperiment> on(const SampledPath& path) const = 0;
};

/// `TestFacts::unfitted` of such tests.
inline constexpr std::string_view kUnfittedImposedStrain = "friction at rest, no offset";

}  // namespace pliant
