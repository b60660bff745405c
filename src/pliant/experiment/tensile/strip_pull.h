#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "pliant/experiment/uniaxial_geometry.h"
#include "pliant/material/law_path.h"
#include "pliant/measurement/turning_points.h"

namespace pliant {

/// What of a strip in a tensile tester is not material.
struct StripSetup {
  double force_offset = 0;        ///< N
  double rest_length_change = 0;  ///< m; rest length = gauge length + change
  double initial_friction = 0;    ///< share of the maximum friction stress at the first row, -1..1
  double apparatus_friction = 0;  ///< N, against the motion of the clamps
  double slip = 0;                ///< m/N; cloth drawn out of the clamps by the largest pull so far
  double compliance = 0;  ///< m/N, of the apparatus: it gives way to the pull, and comes back
};

/// Columns of the Jacobian that hold the derivatives w.r.t. the setup; -1: not wanted.
struct StripColumns {
  int force_offset = -1;
  int rest_length_change = -1;
  int initial_friction = -1;
  int slip = -1;
  int compliance = -1;
};

/// Row by row: force (N), strain of the material, |d force / d length| (N/m), d force / d
/// parameters.
struct StripForces {
  Eigen::VectorXd force;
  Eigen::VectorXd strain;
  Eigen::VectorXd length_gain;
  Eigen::MatrixXd jacobian;
};

/// Forces of a strip whose clamps follow a path.
///
/// A strip cannot push: when unloading has brought its tension to zero it buckles, its material
/// keeps the strain it had then (friction holds it), and it takes up load again when the clamps
/// have come back to that length. A strip that is slack at the start may hold a persistent strain,
/// told by a negative initial friction.
/// Where the law flows with time, what a slack strip keeps does so too.
///
/// What slips out of the clamps lengthens the strip, what the apparatus gives way takes off the
/// distance of the clamps: with force F and its maximum so far M the strip of rest length
/// L0 + slip M is stretched to the length L - compliance F, which is solved for F row by row.
/// @param lengths     clamp distances (m)
/// @param half_cycles   of `lengths`
/// @param parameters  number of columns of the Jacobian; 0: no derivatives
/// @param times       of the rows (s); empty: what flows is at rest
/// @param before      what an earlier pull of the same strip has left (`state_after_pull`); none:
/// the
///                    strip is fresh. The gauge length is then that of the strip as it was left.
/// @return nothing when the persistent strain at the start has no value
std::optional<StripForces> pull_strip(const ComponentLaw& law, const UniaxialGeometry& geometry,
                                      const StripSetup& setup, const StripColumns& columns,
                                      std::span<const double> lengths,
                                      std::span<const HalfCycle> half_cycles, int parameters,
                                      std::span<const double> times = {},
                                      const PathPoint* before = nullptr);

/// What a pull leaves of the strip when it is taken out of its clamps: free of force, with the
/// strain that the material keeps then, and with what flows come to rest.
/// @return nothing where the pull has no values, or where no strain is free of force
std::optional<PathPoint> state_after_pull(const ComponentLaw& law, const UniaxialGeometry& geometry,
                                          const StripSetup& setup, std::span<const double> lengths,
                                          std::span<const HalfCycle> half_cycles, int parameters,
                                          std::span<const double> times = {},
                                          const PathPoint* before = nullptr);

}  // namespace pliant
