#pragma once

#include <string>
#include <vector>

#include "pliant/measurement/session.h"
#include "pliant/measurement/session/frame_rows.h"
#include "pliant/measurement/session/session_document.h"

namespace pliant {

/// session.yaml and table.csv may state the edge in frame 0 this far apart (m): rounding.
inline constexpr double kEdgeRounding = 1e-4;
/// Vertices on the table are expected within this part of the sample's longer side of their place
/// at rest.
inline constexpr double kTableDrift = 0.01;

/// Reads table.csv: the edge in each frame (m).
/// @param times  gets those of the table
/// @throws InputError for a frame without edge, or with two, an edge that leaves the table no
///         vertex, and where frame 0 is not as session.yaml says
std::vector<double> read_table_edges(const FrameRows& rows, const TableEntry& table,
                                     const TriangleMesh& rest, int frames, FrameTimes& times);

/// The vertices that the table holds in a frame: those whose rest coordinate is below its edge.
/// None in sessions without a table.
std::vector<int> held_by_table(const Session& session, int frame);

/// A sentence about vertices that should lie still on the table and do not.
std::vector<std::string> table_warnings(const Session& session);

/// The text of table.csv.
std::string table_edge_table(const Session& session);

}  // namespace pliant
