#pragma once

#include <string>
#include <vector>

#include "pliant/measurement/session.h"
#include "pliant/report/labels.h"

namespace pliant::report {

/// A summary of the forces of a session over how far it has gone, frame by frame ([T] Fig. 3.6).
struct ForceCurve {
  std::string clip;  ///< whose force it is; empty where it sums up those of all clips
  QuantityLabel over, of;
  std::vector<double> displacement, force;  ///< in the units of the labels
};

/// What sums up the forces of a session: the mean pull of opposite clips over the distance that
/// they have moved apart where there are two of them or the test is a stretch, in a complex shear
/// of two clips the pull along them over how far they have slid; the stretching-force difference of
/// four clips at the corners and the aggregated torque of four others over the effective shear;
/// else the force of each clip over how far the clip has moved.
/// @return nothing for a session without clips
std::vector<ForceCurve> force_curves(const Session& session);

}  // namespace pliant::report
