#pragma once

#include "pliant/experiment/specimen_fields.h"
#include "pliant/experiment/virtual_imposed_strain.h"

namespace pliant {

/// Bending to and fro by an imposed curvature (KES-FB2).
const TestType& pure_bending_type();

/// Moments are per width: the size of the specimen is kept for the record.
struct PureBendingSpec : TestSpec {
  InitialFriction initial_friction = InitialFriction::rest;

  const TestType& type() const override { return pure_bending_type(); }
  WrittenFields fields() const override;
};

/// Between curvatures (1/m).
struct VirtualPureBending : VirtualImposedStrain {
  const TestType& type() const override { return pure_bending_type(); }
  WrittenFields study_fields() const override;

 protected:
  ImposedTable table() const override { return {"curvature_1_per_m", 1, "moment_N"}; }
  std::unique_ptr<ComponentExperiment> on(const SampledPath& path) const override;
  WrittenFields own_description() const override;
};

}  // namespace pliant
