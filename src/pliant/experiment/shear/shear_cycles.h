#pragma once

#include "pliant/experiment/imposed_strain.h"
#include "pliant/experiment/sampled_path.h"

namespace pliant {

/// Shear of a sheet to and fro by an imposed angle, shear force per width measured (KES-FB1).
///
/// Yarns keep their length, so that the strain w_u . w_v is sin(angle); the clamps come nearer, and
/// the transverse tension T of the instrument does work on it: force per width = stress + T
/// tan(angle).
class ShearCycles : public ImposedStrain {
 public:
  ShearCycles(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth);
  /// A path of angles (rad) without measured forces.
  ShearCycles(const SampledPath& path, double transverse_tension);
};

}  // namespace pliant
