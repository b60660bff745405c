#pragma once

#include <string>
#include <vector>

#include "pliant/measurement/session.h"
#include "pliant/measurement/session/frame_rows.h"

namespace pliant {

/// A cord is attached within this many diagonals of the sample of its clip's clamped vertices.
inline constexpr double kCordReach = 2;

/// The cords of all clips with their lines in cords.csv, by frame, then clip.
struct CordForces {
  std::string file;
  std::vector<std::vector<std::vector<CordForce>>> cords;
  std::vector<std::vector<std::vector<int>>> lines;
};

/// Beyond this force (N) sums of squares are no numbers.
inline constexpr double kHardestPull = 1e100;

/// Reads cords.csv.
/// @param times  gets those of the table
/// @throws InputError, also for two rows of a cord in a frame, and a force above `kHardestPull`
CordForces read_cord_forces(const FrameRows& rows, const std::vector<SessionClip>& clips,
                            int frames, FrameTimes& times);

/// @throws InputError for a cord that is attached farther than `kCordReach` from its clip: its
///         point is not in metres, or not in the axes of the frames
void require_attached_cords(const Session& session, const CordForces& cords);

/// The text of cords.csv.
std::string cord_force_table(const Session& session);

}  // namespace pliant
