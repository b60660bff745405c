#pragma once

#include "pliant/experiment/imposed_strain.h"
#include "pliant/experiment/sampled_path.h"
#include "pliant/experiment/uniaxial_geometry.h"

namespace pliant {

/// How much narrower a strip becomes while it is pulled, its edges free: the law of its component
/// `contraction.DIRECTION` gives 1 - width / width at rest along the path of the strain lengthways.
class LateralContraction : public ImposedStrain {
 public:
  /// @throws InputError for rows that do not change, or without lengths
  LateralContraction(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth);
  /// A path of lengths (m) without measured widths.
  LateralContraction(const UniaxialGeometry& geometry, const SampledPath& path);
};

}  // namespace pliant
