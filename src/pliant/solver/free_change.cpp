#include "pliant/solver/free_change.h"

namespace pliant {
namespace {

// The share of each unknown: of a free point its own, of a clip the least of its points'.
Eigen::VectorXd of_unknowns(const Coordinates& coordinates, const Eigen::VectorXd& of_points) {
  Eigen::VectorXd shares = Eigen::VectorXd::Ones(coordinates.unknowns());
  for (int i = 0; i < coordinates.points(); ++i) {
    if (coordinates.is_free(i)) {
      shares.segment<3>(3 * coordinates.row(i)).setConstant(of_points(i));
    }
  }
  for (int k = 0; k < coordinates.clips(); ++k) {
    if (coordinates.clip_is_prescribed(k)) continue;
    const double least = of_points(coordinates.clip_points(k)).minCoeff();
    shares.segment<6>(3 * coordinates.clip_row(k)).setConstant(least);
  }
  return shares;
}

}  // namespace

FreeChange free_change(const Objective& objective, const Configuration& at,
                       const Eigen::VectorXd& change) {
  const System& system = objective.system();
  const Coordinates& coordinates = system.coordinates();
  const Configuration there = coordinates.moved(at, change);
  const WayLimits limits = system.way_limits(at, there, objective.conditions());
  const Eigen::VectorXd shares = of_unknowns(coordinates, limits.shares);
  const double least = shares.size() > 0 ? shares.minCoeff() : 1;
  if (least == 1) return {change, change};
  return {change.cwiseProduct(shares), least * change, false, limits.obstructed};
}

Eigen::VectorXd made_way(const Objective& objective, const Configuration& at) {
  const Coordinates& coordinates = objective.system().coordinates();
  const Eigen::Matrix3Xd ways = objective.system().made_way(at, objective.conditions());
  Eigen::VectorXd change = Eigen::VectorXd::Zero(coordinates.unknowns());
  for (int i = 0; i < coordinates.points(); ++i) {
    if (coordinates.is_free(i)) change.segment<3>(3 * coordinates.row(i)) = ways.col(i);
  }
  for (int k = 0; k < coordinates.clips(); ++k) {
    if (coordinates.clip_is_prescribed(k)) continue;
    const Eigen::Matrix3Xd of_clip = ways(Eigen::all, coordinates.clip_points(k));
    Eigen::Index furthest = 0;
    of_clip.colwise().squaredNorm().maxCoeff(&furthest);
    change.segment<3>(3 * coordinates.clip_row(k)) = of_clip.col(furthest);
  }
  return change;
}

}  // namespace pliant
