#include "pliant/measurement/session/table_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "pliant/io/csv_writer.h"
#include "pliant/measurement/session/frame_axes.h"

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

namespace {

/// The axes in which a frame would have held vertices where they rest.
std::string explanation(const Session& session, int frame, double most) {
  const std::vector<int> held = held_by_table(session, frame);
  const auto& positions = session.frames[static_cast<std::size_t>(frame)].positions;
  return explaining_axes(positions(Eigen::all, held), session.rest.positions(Eigen::all, held),
                         most);
}

void warn_of_edges(const Session& session, std::vector<std::string>& warnings) {
  const double end = session.rest.positions.row(row_of(*session.table)).maxCoeff();
  const double most = kTableDrift * std::max(session.sample.width, session.sample.height);
  int count = 0, first = 0;
  for (int f = session.frame_count(); f-- > 0;) {
    if (*session.frames[static_cast<std::size_t>(f)].table_edge <= end + most) continue;
    ++count;
    first = f;
  }
  if (count == 0) return;
  warnings.push_back(fmt::format(
      "the edge of the table is beyond the sheet in {} of {} frames, first in frame {}: at {} "
      "(expected: at most {}, where the sheet ends at rest)",
      count, session.frame_count(), first,
      format_quantity(*session.frames[static_cast<std::size_t>(first)].table_edge,
                      Dimension::length),
      format_quantity(end, Dimension::length)));
}

/// What hangs over an edge is below the table.
void warn_of_rising(const Session& session, std::vector<std::string>& warnings) {
  if (session.gravity.isZero()) return;
  const double most = kTableDrift * std::max(session.sample.width, session.sample.height);
  const Eigen::Vector3d up = -session.gravity.normalized();
  double largest = most;
  int count = 0, worst = 0;
  for (int f = 0; f < session.frame_count(); ++f) {
    const double rise = (up.transpose() * (session.frames[static_cast<std::size_t>(f)].positions -
                                           session.rest.positions))
                            .mean();
    if (rise <= most) continue;
    ++count;
    if (rise <= largest) continue;
    largest = rise;
    worst = f;
  }
  if (count == 0) return;
  warnings.push_back(fmt::format(
      "the sheet rises over the edge of the table in {} of {} frames, most in frame {}: by {} on "
      "average (expected: it hangs down along gravity, [{:.4g}, {:.4g}, {:.4g}])",
      count, session.frame_count(), worst, format_quantity(largest, Dimension::length),
      session.gravity.x(), session.gravity.y(), session.gravity.z()));
}

}  // namespace

std::vector<std::string> table_warnings(const Session& session) {
  std::vector<std::string> warnings;
  if (!session.table) return warnings;
  warn_of_edges(session, warnings);
  warn_of_rising(session, warnings);
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
  if (frames == 0) return warnings;
  warnings.push_back(fmt::format(
      "in {} of {} frames vertices on the table are not at rest, most in frame {}: vertex {} is {} "
      "from its place{} (expected: at most {}, frames in the sheet's own axes)",
      frames, session.frame_count(), at_frame, at_vertex,
      format_quantity(largest, Dimension::length), explanation(session, at_frame, most),
      format_quantity(most, Dimension::length)));
  return warnings;
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
