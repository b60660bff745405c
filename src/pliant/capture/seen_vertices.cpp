#include "pliant/capture/seen_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/capture/local_motion.h"
#include "pliant/capture/median.h"
#include "pliant/capture/near_places.h"

namespace pliant {

SeenVertices VertexPlaces::of(const TriangleMesh& mesh, const Eigen::Matrix2Xd& rest,
                              const Eigen::Matrix3Xd& moved, const Eigen::VectorXd& patches,
                              bool at_rest) {
  constexpr double kReach = 2.3;      // points that tell a vertex, in spacings: some sixteen
  constexpr double kBentReach = 3.3;  // in space: some thirty
  constexpr double kGap = 1.25;       // the nearest of them
  constexpr double kRim = 0.6;        // or as near, in sides of its square
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  LocalMotion motion(rest, moved, (in_space_ ? kBentReach : kReach) * spacing_);
  if (in_space_) motion.bend(patches);
  // All of a square is seen, its rim too.
  const double gap = std::max(kGap * spacing_, kRim * patch_);
  const int count = mesh.vertex_count();
  SeenVertices seen{Eigen::Matrix3Xd::Constant(3, count, kNone), Eigen::VectorXd::Ones(count)};
  for (int v = 0; v < count; ++v) {
    const auto place = motion.at(mesh.positions.col(v).head<2>(), gap);
    if (!place) continue;
    seen.positions.col(v) = place->position;
    seen.leverages(v) = place->leverage;
    if (at_rest) continue;
    // Of a flat test the third coordinate misses nothing.
    residuals_.push_back(place->residual * (in_space_ ? 1 : 1.5));
    leverage_ += place->leverage;
  }
  return seen;
}

double VertexPlaces::point_noise() const { return std::sqrt(median(residuals_)); }

std::optional<double> VertexPlaces::noise() const {
  const double points = point_noise();
  if (!(points > 0)) return std::nullopt;
  return points * std::sqrt(leverage_ / static_cast<double>(residuals_.size()));
}

Eigen::Matrix3Xd vertex_deviations(const TriangleMesh& mesh, const Eigen::Matrix2Xd& places,
                                   const Eigen::Matrix3Xd& of_points,
                                   const Eigen::VectorXd& leverages, double reach) {
  const NearPlaces near(places, reach);
  const Eigen::Vector3d largest = of_points.rowwise().maxCoeff();
  Eigen::Matrix3Xd deviations = largest.replicate(1, mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const auto point = near.nearest(mesh.positions.col(v).head<2>());
    if (point) deviations.col(v) = of_points.col(*point);
    deviations.col(v) *= std::sqrt(std::max(1.0, leverages(v)));
  }
  return deviations;
}

}  // namespace pliant
