#include "pliant/measurement/session/clip_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "pliant/geometry/regular_grid.h"

namespace pliant {
namespace {

/// Lines that are closer together are one, in edges.
constexpr double kClosest = 0.25;
constexpr int kFewestCells = 2;

/// Where the edges of clips cross an axis, in order.
std::vector<double> clip_edges(const Session& session, int axis) {
  std::vector<double> edges;
  for (const SessionClip& clip : session.clips) {
    const Eigen::VectorXd places = session.rest.positions(axis, clip.clamped).transpose();
    edges.push_back(places.minCoeff());
    edges.push_back(places.maxCoeff());
  }
  std::ranges::sort(edges);
  return edges;
}

/// The sides `low` and `high` and what lies between them, each number at least `closest` from the
/// next.
/// @param between  in order
std::vector<double> apart(double low, double high, const std::vector<double>& between,
                          double closest) {
  std::vector<double> lines{low};
  for (auto first = between.begin(); first != between.end();) {
    const auto last =
        std::find_if(first, between.end(), [&](double place) { return place - *first >= closest; });
    const double mean = std::accumulate(first, last, 0.0) / static_cast<double>(last - first);
    if (mean - lines.back() >= closest && high - mean >= closest) lines.push_back(mean);
    first = last;
  }
  lines.push_back(high);
  return lines;
}

std::vector<double> lines_along(const Session& session, int axis, double edge) {
  const auto rest = session.rest.positions.row(axis);
  const double middle = (rest.minCoeff() + rest.maxCoeff()) / 2;
  const double half = (axis == 0 ? session.sample.width : session.sample.height) / 2;
  return lines_on_stops(middle - half, middle + half, clip_edges(session, axis), edge);
}

}  // namespace

std::vector<double> lines_on_stops(double low, double high, const std::vector<double>& stops,
                                   double edge) {
  const std::vector<double> ends = apart(low, high, stops, kClosest * edge);
  std::vector<double> lines{ends.front()};
  const int fewest = ends.size() == 2 ? kFewestCells : 1;
  for (std::size_t s = 1; s < ends.size(); ++s) {
    const double from = ends[s - 1], length = ends[s] - from;
    const int cells = std::max(static_cast<int>(std::lround(length / edge)), fewest);
    for (int i = 1; i < cells; ++i) lines.push_back(from + length * i / cells);
    lines.push_back(ends[s]);
  }
  return lines;
}

TriangleMesh grid_on_clips(const Session& session, double edge) {
  return grid_of_lines(lines_along(session, 0, edge), lines_along(session, 1, edge));
}

}  // namespace pliant
