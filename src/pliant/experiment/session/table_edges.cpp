#include "pliant/experiment/session/table_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "pliant/io/csv_writer.h"

namespace pliant {
namespace {

constexpr double kMillimetre = 1e-3;  // m

int row_of(RestAxis axis) { return axis == RestAxis::u ? 0 : 1; }

void check_first_edge(double edge, const TableEntry& table, const Location& row) {
  if (std::abs(edge - table.edge) <= kEdgeRounding) return;
  throw InputError(table.where,
                   fmt::format("the edge is at {} in frame 0, at {} in {}, line {}",
                               format_quantity(table.edge, Dimension::length),
                               format_quantity(edge, Dimension::length), row.file, row.line),
                   "the same place");
}

}  // namespace

std::vector<double> read_table_edges(const FrameRows& rows, const TableEntry& table,
                                     const TriangleMesh& rest, int frames, FrameTimes& times) {
  const std::vector<double> read = rows.table().quantity("edge", Dimension::length);
  const std::string column = *rows.table().quantity_column("edge");
  const double low = rest.positions.row(row_of(table.axis)).minCoeff();
  std::vector<std::optional<double>> edges(static_cast<std::size_t>(frames));
  for (int row = 0; row < rows.rows(); ++row) {
    const double edge = read[static_cast<std::size_t>(row)];
    const int frame = rows.frame(row);
    std::optional<double>& known = edges[static_cast<std::size_t>(frame)];
    if (known) {
      throw InputError(rows.location(row, "frame"), fmt::format("a second row of frame {}", frame),
                       "one row a frame");
    }
    if (edge <= low) {
      throw InputError(rows.location(row, column),
                       fmt::format("frame {}: the table holds no vertex", frame),
                       fmt::format("an edge above {}, where the sheet begins at rest",
                                   format_quantity(low, Dimension::length)));
    }
    if (frame == 0) check_first_edge(edge, table, rows.location(row, column));
    known = edge;
  }
  std::vector<double> result;
  for (const std::optional<double>& edge : edges) {
    if (!edge) {
      throw InputError({rows.table().file(), 0, "frame"},
                       fmt::format("frame {} has no row", result.size()), "one row a frame");
    }
    result.push_back(*edge);
  }
  times.take(rows);
  return result;
}

std::vector<int> held_by_table(const Session& session, int frame) {
  std::vector<int> held;
  if (!session.table) return held;
  const double edge = session.frames[static_cast<std::size_t>(frame)].table_edge.value();
  const auto coordinates = session.rest.positions.row(row_of(*session.table));
  for (int i = 0; i < session.rest.vertex_count(); ++i) {
    if (coordinates[i] < edge) held.push_back(i);
  }
  return held;
}

std::vector<std::string> table_warnings(const Session& session) {
  const double most = kTableDrift * std::max(session.sample.width, session.sample.height);
  double largest = 0;
  int at_frame = 0, at_vertex = 0, frames = 0;
  for (int f = 0; f < session.frame_count(); ++f) {
    double largest_here = 0;
    for (const int vertex : held_by_table(session, f)) {
      const double drift = (session.frames[static_cast<std::size_t>(f)].positions.col(vertex) -
                            session.rest.positions.col(vertex))
                               .norm();
      largest_here = std::max(largest_here, drift);
      if (drift <= largest) continue;
      largest = drift;
      at_frame = f;
      at_vertex = vertex;
    }
    if (largest_here > most) ++frames;
  }
  if (frames == 0) return {};
  return {fmt::format(
      "in {} of {} frames vertices on the table are not at rest, most in frame {}: vertex {} is {} "
      "from its place (expected: at most {}, frames in the sheet's own axes)",
      frames, session.frame_count(), at_frame, at_vertex,
      format_quantity(largest, Dimension::length), format_quantity(most, Dimension::length))};
}

std::string table_edge_table(const Session& session) {
  const bool timed = all_rows_timed(session, [](const SessionFrame&) { return true; });
  std::vector<std::string> header{"frame", "edge_mm"};
  if (timed) header.emplace_back("time_s");
  CsvWriter writer(header);
  for (int f = 0; f < session.frame_count(); ++f) {
    const SessionFrame& frame = session.frames[static_cast<std::size_t>(f)];
    writer.cell(f).cell(frame.table_edge.value() / kMillimetre);
    if (timed) writer.cell(*frame.time);
    writer.end_row();
  }
  return writer.text();
}

}  // namespace pliant
