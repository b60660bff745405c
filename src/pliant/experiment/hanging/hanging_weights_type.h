#pragma once

#include "pliant/experiment/specimen_fields.h"
#include "pliant/experiment/virtual_table.h"

namespace pliant {

/// Weights hung from a sheet: [T] 5.3.2.
const TestType& hanging_weights_type();

struct HangingWeightsSpec : TestSpec {
  double clip_mass = 0;  ///< kg, of what hangs below the cloth beside the weights
  bool rested = false;   ///< before every repeat
  RestLength rest_length = RestLength::known;

  const TestType& type() const override { return hanging_weights_type(); }
  WrittenFields fields() const override;
};

/// Weights 0 .. n .. 0 for each peak n (N), the whole sequence repeated.
struct VirtualHangingWeights : VirtualTable {
  double clip_mass = 0;
  double step = 1;  ///< N between weights

  const TestType& type() const override { return hanging_weights_type(); }
  std::string rows(const ComponentLaw& law, const ClothFacts& cloth,
                   RandomStream& random) const override;
  WrittenFields study_fields() const override;

 protected:
  WrittenFields own_description() const override;
};

}  // namespace pliant
