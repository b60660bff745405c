#include "pliant/capture/unrolled_sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include "pliant/capture/near_places.h"

namespace pliant {
namespace {

/// Around a point its neighbours, in its tangent plane, as far as they are along the surface.
struct Surroundings {
  std::vector<int> near;
  Eigen::Matrix2Xd offsets;  // m
};

/// Of each point the others that are near it, as it is seen from above.
std::vector<std::vector<int>> neighbours_of(const Eigen::Matrix3Xd& points, double reach) {
  const NearPlaces places(points.topRows<2>(), reach);
  std::vector<std::vector<int>> near;
  for (int i = 0; i < static_cast<int>(points.cols()); ++i) {
    near.push_back(places.around(points.col(i).head<2>()));
    std::erase(near.back(), i);
  }
  return near;
}

class Surface {
 public:
  Surface(const Eigen::Matrix3Xd& points, double reach)
      : points_(points), near_(neighbours_of(points, reach)) {
    for (Eigen::Index i = 0; i < points.cols(); ++i) normals_.push_back(normal_at(i));
  }

  Surroundings around(Eigen::Index i) const {
    const Eigen::Vector3d& normal = normals_[static_cast<std::size_t>(i)];
    const Eigen::Vector3d first = (Eigen::Vector3d::UnitX() - normal.x() * normal).normalized();
    const Eigen::Vector3d second = normal.cross(first);
    Surroundings result{near_[static_cast<std::size_t>(i)], {}};
    result.offsets.resize(2, std::ssize(result.near));
    for (Eigen::Index k = 0; k < result.offsets.cols(); ++k) {
      const int other = result.near[static_cast<std::size_t>(k)];
      const Eigen::Vector3d way = points_.col(other) - points_.col(i);
      const Eigen::Vector2d along(first.dot(way), second.dot(way));
      result.offsets.col(k) =
          arc(way.norm(), normal, normals_[static_cast<std::size_t>(other)]) * along.normalized();
    }
    return result;
  }

 private:
  /// Of the plane through a point and its neighbours.
  Eigen::Vector3d normal_at(Eigen::Index i) const {
    const std::vector<int>& near = near_[static_cast<std::size_t>(i)];
    const Eigen::Matrix3Xd around = points_(Eigen::all, near);
    const Eigen::Matrix3Xd centred = around.colwise() - around.rowwise().mean();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(centred * centred.transpose());
    const Eigen::Vector3d normal = spread.eigenvectors().col(0);
    return normal.z() < 0 ? Eigen::Vector3d(-normal) : normal;
  }

  /// Of a circle, by its chord and how its normal turns.
  static double arc(double chord, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const double turn = from.cross(to).norm();
    return chord * (1 + turn * turn / 24);
  }

