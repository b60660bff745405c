#include "pliant/experiment/session/sheet_states.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/experiment/session/sheet_system.h"
#include "pliant/geometry/mesh_quality.h"
#include "pliant/geometry/topology.h"

namespace pliant {
namespace {

/// Coordinates of nodes nearer than this part of an edge are one row's.
constexpr double kSameRow = 1e-3;

Eigen::RowVectorXd along_table(const Session& session) {
  return session.rest.positions.row(static_cast<int>(*session.table));
}

/// Coordinates at which the table may end: the rows of a regular grid, else every mean edge.
std::vector<double> row_coordinates(const Session& session) {
  const Eigen::RowVectorXd along = along_table(session);
  const double edge = mesh_quality(session.rest).mean_edge;
  std::vector<double> sorted(along.begin(), along.end());
  std::ranges::sort(sorted);
  std::vector<double> rows;
  for (const double place : sorted) {
    if (rows.empty() || place - rows.back() > kSameRow * edge) rows.push_back(place);
  }
  const double length = sorted.back() - sorted.front();
  if (static_cast<double>(rows.size()) * edge <= 2 * length) return rows;
  const auto count = static_cast<int>(length / edge);
  rows.clear();
  for (int i = 0; i <= count; ++i) rows.push_back(sorted.front() + i * length / count);
  return rows;
}

/// What a side of a triangle at rest adds to the stiffness against bending along an axis: its share
/// of the area, by the fourth power of the cosine between the curvature that it carries and the
/// axis.
double bending_share(const Eigen::Vector2d& side, double area, int axis) {
  const double across = side(1 - axis) / side.norm();
  return area / 3 * std::pow(across, 4);
}

/// Leaves out what no frame needs; a state's first guess is the frame that is nearest to it.
SheetStates without_idle(const SheetStates& all) {
  std::vector<int> number(all.states.size(), -1);
  std::vector<double> nearest(all.states.size(), 2);
  SheetStates result;
  const auto use = [&](int state, int frame, double distance) {
    const auto s = static_cast<std::size_t>(state);
    if (number[s] < 0) {
      number[s] = static_cast<int>(result.states.size());
      result.states.push_back(all.states[s]);
    }
    if (distance < nearest[s]) {
      nearest[s] = distance;
      result.states[static_cast<std::size_t>(number[s])].frame = frame;
    }
    return number[s];
  };
  for (int frame = 0; frame < static_cast<int>(all.frames.size()); ++frame) {
    const SheetBlend& blend = all.frames[static_cast<std::size_t>(frame)];
    const int first = blend.share < 1 ? use(blend.first, frame, blend.share) : -1;
    const int second = blend.share > 0 ? use(blend.second, frame, 1 - blend.share) : -1;
    if (first < 0)
      result.frames.push_back({second, second, 0});
    else if (second < 0)
      result.frames.push_back({first, first, 0});
    else
      result.frames.push_back({first, second, blend.share});
  }
  return result;
}

}  // namespace

double edge_of_held(const Session& session, const std::vector<int>& held) {
  const auto axis = static_cast<int>(*session.table);
  std::vector<char> is_held(static_cast<std::size_t>(session.rest.vertex_count()), 0);
  for (const int node : held) is_held[static_cast<std::size_t>(node)] = 1;
  const auto triangle_is_held = [&](int t) {
    return std::ranges::all_of(session.rest.triangles.col(t), [&](int node) {
      return is_held[static_cast<std::size_t>(node)] != 0;
    });
  };
  double rigid = 0, all = 0;
  for (const MeshEdge& edge : find_edges(session.rest.triangles)) {
    const Eigen::Vector2d side = (session.rest.positions.col(edge.vertices[1]) -
                                  session.rest.positions.col(edge.vertices[0]))
                                     .head<2>();
    double share = 0;
    bool bends = false;
    for (const int t : edge.triangles) {
      if (t < 0) continue;
      share += bending_share(side, rest_area(session.rest, t), axis);
      bends = bends || !triangle_is_held(t);
    }
    all += share;
    if (!bends) rigid += share;
  }
  const Eigen::RowVectorXd along = along_table(session);
  return along.minCoeff() + (along.maxCoeff() - along.minCoeff()) * rigid / all;
}

SheetStates states_on_table(const Session& session) {
  PLIANT_ASSERT(session.table.has_value(), "a table holds the sheet");
  SheetStates result;
  std::vector<double> edges;
  for (const double row : row_coordinates(session)) {
    SheetState state{0, held_nodes(session, row)};
    const double edge = edge_of_held(session, state.held);
    if (edge <= 0 || (!edges.empty() && edge <= edges.back())) continue;
    edges.push_back(edge);
    result.states.push_back(std::move(state));
  }
  PLIANT_ASSERT(!edges.empty(), "a mesh has rows");
  for (const SessionFrame& frame : session.frames) {
    const auto next = std::ranges::upper_bound(edges, *frame.table_edge);
    const int second = std::clamp(static_cast<int>(next - edges.begin()), 1,
                                  std::max(static_cast<int>(edges.size()) - 1, 1));
    const int first = second - 1;
    if (edges.size() == 1) {
      result.frames.push_back({0, 0, 0});
      continue;
    }
    const double low = edges[static_cast<std::size_t>(first)];
    const double high = edges[static_cast<std::size_t>(second)];
    const double share = std::clamp((*frame.table_edge - low) / (high - low), 0.0, 1.0);
    result.frames.push_back({first, second, share});
  }
  return result;
}

SheetStates sheet_states(const Session& session) {
  if (session.table) return without_idle(states_on_table(session));
  SheetStates result;
  const std::vector<int> held = held_nodes(session, std::nullopt);
  for (int frame = 0; frame < session.frame_count(); ++frame) {
    result.states.push_back({frame, held});
    result.frames.push_back({frame, frame, 0});
  }
  return result;
}

}  // namespace pliant
