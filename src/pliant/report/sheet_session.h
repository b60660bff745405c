#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "pliant/measurement/session.h"

namespace pliant::report {

/// A full-field session as it was measured and as the material predicts it: the same frames, clips
/// and mesh, the one that was simulated.
struct SheetSession {
  Session measured, predicted;

  int frame_count() const { return measured.frame_count(); }
  /// Whether vertices were seen: not those of a tester's strip.
  bool is_seen() const { return measured.kind == SessionKind::sheet; }
};

/// Reads `measured` and `predicted` in a folder of sheets/.
/// @throws InputError where one is no session, or the two are not of the same frames, clips, nodes
SheetSession read_sheet_session(const std::filesystem::path& folder);

/// The nodes that neither clip nor table holds in a frame, and that were seen.
std::vector<int> free_nodes(const Session& session, int frame);

/// Where the material puts each node, less where it was measured (m, one column a node; [T] Fig.
/// 3.6).
Eigen::Matrix3Xd position_residual(const SheetSession& sheet, int frame);

/// RMS distance between measured and predicted free nodes (m): of a frame, or of all frames ([T]
/// Tables A.1-A.4). Zero where no node is free.
double rms_distance(const SheetSession& sheet, int frame);
double rms_distance(const SheetSession& sheet);

/// The frame whose clamped nodes, where there are clips, or else all nodes are farthest (RMS) from
/// those of the flat sheet, moved rigidly to fit them best.
int most_distorted_frame(const Session& session);

/// RMS difference of the forces of clips (N), from the rows of a session's predictions: rows of one
/// clip in one frame are the axes of one force, and those without prediction do not count.
/// @param file  predictions/NAME.csv with the columns frame, clip, measured_ and predicted_force_N
double rms_clip_force(const std::filesystem::path& file);

}  // namespace pliant::report
