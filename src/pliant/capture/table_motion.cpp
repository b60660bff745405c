#include "pliant/capture/table_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pliant {
namespace {

constexpr int kFewest = 6;  // points on the table

struct RigidPoints {
  Eigen::Isometry3d motion;
  int count = 0;
};

/// Of the points below a coordinate.
std::optional<RigidPoints> motion_below(const Eigen::Matrix3Xd& rest, const Eigen::Matrix3Xd& moved,
                                        Eigen::Index axis, double below) {
  std::vector<Eigen::Index> held;
  for (Eigen::Index i = 0; i < rest.cols(); ++i) {
    if (rest(axis, i) < below) held.push_back(i);
  }
  if (std::ssize(held) < kFewest) return std::nullopt;
  RigidPoints points;
  points.motion.matrix() = Eigen::umeyama(Eigen::Matrix3Xd(rest(Eigen::all, held)),
                                          Eigen::Matrix3Xd(moved(Eigen::all, held)), false);
  points.count = static_cast<int>(held.size());
  return points;
}

}  // namespace

std::optional<PushedSheet> pushed_sheet(const Eigen::Matrix3Xd& rest, const Eigen::Matrix3Xd& moved,
                                        const DicTable& table, double middle, double before,
                                        double margin) {
  constexpr int kMostRounds = 20;
  const auto axis = static_cast<Eigen::Index>(table.axis);
  Eigen::Vector3d on_edge = table.edge * Eigen::Vector3d::Unit(axis);
  on_edge(1 - axis) = middle;
  // From what lies on it even if the sheet was pushed far, to all of it.
  const double low = rest.row(axis).minCoeff();
  double edge = low + (before - low) / 2;
  std::optional<PushedSheet> found;
  for (int round = 0; round < kMostRounds; ++round) {
    const auto points = motion_below(rest, moved, axis, edge - margin);
    if (!points) return found;
    const Eigen::Isometry3d back = points->motion.inverse();
    const double now = (back * on_edge)(axis);
    const Eigen::Vector3d along = back.linear().col(1 - axis);
    found =
        PushedSheet{points->motion, now, std::atan2(along(axis), along(1 - axis)), points->count};
    if (std::abs(now - edge) < margin / 100) break;
    edge = now;
  }
  return found;
}

}  // namespace pliant
