#include "pliant/solver/elastica/strip_front.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/LU>

#include "pliant/material/bending_strain.h"
#include "pliant/material/snapping_strains.h"
#include "pliant/math/root.h"
#include "pliant/solver/elastica/point_moment.h"

namespace pliant {
namespace {

using Eigen::Index;

/// Between the points `first` and `first` + 1.
struct Front {
  Index first = 0;
  Index curled = 0;    ///< the point at it that has not snapped
  Index next = 0;      ///< the one behind that
  double place = 0;    ///< up to where the weights of the points before it reach (m)
  double between = 0;  ///< the same as a share of the way from `first` to the next point
};

PointMoment moment_at(const ComponentLaw& law, const StripHistory& history, Index i,
                      double curvature) {
  return point_moment(law, history, i, curvature, history.curvature_by_parameter.size() > 0);
}

// The curvature on the way back from the start below which a point snaps.
std::optional<double> snapping_curvature(const ComponentLaw& law, const StripHistory& start) {
  constexpr int kSamples = 64;
  const double from = start.curvature(0);
  if (law.friction_law != FrictionLaw::dahl || law.addends_remember() || from == 0 ||
      snapping_strains(law, from > 0 ? 1 : -1, kStrainPerCurvature * from).empty()) {
    return std::nullopt;
  }
  const auto tangent = [&](double share) { return moment_at(law, start, 0, share * from).tangent; };
  for (int i = kSamples - 1; i > 0; --i) {
    const double share = static_cast<double>(i) / kSamples;
    if (tangent(share) >= 0) continue;
    return from * root_in_bracket(tangent, share, share + 1.0 / kSamples);
  }
  return std::nullopt;
}

std::vector<Front> fronts_of(const GaussLine& line, const Eigen::VectorXd& curvature,
                             double snapping) {
  const auto snapped = [&](Index i) { return curvature(i) / snapping < 1; };
  std::vector<Front> fronts;
  double reached = 0;
  for (Index i = 0; i + 1 < line.size(); ++i) {
    reached += line.weights()(i);
    if (snapped(i) == snapped(i + 1)) continue;
    Front front{i, i, std::max<Index>(i - 1, 0), reached};
    if (snapped(i)) front = {i, i + 1, std::min<Index>(i + 2, line.size() - 1), reached};
    const double from = line.places()(i);
    front.between = (reached - from) / (line.places()(i + 1) - from);
    fronts.push_back(front);
  }
  return fronts;
}

// A point that is about to snap has hardly a tangent, but only for a small change: what it gives
// way to a change like that from point to point is the chord to the next.
Eigen::VectorXd least_tangents(const ComponentLaw& law, const StripHistory& before,
                               const StripShape& shape, const std::vector<Front>& fronts) {
  Eigen::VectorXd least = Eigen::VectorXd::Constant(shape.curvature.size(), -1e300);
  for (const Front& front : fronts) {
    const double here = shape.curvature(front.curled), next = shape.curvature(front.next);
    if (here == next) continue;
    least(front.curled) = (moment_at(law, before, front.next, next).moment -
                           moment_at(law, before, front.curled, here).moment) /
                          (next - here);
  }
  return least;
}

/// How far the moments at the fronts are from their limit, and what moves them there.
struct Gaps {
  Eigen::VectorXd value;         // N, one a front
  Eigen::MatrixXd by_front;      // N/m, a column a front
  Eigen::MatrixXd by_parameter;  // with all fronts held
};

Gaps gaps_of(const GaussLine& line, const ComponentLaw& law, const StripHistory& before,
             const StripShape& shape, const PointMoment& limit, const std::vector<Front>& fronts,
             const Eigen::VectorXd& least_tangent, const Eigen::MatrixXd& by_front) {
  const auto count = static_cast<Index>(fronts.size());
  Gaps gaps{Eigen::VectorXd::Constant(count, -limit.moment), Eigen::MatrixXd::Zero(count, count),
            -limit.by_parameter.replicate(count, 1)};
  for (Index f = 0; f < count; ++f) {
    const Front& front = fronts[static_cast<size_t>(f)];
    const double distance = line.places()(front.first + 1) - line.places()(front.first);
    for (const Index i : {front.first, front.first + 1}) {
      const PointMoment point = moment_at(law, before, i, shape.curvature(i));
      const double sign = i == front.first ? -1 : 1;
      const double share = i == front.first ? 1 - front.between : front.between;
      const double tangent = std::max(point.tangent, least_tangent(i));
      gaps.value(f) += share * point.moment;
      gaps.by_front(f, f) += sign * point.moment / distance;
      gaps.by_front.row(f) += share * tangent * by_front.row(i);
      if (shape.curvature_by_parameter.size() == 0) continue;
      gaps.by_parameter.row(f) +=
          share * (point.by_parameter + tangent * shape.curvature_by_parameter.row(i));
    }
  }
  return gaps;
}

// All fronts are within a point of their limit.
bool are_near(const std::vector<Front>& fronts, const Eigen::VectorXd& moves,
              const GaussLine& line) {
  for (size_t f = 0; f < fronts.size(); ++f) {
    const double points = line.weights().segment<2>(fronts[f].first).sum();
    if (!(std::abs(moves(static_cast<Index>(f))) < points)) return false;
  }
  return true;
}

}  // namespace

void settle_fronts(const Elastica& strip, const ComponentLaw& law, double weight,
                   const StripEnds& ends, const StripHistory& start, const StripHistory& before,
                   StripShape& shape) {
  if (ends.far_angle || ends.far_x || ends.far_y) return;
  const std::optional<double> snapping = snapping_curvature(law, start);
  if (!snapping) return;
  const GaussLine& line = strip.line();
  const std::vector<Front> fronts = fronts_of(line, shape.curvature, *snapping);
  if (fronts.empty()) return;

  const auto count = static_cast<Index>(fronts.size());
  Eigen::MatrixXd jump = Eigen::MatrixXd::Zero(line.size(), count), turns = jump;
  for (Index f = 0; f < count; ++f) {
    const Index first = fronts[static_cast<size_t>(f)].first;
    const double change = shape.curvature(first) - shape.curvature(first + 1);
    jump(first + 1, f) = change / line.weights()(first + 1);
    turns.col(f).tail(line.size() - first - 1).setConstant(change);
  }
  const Eigen::VectorXd least_tangent = least_tangents(law, before, shape, fronts);
  const Eigen::MatrixXd response =
      strip.response_to_turns(law, weight, ends, before, shape, turns, least_tangent);
  StripShape settled = shape;
  const bool with_derivatives = shape.curvature_by_parameter.size() > 0;
  if (with_derivatives) {
    strip.differentiate(law, weight, ends, before, settled, least_tangent);
  }
  const Gaps gaps = gaps_of(line, law, before, settled, moment_at(law, start, 0, *snapping), fronts,
                            least_tangent, response);
  const Eigen::PartialPivLU<Eigen::MatrixXd> by_front(gaps.by_front);
  const Eigen::VectorXd moves = by_front.solve(-gaps.value);
  if (!are_near(fronts, moves, line)) return;
  settled.jumps = count == 1;
  settled.curvature += (jump + response) * moves;
  if (with_derivatives) {
    settled.curvature_by_parameter -= (jump + response) * by_front.solve(gaps.by_parameter);
  }
  shape = std::move(settled);
}

}  // namespace pliant
