#include "pliant/measurement/session/unseen_vertices.h"

#include <algorithm>
#include <array>
#include <optional>

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/topology.h"
#include "pliant/measurement/session/table_edges.h"

namespace pliant {
namespace {

SessionFrame& frame_of(Session& session, int frame) {
  return session.frames[static_cast<std::size_t>(frame)];
}

std::vector<int> not_finite(const Eigen::Matrix3Xd& positions) {
  std::vector<int> vertices;
  for (int i = 0; i < positions.cols(); ++i) {
    if (!positions.col(i).allFinite()) vertices.push_back(i);
  }
  return vertices;
}

/// Puts what is held where it is held.
void place_held(Session& session, int frame) {
  SessionFrame& now = frame_of(session, frame);
  const auto place = [&](int vertex, const Eigen::Vector3d& where) {
    if (!now.positions.col(vertex).allFinite()) now.positions.col(vertex) = where;
  };
  for (std::size_t c = 0; c < session.clips.size(); ++c) {
    for (const int vertex : session.clips[c].clamped) {
      place(vertex, now.poses[c].apply(session.rest.positions.col(vertex)));
    }
  }
  for (const int vertex : held_by_table(session, frame)) {
    place(vertex, session.rest.positions.col(vertex));
  }
}

/// Barycentric coordinates of a point in the triangle of three others (rest plane).
Eigen::Vector3d barycentric(const std::array<Eigen::Vector2d, 3>& corners,
                            const Eigen::Vector2d& point) {
  Eigen::Matrix3d affine;
  for (int k = 0; k < 3; ++k) affine.col(k) << corners[static_cast<std::size_t>(k)], 1;
  return affine.inverse() * Eigen::Vector3d(point.x(), point.y(), 1);
}

/// Sums of squares of linear functions of vertices, some of which are unknown.
class LeastSquaresFill {
 public:
  LeastSquaresFill(const Eigen::Matrix3Xd& positions, const std::vector<int>& unknown)
      : positions_(positions),
        unknown_(unknown),
        number_(static_cast<std::size_t>(positions.cols()), -1),
        right_(Eigen::MatrixX3d::Zero(static_cast<Eigen::Index>(unknown.size()), 3)) {
    for (std::size_t i = 0; i < unknown.size(); ++i) {
      number_[static_cast<std::size_t>(unknown[i])] = static_cast<int>(i);
    }
  }

  /// Adds weight |sum_i factor_i x_i - offset|^2.
  template <std::size_t N>
  void add(const std::array<int, N>& vertices, const std::array<double, N>& factors, double weight,
           const Eigen::Vector3d& offset) {
    Eigen::Vector3d known = -offset;
    for (std::size_t i = 0; i < N; ++i) {
      if (number_of(vertices[i]) < 0) known += factors[i] * positions_.col(vertices[i]);
    }
    for (std::size_t i = 0; i < N; ++i) {
      const int row = number_of(vertices[i]);
      if (row < 0) continue;
      right_.row(row) -= weight * factors[i] * known.transpose();
      for (std::size_t j = 0; j < N; ++j) {
        const int column = number_of(vertices[j]);
        if (column >= 0) entries_.emplace_back(row, column, weight * factors[i] * factors[j]);
      }
    }
  }

  /// The unknown vertices (one row each); nothing where something says nothing of them.
  std::optional<Eigen::MatrixX3d> solve() const {
    const auto size = static_cast<Eigen::Index>(unknown_.size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success) return std::nullopt;
    const Eigen::MatrixX3d found = solver.solve(right_);
    return found.allFinite() ? std::optional(found) : std::nullopt;
  }

 private:
  int number_of(int vertex) const { return number_[static_cast<std::size_t>(vertex)]; }

