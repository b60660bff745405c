#include "pliant/capture/middle_record.h"

#include <cmath>
#include <limits>

#include "pliant/capture/local_motion.h"

namespace pliant {

MiddleRecord::MiddleRecord(int pull, const Eigen::Vector2d& size)
    : direction(pull == 1 ? "warp" : "weft"),
      length(size(pull) / 3),
      width(size(1 - pull)),
      pull_(pull) {}

bool MiddleRecord::add(const Eigen::Matrix2Xd& rest, const Eigen::Matrix3Xd& moved) {
  std::vector<int> inside;
  for (Eigen::Index i = 0; i < rest.cols(); ++i) {
    const double from_middle = rest(pull_, i) - 1.5 * length;
    if (std::abs(from_middle) <= length / 2) inside.push_back(static_cast<int>(i));
  }
  const auto motion = affine_motion(rest(Eigen::all, inside), moved(Eigen::all, inside));
  if (!motion) return false;
  strain.push_back(motion->slope.col(pull_).norm() - 1);
  lateral_strain.push_back(motion->slope.col(1 - pull_).norm() - 1);
  return true;
}

void MiddleRecord::add_nothing() {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  strain.push_back(kNone);
  lateral_strain.push_back(kNone);
}

}  // namespace pliant