  const Eigen::Matrix3Xd& points_;
  std::vector<std::vector<int>> near_;
  std::vector<Eigen::Vector3d> normals_;
};

/// The rotation that takes the offsets nearest to where the neighbours are.
Eigen::Matrix2d turn_of(const Surroundings& own, const Eigen::Matrix2Xd& places, Eigen::Index i) {
  Eigen::Matrix2d both = Eigen::Matrix2d::Zero();
  for (Eigen::Index k = 0; k < own.offsets.cols(); ++k) {
    const int other = own.near[static_cast<std::size_t>(k)];
    both += (places.col(other) - places.col(i)) * own.offsets.col(k).transpose();
  }
  const double sine = both(1, 0) - both(0, 1), cosine = both(0, 0) + both(1, 1);
  return Eigen::Rotation2Dd(std::atan2(sine, cosine)).toRotationMatrix();
}

Eigen::SparseMatrix<double> laplacian_of(const std::vector<Surroundings>& surroundings) {
  std::vector<Eigen::Triplet<double>> entries{{0, 0, 1.0}};  // the first is held: shifts are free
  for (int i = 0; i < static_cast<int>(surroundings.size()); ++i) {
    for (const int other : surroundings[static_cast<std::size_t>(i)].near) {
      entries.insert(entries.end(), {{i, i, 1}, {other, other, 1}, {i, other, -1}, {other, i, -1}});
    }
  }
  const auto size = std::ssize(surroundings);
  Eigen::SparseMatrix<double> laplacian(size, size);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

double stretch_of(const std::vector<Surroundings>& surroundings, const Eigen::Matrix2Xd& places) {
  double squares = 0;
  int count = 0;
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    const Surroundings& own = surroundings[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k < own.offsets.cols(); ++k) {
      const int other = own.near[static_cast<std::size_t>(k)];
      const double length = own.offsets.col(k).norm();
      const double miss = (places.col(other) - places.col(i)).norm() / length - 1;
      squares += miss * miss;
      ++count;
    }
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

/// Of points that are connected.
UnrolledSheet unrolled_piece(const Eigen::Matrix3Xd& points, double reach) {
  constexpr int kRounds = 2000;
  constexpr double kSmall = 1e-5;  // of the reach
  const Surface surface(points, reach);
  std::vector<Surroundings> surroundings;
  for (Eigen::Index i = 0; i < points.cols(); ++i) surroundings.push_back(surface.around(i));
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(laplacian_of(surroundings));
  const Eigen::Matrix2Xd start = points.topRows<2>();
  Eigen::Matrix2Xd places = start;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(points.cols(), 2);
    right.row(0) = start.col(0).transpose();
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const Surroundings& own = surroundings[static_cast<std::size_t>(i)];
      const Eigen::Matrix2Xd ways = turn_of(own, places, i) * own.offsets;
      for (Eigen::Index k = 0; k < ways.cols(); ++k) {
        right.row(i) -= ways.col(k).transpose();
        right.row(own.near[static_cast<std::size_t>(k)]) += ways.col(k).transpose();
      }
    }
    const Eigen::Matrix2Xd next = solver.solve(right).transpose();
    const double moved = (next - places).colwise().norm().maxCoeff();
    places = next;
    if (moved < kSmall * reach) break;
  }
  // Over where it was seen.
  const Eigen::Matrix3d rigid = Eigen::umeyama(places, start, /*with_scaling=*/false);
  return {(rigid.topLeftCorner<2, 2>() * places).colwise() + rigid.topRightCorner<2, 1>(),
          stretch_of(surroundings, places)};
}

/// Points of the largest connected piece, each with enough others around it to tell a plane.
std::vector<int> largest_piece(const Eigen::Matrix3Xd& points, double reach) {
  constexpr std::size_t kFewest = 5;
  const std::vector<std::vector<int>> near = neighbours_of(points, reach);
  std::vector<bool> is_taken(near.size(), false);
  std::vector<int> largest;
  for (std::size_t first = 0; first < near.size(); ++first) {
    if (is_taken[first] || near[first].size() < kFewest) continue;
    std::vector<int> piece{static_cast<int>(first)};
    is_taken[first] = true;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      for (const int other : near[static_cast<std::size_t>(piece[k])]) {
        const auto next = static_cast<std::size_t>(other);
        if (is_taken[next] || near[next].size() < kFewest) continue;
        is_taken[next] = true;
        piece.push_back(other);
      }
    }
    if (piece.size() > largest.size()) largest = std::move(piece);
  }
  std::ranges::sort(largest);
  return largest;
}

}  // namespace

UnrolledSheet unrolled(const Eigen::Matrix3Xd& points, double reach) {
  const std::vector<int> piece = largest_piece(points, reach);
  UnrolledSheet sheet{points.topRows<2>(), 0};
  if (piece.empty()) return sheet;
  const UnrolledSheet own = unrolled_piece(points(Eigen::all, piece), reach);
  sheet.stretch = own.stretch;
  const Eigen::Matrix2Xd shown = sheet.places(Eigen::all, piece);
  for (auto place : sheet.places.colwise()) {
    Eigen::Index nearest = 0;
    (shown.colwise() - place).colwise().squaredNorm().minCoeff(&nearest);
    place += own.places.col(nearest) - shown.col(nearest);
  }
  return sheet;
}

}  // namespace pliant
