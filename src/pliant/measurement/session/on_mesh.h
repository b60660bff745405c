#pragma once

#include "pliant/geometry/triangle_mesh.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// A mesh may reach beyond the rest mesh of a session by this part of the sample's longer side.
inline constexpr double kMeshOverhang = 0.02;

/// The session as if it had been measured on another mesh of the same sheet, e.g. the one that is
/// simulated ([T] 3.4.1).
///
/// Positions are interpolated linearly in the triangles of the session's rest mesh; a node outside
/// of it follows the nearest one, and one by a vertex that was not seen was not seen either. A clip
/// gets the nodes within the convex hull of its clamped vertices at rest, or within half an edge of
/// it, of the finer of the two meshes. All else stays, the sample among it: what is known of its
/// mass and density gives the nodes their masses
/// (`vertex_masses`).
/// @param mesh  flat, in the coordinates of the session's rest mesh
/// @throws InputError for a node farther than `kMeshOverhang` outside, and a clip without nodes
Session on_mesh(const Session& session, const TriangleMesh& mesh);

}  // namespace pliant
