#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pliant/measurement/session.h"
#include "pliant/measurement/session/frame_rows.h"

namespace pliant {

/// The length of a quaternion may differ from 1 by this much, rounding in a file; it is made 1.
inline constexpr double kQuaternionRounding = 1e-3;
/// Clamped vertices are within this part of the sample's longer side of where the pose of their
/// clip puts them.
inline constexpr double kClampDrift = 0.01;

/// The poses of all clips with their lines in clips.csv, by frame, then clip.
struct ClipPoses {
  std::string file;
  std::vector<std::vector<Pose>> poses;
  std::vector<std::vector<int>> lines;
};

/// Reads clips.csv.
/// @param times  gets those of the table
/// @throws InputError for a clip without pose in a frame, or with two, and for a quaternion that is
///         not of unit length
ClipPoses read_clip_poses(const FrameRows& rows, const std::vector<SessionClip>& clips, int frames,
                          FrameTimes& times);

/// @throws InputError with frame, clip and vertex where a clamped vertex is farther than
///         `kClampDrift` from where the clip's pose puts it
void require_clamped_vertices(const Session& session, const ClipPoses& poses);

/// The text of clips.csv.
std::string clip_pose_table(const Session& session);

}  // namespace pliant
