#pragma once

#include "pliant/experiment/specimen_fields.h"
#include "pliant/experiment/virtual_imposed_strain.h"

namespace pliant {

/// Shear to and fro (KES-FB1).
const TestType& shear_cycles_type();

struct ShearCyclesSpec : TestSpec {
  double transverse_tension = 0;  ///< N/m
  InitialFriction initial_friction = InitialFriction::rest;

  const TestType& type() const override { return shear_cycles_type(); }
  WrittenFields fields() const override;
};

/// Between angles (rad).
struct VirtualShearCycles : VirtualImposedStrain {
  double transverse_tension = 0;

  const TestType& type() const override { return shear_cycles_type(); }
  WrittenFields study_fields() const override;

 protected:
  ImposedTable table() const override;
  std::unique_ptr<ComponentExperiment> on(const SampledPath& path) const override;
  WrittenFields own_description() const override;
};

}  // namespace pliant
