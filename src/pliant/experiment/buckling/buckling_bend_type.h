#pragma once

#include "pliant/experiment/buckling/buckling_side.h"
#include "pliant/experiment/specimen_fields.h"
#include "pliant/experiment/virtual_table.h"

namespace pliant {

/// A strip that buckles between clamps that come nearer and go back.
const TestType& buckling_bend_type();

struct BucklingBendSpec : TestSpec {
  BucklingSide side = BucklingSide::down;
  RestLength rest_length = RestLength::known;

  const TestType& type() const override { return buckling_bend_type(); }
  WrittenFields fields() const override;
};

/// Clamps that come nearer by shares of the length, as the study will state it. The strips are
/// lines of more elements than those that a fit compares with.
struct VirtualBucklingBend : VirtualCycles {
  BucklingSide side = BucklingSide::down;
  double strip_length = 0;  ///< m, what the strip has in truth between its clamps
  double force_offset = 0;  ///< N
  double force_drift = 0;   ///< N, of the force's zero from the first row to the last

  const TestType& type() const override { return buckling_bend_type(); }
  std::string rows(const ComponentLaw& law, const ClothFacts& cloth,
                   RandomStream& random) const override;
  WrittenFields study_fields() const override;

 protected:
  WrittenFields own_description() const override;
};

}  // namespace pliant
