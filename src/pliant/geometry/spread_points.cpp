#include "pliant/geometry/spread_points.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"

namespace pliant {

std::vector<int> spread_points(const Eigen::Matrix3Xd& points, int count) {
  PLIANT_ASSERT(count > 0 && count <= points.cols(), "so many points are there");
  const auto squares_from = [&](const Eigen::Vector3d& place) -> Eigen::RowVectorXd {
    return (points.colwise() - place).colwise().squaredNorm();
  };
  int next = 0;
  squares_from(points.rowwise().mean()).minCoeff(&next);
  std::vector<int> taken{next};
  Eigen::RowVectorXd nearest = squares_from(points.col(next));
  while (static_cast<int>(taken.size()) < count) {
    nearest.maxCoeff(&next);
    taken.push_back(next);
    nearest = nearest.cwiseMin(squares_from(points.col(next)));
  }
  return taken;
}

std::vector<Eigen::Vector3d> middles_of_cells(const Eigen::Vector3d& low,
                                              const Eigen::Vector3d& size,
                                              const Eigen::Vector3i& cells) {
  std::vector<Eigen::Vector3d> middles;
  for (int z = 0; z < cells.z(); ++z) {
    for (int y = 0; y < cells.y(); ++y) {
      for (int x = 0; x < cells.x(); ++x) {
        const Eigen::Array3d share = (Eigen::Array3d(x, y, z) + 0.5) / cells.cast<double>().array();
        middles.emplace_back(low + (size.array() * share).matrix());
      }
    }
  }
  return middles;
}

double spacing_of_neighbours(const std::vector<Eigen::Vector3d>& places) {
  if (places.size() < 2) return 0;
  double sum = 0;
  for (const Eigen::Vector3d& own : places) {
    double nearest = INFINITY;
    for (const Eigen::Vector3d& other : places) {
      if (&other != &own) nearest = std::min(nearest, (other - own).norm());
    }
    sum += nearest;
  }
  return sum / static_cast<double>(places.size());
}

}  // namespace pliant
