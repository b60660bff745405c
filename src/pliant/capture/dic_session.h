#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/capture/dic_file.h"
#include "pliant/capture/middle_record.h"
#include "pliant/capture/point_source.h"
#include "pliant/capture/still_reading.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// How far cloth has come out of a clip whose own motion is known, frame by frame (m).
struct ClipSlip {
  std::string clip;
  std::vector<double> slip;
};

/// A frame that cannot be used, and why.
struct LeftOutFrame {
  int frame = 0;
  std::string why;
};

/// The vertices of the session's mesh in a picture.
struct MeshView {
  int frame = 0;
  std::string camera;
  PointsInPicture seen;
};

/// A session that was made from measured points.
struct DicSession {
  Session session;
  double spacing = 0;    ///< of the points (m)
  double off_plane = 0;  ///< root mean square at rest (m)
  /// Where it did not lie flat at first: by how much it had to be stretched to be laid flat, a
  /// share (see UnrolledSheet).
  std::optional<double> unrolled;
  double point_noise = 0;   ///< by which a coordinate of a point misses an affine motion around it
  std::vector<int> lost;    ///< points of each frame; 0 of one that is left out
  std::vector<int> unseen;  ///< vertices of each frame; likewise
  std::vector<LeftOutFrame> left_out;  ///< not in the session; not a number in the records
  /// Frames that the session leaves out: of a flat test, without force; or the first one, which
  /// lies on something.
  std::vector<int> slack;
  std::optional<MiddleRecord> middle;  ///< where two clips at opposite sides pull
  std::vector<ClipSlip> slips;
  std::vector<double> nearer;        ///< of each frame, by what share of its distance a clip has
                                     ///< come nearer to the camera against the other
  std::vector<std::string> cameras;  ///< names, where there are pictures
  std::vector<std::optional<SightQuality>> qualities;  ///< of each frame, where there are pictures
  std::vector<MeshView> views;                         ///< of some frames, where there are pictures
  std::vector<RegionMisses> misses;                    ///< of each of several cameras
  std::vector<int> used;                               ///< the frames that the session has
  std::vector<std::string> notes, warnings;            ///< of where the points come from
  std::vector<double> force, time;  ///< of each frame; empty where they are not known
  /// How still forces were in each frame, where the file tells how long frames stand.
  std::vector<std::optional<FrameStand>> stands;

  /// Of the files; the session may have fewer.
  int frame_count() const { return static_cast<int>(lost.size()); }
};

/// Follows a grid on the sample through the frames: each vertex goes where the points around it
/// say, by an affine motion of the points within two spacings; where there is none it is unseen.
/// Clips move as the file tells.
/// @param read_picture  needed where the file names pictures
/// @throws InputError
DicSession make_dic_session(const DicFile& dic, const ReadPicture& read_picture = {},
                            const RunContext& context = {});

}  // namespace pliant
