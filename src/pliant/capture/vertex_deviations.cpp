#include "pliant/capture/vertex_deviations.h"

#include <algorithm>
#include <cmath>

#include "pliant/capture/near_places.h"

namespace pliant {

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
