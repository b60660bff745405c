#pragma once

#include <optional>

#include "pliant/experiment/specimen_fields.h"
#include "pliant/experiment/virtual_table.h"

namespace pliant {

class TensileCycles;

/// Load-unload cycles of a strip on a tensile tester.
const TestType& tensile_cycles_type();

struct TensileCyclesSpec : TestSpec {
  std::optional<double> oblique_angle;  ///< rad from weft, of a strip cut otherwise than along
                                        ///< weft, warp or bias
  double pretension = 0;                ///< N, at which the gauge length was set
  double apparatus_friction = 0;        ///< N, stated friction of the instrument
  int precondition_cycles = 0;
  InitialFriction initial_friction = InitialFriction::rest;
  RestLength rest_length = RestLength::known;
  Clamps clamps;

  const TestType& type() const override { return tensile_cycles_type(); }
  WrittenFields fields() const override;
  /// There is no component at 30 degrees.
  bool is_only_sheet() const override { return oblique_angle.has_value(); }
};

/// Cycles to engineering strains.
struct VirtualTensileCycles : VirtualCycles {
  Clamps clamps;

  const TestType& type() const override { return tensile_cycles_type(); }
  std::string rows(const ComponentLaw& law, const ClothFacts& cloth,
                   RandomStream& random) const override;
  WrittenFields study_fields() const override;

 protected:
  WrittenFields own_description() const override;

 private:
  /// The pull along a path, after the tests before it.
  TensileCycles pulled(const SampledPath& path, const ClothFacts& cloth) const;
};

}  // namespace pliant
