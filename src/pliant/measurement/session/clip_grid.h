#pragma once

#include <vector>

#include "pliant/geometry/triangle_mesh.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// A grid of rectangles for the sheet of a session, whose lines meet the edges of its clips: what a
/// clip holds of the grid is what it holds of the cloth.
///
/// Lines run along the sides of the sample and of the rectangle around each clip's clamped vertices
/// at rest, and between them at equal distances. Those that would lie closer than a quarter of
/// `edge` together are one, at their mean or on the side of the sample.
/// @param session  of a rectangular sheet along weft and warp; the grid has its sample's size, and
///                 its middle in that of the rest mesh
/// @param edge     that the distances aim at (m), > 0
TriangleMesh grid_on_clips(const Session& session, double edge);

/// Lines from `low` to `high` at distances of about `edge`, with some at `stops`.
/// @param stops  in order; those closer than a quarter of `edge` together are one
std::vector<double> lines_on_stops(double low, double high, const std::vector<double>& stops,
                                   double edge);

}  // namespace pliant
