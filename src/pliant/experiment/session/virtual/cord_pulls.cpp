#include "pliant/experiment/session/virtual/cord_pulls.h"

#include <Eigen/Geometry>

#include "pliant/base/assert.h"

namespace pliant {

std::vector<Eigen::Vector3d> cord_pulls(const Wrench& wrench, const Eigen::Vector3d& centre,
                                        const std::vector<Eigen::Vector3d>& points) {
  PLIANT_ASSERT(points.size() == 2, "a clip has two cords");
  const Eigen::Vector3d middle = (points[0] + points[1]) / 2, arm = (points[0] - points[1]) / 2;
  // F/2 + d and F/2 - d: arm x 2 d is what there is of the moment about the middle.
  const Eigen::Vector3d moment = wrench.moment + (centre - middle).cross(wrench.force);
  const Eigen::Vector3d difference = moment.cross(arm) / (2 * arm.squaredNorm());
  return {wrench.force / 2 + difference, wrench.force / 2 - difference};
}

}  // namespace pliant
