#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/triangle_mesh.h"
#include "pliant/io/mesh_data.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// A rest mesh is flat where no z exceeds this part of its diagonal.
inline constexpr double kFlatness = 1e-4;
/// Width and height of a rest mesh may differ from those of the sample by this part.
inline constexpr double kSampleAgreement = 0.05;
/// Edges of a frame are in metres where their mean length is within this factor of that at rest.
inline constexpr double kMostFrameScale = 10;

/// The rest mesh of a session with the faces of its file.
struct RestSheet {
  TriangleMesh mesh;
  Polygons faces;
};

/// Reads rest.ply.
/// @throws InputError for a mesh that is not flat, whose faces run clockwise, that is unfit for
///         simulation, or whose size is not the sample's
RestSheet read_rest_sheet(const std::filesystem::path& file, const SessionSample& sample);

/// Where the vertices of a frame are (m), not finite where they were not seen.
struct FrameSheet {
  Eigen::Matrix3Xd positions;
  Eigen::Matrix3Xd deviations;  ///< standard deviations along the axes; empty where not told
};

/// Reads a frame.
/// @throws InputError for another number of vertices than at rest, no vertex that was seen, other
///         faces than at rest (a frame may have none), another unit than metres, deviations that
///         are not above 0 where a vertex was seen
FrameSheet read_frame_sheet(const std::filesystem::path& file, int frame, const RestSheet& rest);

/// The binary PLY file of a mesh with its vertices at `positions`.
/// @param unseen      vertices that get NaN
/// @param deviations  of the positions; empty: none are written
std::string sheet_ply(const TriangleMesh& mesh, const Eigen::Matrix3Xd& positions,
                      const std::vector<int>& unseen = {}, const Eigen::Matrix3Xd& deviations = {});

}  // namespace pliant
