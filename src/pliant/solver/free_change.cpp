#include "pliant/solver/free_change.h"

#include <algorithm>

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

// Of a free point, or of a clip that only shifts.
double largest_way(const Coordinates& coordinates, const Eigen::VectorXd& change) {
  double largest = 0;
  for (int i = 0; i < coordinates.points(); ++i) {
    if (!coordinates.is_free(i)) continue;
    largest = std::max(largest, change.segment<3>(3 * coordinates.row(i)).norm());
  }
  for (int k = 0; k < coordinates.clips(); ++k) {
    if (coordinates.clip_is_prescribed(k)) continue;
    largest = std::max(largest, change.segment<3>(3 * coordinates.clip_row(k)).norm());
  }
  return largest;
}

double least_of_led(const Eigen::VectorXd& of_points, const Eigen::Matrix3Xd& led) {
  double least = 1;
  for (Eigen::Index i = 0; i < led.cols(); ++i) {
    if (!led.col(i).isZero(0)) least = std::min(least, of_points(i));
  }
  return least;
}

bool has_free_clips(const Coordinates& coordinates) {
  for (int k = 0; k < coordinates.clips(); ++k) {
    if (!coordinates.clip_is_prescribed(k)) return true;
  }
  return false;
}

}  // namespace

bool part_is_free(const Objective& objective, const Configuration& from, const Configuration& to) {
  constexpr double kKept = 0.01;  // less than free_change ever does
  const System& system = objective.system();
  if (!system.obstructs() || !has_free_clips(system.coordinates())) return true;
  return !objective.way_limits(from, to, kKept).obstructed;
}

// What points keep each other from changes as they are shortened: the shortened change is looked at
// again, with a little less distance to keep, until nothing is in its way.
FreeChange free_change(const Objective& objective, const Configuration& at,
                       const Eigen::VectorXd& change, const Eigen::Matrix3Xd& led) {
  constexpr int kRounds = 8, kMostHalvings = 30;
  constexpr double kKept = 0.2, kLess = 0.8;
  const Coordinates& coordinates = objective.system().coordinates();
  FreeChange free{change, change};
  const auto end_of = [&](const Eigen::VectorXd& each) {
    Configuration end = coordinates.moved(at, each);
    if (led.size() > 0) end.positions += free.led * led;
    return end;
  };
  double alike = 1, kept = kKept;
  bool obstructed = false;
  for (int round = 0; round < kRounds; ++round, kept *= kLess) {
    const WayLimits limits = objective.way_limits(at, end_of(free.each), kept);
    const Eigen::VectorXd shares = of_unknowns(coordinates, limits.shares);
    const double of_led = least_of_led(limits.shares, led);
    const double least = std::min(of_led, shares.size() > 0 ? shares.minCoeff() : 1);
    if (least == 1) return free;
    if (round == 0) {
      free.whole = false;
      free.alike = least * change;
      alike = least;
    }
    obstructed |= limits.obstructed;
    free.each = free.each.cwiseProduct(shares);
    free.led *= of_led;
    free.lost = obstructed ? largest_way(coordinates, change - free.each) : 0;
  }
  free.led = alike;
  for (int halvings = 0; !part_is_free(objective, at, end_of(free.alike)); ++halvings) {
    const double less = halvings < kMostHalvings ? 0.5 : 0;
    free.alike *= less;
    free.led *= less;
  }
  free.each = free.alike;
  free.lost = largest_way(coordinates, change - free.each);
  return free;
}

std::optional<Eigen::VectorXd> made_way(const Objective& objective, const Configuration& led) {
  const Coordinates& coordinates = objective.system().coordinates();
  const auto found = objective.made_way(led.positions);
  if (!found) return std::nullopt;
  const Eigen::Matrix3Xd& ways = *found;
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