  const Eigen::Matrix3Xd& positions_;
  const std::vector<int>& unknown_;
  std::vector<int> number_;  // of the unknown; -1: known
  Eigen::MatrixX3d right_;
  std::vector<Eigen::Triplet<double>> entries_;
};

/// The corner of a triangle that is not on one of its edges.
int opposite(const TriangleMesh& mesh, int triangle, const MeshEdge& edge) {
  return mesh.triangles.col(triangle).sum() - edge.vertices[0] - edge.vertices[1];
}

/// @return whether all positions are known then
bool continue_smoothly(const TriangleMesh& rest, const std::vector<int>& unknown,
                       Eigen::Matrix3Xd& positions) {
  constexpr double kFaint = 1e-6;  // decides where no pair of triangles does
  LeastSquaresFill fill(positions, unknown);
  const auto at = [&](int vertex) -> Eigen::Vector2d {
    return rest.positions.col(vertex).head<2>();
  };
  for (const MeshEdge& edge : find_edges(rest.triangles)) {
    const int a = edge.vertices[0], b = edge.vertices[1];
    fill.add<2>({a, b}, {1, -1}, kFaint, rest.positions.col(a) - rest.positions.col(b));
    if (edge.triangles[0] < 0 || edge.triangles[1] < 0) continue;
    const int c = opposite(rest, edge.triangles[0], edge);
    const int d = opposite(rest, edge.triangles[1], edge);
    const Eigen::Vector3d share = barycentric({at(a), at(b), at(c)}, at(d));
    fill.add<4>({a, b, c, d}, {-share[0], -share[1], -share[2], 1}, 1, Eigen::Vector3d::Zero());
  }
  const auto found = fill.solve();
  if (!found) return false;
  positions(Eigen::all, unknown) = found->transpose();
  return true;
}

std::string names_of(const std::vector<int>& vertices) {
  constexpr std::size_t kNamed = 5;
  const auto end =
      vertices.begin() + static_cast<std::ptrdiff_t>(std::min(kNamed, vertices.size()));
  return fmt::format("{}{}", fmt::join(vertices.begin(), end, ", "),
                     vertices.size() > kNamed ? ", ..." : "");
}

}  // namespace

std::vector<std::string> fill_in_unseen(Session& session, const FrameNames& names) {
  int count = 0, worst = 0;
  for (int f = 0; f < session.frame_count(); ++f) {
    SessionFrame& frame = frame_of(session, f);
    frame.unseen = not_finite(frame.positions);
    if (frame.unseen.empty()) continue;
    place_held(session, f);
    const std::vector<int> unknown = not_finite(frame.positions);
    const double known =
        static_cast<double>(session.rest.vertex_count()) - static_cast<double>(unknown.size());
    const bool enough = known >= kSeenShare * session.rest.vertex_count();
    if (!enough ||
        (!unknown.empty() && !continue_smoothly(session.rest, unknown, frame.positions))) {
      throw InputError(
          {names.file(f).string()},
          fmt::format("frame {}: {} of {} vertices have no position (vertex {})", f,
                      frame.unseen.size(), session.rest.vertex_count(), names_of(frame.unseen)),
          fmt::format("finite coordinates of {:.0f} % of them at least", 100 * kSeenShare));
    }
    ++count;
    if (frame.unseen.size() > frame_of(session, worst).unseen.size()) worst = f;
  }
  if (count == 0) return {};
  const std::vector<int>& most = frame_of(session, worst).unseen;
  return {fmt::format(
      "in {} of {} frames vertices were not seen, most in frame {}: {} of {} (vertex {}); they are "
      "left out where positions are compared",
      count, session.frame_count(), worst, most.size(), session.rest.vertex_count(),
      names_of(most))};
}

std::vector<std::string> outlier_warnings(const Session& session) {
  const std::vector<MeshEdge> edges = find_edges(session.rest.triangles);
  int count = 0, worst = 0;
  std::array<int, 2> ends{};
  double largest = 0;
  for (int f = 0; f < session.frame_count(); ++f) {
    const Eigen::Matrix3Xd& now = session.frames[static_cast<std::size_t>(f)].positions;
    double longest = 0;
    for (const MeshEdge& edge : edges) {
      const auto length = [&](const Eigen::Matrix3Xd& at) {
        return (at.col(edge.vertices[0]) - at.col(edge.vertices[1])).norm();
      };
      const double stretch = length(now) / length(session.rest.positions);
      longest = std::max(longest, stretch);
      if (stretch <= std::max(largest, kLongestEdge)) continue;
      largest = stretch;
      worst = f;
      ends = {edge.vertices[0], edge.vertices[1]};
    }
    if (longest > kLongestEdge) ++count;
  }
  if (count == 0) return {};
  return {fmt::format(
      "in {} of {} frames edges are more than {} times as long as at rest, most in frame {}: "
      "between the vertices {} and {} {:.3g} times (expected: nan for vertices that were not seen)",
      count, session.frame_count(), kLongestEdge, worst, ends[0], ends[1], largest)};
}

}  // namespace pliant
