#pragma once

#include <string>
#include <vector>

#include "pliant/measurement/session.h"
#include "pliant/measurement/session/frame_names.h"

namespace pliant {

/// Share of the vertices that is seen in each frame at least.
inline constexpr double kSeenShare = 0.5;
/// Edges of a frame that are longer, as a multiple of their length at rest, are no cloth's: a
/// vertex was taken for another, or stands at the origin because it was not seen.
inline constexpr double kLongestEdge = 3;

/// Gives vertices that are not finite in a frame, which were not seen, positions, and marks them.
/// Those in clips and on the table are where they are held; the others continue what is around
/// them, as smoothly as it can be: four vertices of two triangles move as one affine map as far as
/// possible, in least squares.
/// @param session  with poses and edges of a table
/// @param names    of its frames, for errors
/// @return which frames have such vertices, in words; empty for none
/// @throws InputError that names the frame where less than `kSeenShare` of the vertices is known
std::vector<std::string> fill_in_unseen(Session& session, const FrameNames& names);

/// Sentences about vertices that are far from all that is next to them.
std::vector<std::string> outlier_warnings(const Session& session);

}  // namespace pliant
