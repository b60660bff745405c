#pragma once

#include "pliant/experiment/bending_length/bending_length.h"
#include "pliant/experiment/virtual_table.h"

namespace pliant {

/// Strips pushed out over an edge until they dip by an angle.
const TestType& bending_length_type();

/// The data tell the length.
struct BendingLengthSpec : TestSpec {
  double angle = kOverhangAngle;  ///< rad, of the plane that the tip touches

  const TestType& type() const override { return bending_length_type(); }
  WrittenFields fields() const override;
};

/// Both faces, each as often as it is repeated. The strips are lines of more and shorter elements
/// than those that a fit compares with.
struct VirtualBendingLength : VirtualTable {
  double angle = kOverhangAngle;

  VirtualBendingLength() { repeats = 2; }
  const TestType& type() const override { return bending_length_type(); }
  std::string rows(const ComponentLaw& law, const ClothFacts& cloth,
                   RandomStream& random) const override;
  WrittenFields study_fields() const override;

 protected:
  WrittenFields own_description() const override;
};

}  // namespace pliant
