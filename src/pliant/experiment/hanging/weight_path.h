#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "pliant/experiment/uniaxial_geometry.h"
#include "pliant/material/component_law.h"

namespace pliant {

/// Row by row: length under the weight (m), strain, d length / d parameters of the law.
struct HungLengths {
  Eigen::VectorXd length;
  Eigen::VectorXd strain;
  Eigen::MatrixXd jacobian;
};

/// Lengths of a sheet under a sequence of dead weights.
///
/// Each weight moves the strain monotonically from where it was to the first equilibrium it meets
/// ([T] Eq. 5.5 = 0).
/// @param forces   N, everything that hangs
/// @param rested   a row: did the sheet rest before it, free of friction stress
/// @param jacobian whether derivatives are wanted
/// @return nothing when some weight has no equilibrium
std::optional<HungLengths> hang_weights(const ComponentLaw& law, const UniaxialGeometry& geometry,
                                        std::span<const double> forces,
                                        std::span<const char> rested, bool jacobian);

}  // namespace pliant
