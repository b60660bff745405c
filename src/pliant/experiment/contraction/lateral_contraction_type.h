#pragma once

#include "pliant/experiment/specimen_fields.h"
#include "pliant/experiment/virtual_table.h"

namespace pliant {

/// The width of a strip that is pulled, between marks or by pictures.
const TestType& lateral_contraction_type();

/// `length` and `width` are those of the marks at rest.
struct LateralContractionSpec : TestSpec {
  InitialFriction initial_friction = InitialFriction::rest;

  const TestType& type() const override { return lateral_contraction_type(); }
  WrittenFields fields() const override;
};

/// Cycles to engineering strains.
struct VirtualLateralContraction : VirtualCycles {
  const TestType& type() const override { return lateral_contraction_type(); }
  std::string rows(const ComponentLaw& law, const ClothFacts& cloth,
                   RandomStream& random) const override;
  WrittenFields study_fields() const override;

 protected:
  WrittenFields own_description() const override;
};

}  // namespace pliant
