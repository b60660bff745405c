#pragma once

#include "pliant/experiment/experiment_spec.h"
#include "pliant/experiment/imposed_strain.h"

namespace pliant {

/// Shear of a sheet to and fro by an imposed angle, shear force per width measured (KES-FB1).
///
/// Yarns keep their length, so that the strain w_u . w_v is sin(angle); the clamps come nearer, and
/// the transverse tension T of the instrument does work on it: force per width = stress + T
/// tan(angle).
class ShearCycles : public ImposedStrain {
 public:
  ShearCycles(const ExperimentSpec& spec, const DataRows& data);
};

}  // namespace pliant
