#include "pliant/estimation/sheet/independent_rows.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pliant/estimation/statistics/correlation_length.h"
#include "pliant/geometry/topology.h"

namespace pliant {
namespace {

double length_along_frames(const SheetTest& test, const Eigen::VectorXd& differences) {
  std::vector<ResidualSeries> series;
  for (const std::vector<int>& rows : test.series()) {
    ResidualSeries& own = series.emplace_back();
    for (const int row : rows) own.push_back(differences(row));
  }
  return correlation_length(series, /*leverage=*/0);
}

/// Of the differences at both ends of the edges of the mesh, within each frame; at least 0.
double correlation_along_edges(const SheetTest& test, const Eigen::VectorXd& differences) {
  const std::vector<MeshEdge> edges = find_edges(test.session().rest.triangles);
  double products = 0, squares = 0;
  const std::vector<Frame> frames = test.frames();
  for (int frame = 0; frame < test.frame_count(); ++frame) {
    std::vector<int> row(static_cast<std::size_t>(test.session().rest.vertex_count()), -1);
    int next = frames[static_cast<std::size_t>(frame)].first;
    for (const int node : test.compared_nodes(frame)) {
      row[static_cast<std::size_t>(node)] = next;
      next += 3;
    }
    for (const MeshEdge& edge : edges) {
      const auto [a, b] = edge.vertices;
      const int first = row[static_cast<std::size_t>(a)], second = row[static_cast<std::size_t>(b)];
      if (first < 0 || second < 0) continue;
      const Eigen::Vector3d one = differences.segment<3>(first),
                            other = differences.segment<3>(second);
      products += 2 * one.dot(other);
      squares += one.squaredNorm() + other.squaredNorm();
    }
  }
  return squares > 0 ? std::max(products / squares, 0.0) : 0;
}

}  // namespace

double independent_rows(const SheetTest& test, const Eigen::VectorXd& differences) {
  constexpr double kMost = 0.99;  // of correlations along edges
  const double r = std::min(correlation_along_edges(test, differences), kMost);
  const double together = length_along_frames(test, differences) * std::pow((1 + r) / (1 - r), 2);
  return static_cast<double>(test.rows()) / together;
}

double own_scatter(const SheetTest& test, const Eigen::VectorXd& differences) {
  const double r = std::min(correlation_along_edges(test, differences), 1.0);
  return std::sqrt((1 - r) * differences.squaredNorm() / static_cast<double>(differences.size()));
}

}  // namespace pliant
