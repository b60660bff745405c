#pragma once

#include <optional>

#include "pliant/measurement/session.h"

namespace pliant {

// What [T] Fig. 3.6 plots forces of a frame over, and against.

/// The middle of the vertices that a clip clamps, at rest (m).
Eigen::Vector3d rest_middle(const Session& session, int clip);

/// How far the clips of a frame have moved from their places at rest together; of a session with a
/// table how much of the sheet hangs over its edge (m).
double travel(const Session& session, int frame);

/// Whether the clips return by a tenth of their travel at least, so that friction shows.
bool returns(const Session& session);

/// Effective shear of a frame (rad): the shear angle of the affine map that fits the motion of all
/// clamped vertices from the rest plane best. It is the angle by which the images of weft and warp
/// are nearer to each other than a right angle.
/// @return nothing where the clamped vertices lie on one line at rest
std::optional<double> effective_shear(const Session& session, int frame);

/// Aggregated torque of a frame (N m): the torques of the clips about the centre of the cloth,
/// every other clip counted negatively, along the normal of the plane that fits the sheet best,
/// towards its front.
///
/// Without the signs their sum is that of the equilibrium, zero but for weights. Clips take turns
/// counter-clockwise around the rest mesh, positive the first at or after the weft axis: right and
/// left count positively, top and bottom negatively. A clip hands on what its cords and weight
/// pull.
double aggregated_torque(const Session& session, int frame);

/// Stretching-force difference of a frame (N): tension between the lower left and upper right clip,
/// less that between the other two. A tension is the mean pull of two opposite clips away from each
/// other along the line between them.
/// @return nothing without one clip at each of the four corners and none elsewhere
std::optional<double> stretching_force_difference(const Session& session, int frame);

/// How much further than at rest the middles of the two clips of a session are apart (m); of a
/// strip how far its tester has gone, also where the strip is slack.
/// @return nothing without exactly two clips
std::optional<double> clip_extension(const Session& session, int frame);

/// Mean pull of the two clips of a session away from each other along the line between them (N); of
/// a strip what its load cell shows.
/// @return nothing without exactly two clips
std::optional<double> clip_pull(const Session& session, int frame);

}  // namespace pliant
