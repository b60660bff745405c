#include "pliant/experiment/profile/strip_rests.h"

#include <algorithm>
#include <cmath>

#include "pliant/experiment/profile/strip_shapes.h"
#include "pliant/solver/elastica/equilibria.h"

namespace pliant {
namespace {

constexpr double kApart = 5e-3;  // share of the length: nearer shapes are one

// Largest distance between two profiles of one line (m).
double distance_between(const StripProfile& one, const StripProfile& other, double length) {
  constexpr int kPoints = 20;
  double largest = 0;
  for (int i = 1; i <= kPoints; ++i) {
    const double place = length * i / kPoints;
    largest = std::max(largest, (one.at(place).position - other.at(place).position).norm());
  }
  return largest;
}

}  // namespace

StripRests::StripRests(HangingStrip hanging, const ComponentLaw& law, double rolled, double weight)
    : hanging_(std::move(hanging)), law_(law), rolled_(rolled), weight_(weight) {}

const std::vector<HangingStrip>& StripRests::others() {
  if (others_) return *others_;
  others_.emplace();
  if (law_.friction_law == FrictionLaw::none || snaps(law_, rolled_)) return *others_;
  if (rolled_ != 0) add_let_go_faster();
  add_pushed();
  return *others_;
}

void StripRests::add(HangingStrip other) {
  const StripProfile profile = other.line.profile({}, other.shape);
  const auto is_near = [&](const HangingStrip& known) {
    return distance_between(profile, known.line.profile({}, known.shape), length()) <
           kApart * length();
  };
  if (is_near(hanging_) || std::ranges::any_of(*others_, is_near)) return;
  others_->push_back(std::move(other));
}

// Friction as in one stretch from the cylinder, the shape followed in a few steps: where a strip
// tips over on its way, it may do so at another point of it, or not.
void StripRests::add_let_go_faster() {
  constexpr int kSteps = 4;
  const StripHistory history = hanging_.line.rolled(law_, rolled_);
  const Eigen::VectorXd held = hanging_.line.holding_moments(law_, weight_, {}, history);
  std::optional<StripShape> shape(std::in_place);
  shape->curvature = history.curvature;
  for (int step = kSteps - 1; step >= 0 && shape; --step) {
    const double share = static_cast<double>(step) / kSteps;
    shape = hanging_.line.equilibrium(law_, weight_, {}, history, *shape, share * held);
  }
  if (!shape || !hanging_.line.is_stable(law_, weight_, {}, history, *shape)) return;
  add({hanging_.line, history, std::move(*shape)});
}

void StripRests::add_pushed() {
  for (StripShape& shape : equilibria_near(hanging_.line, law_, weight_, {}, hanging_.history,
                                           hanging_.shape, kPushedBy)) {
    add({hanging_.line, hanging_.history, std::move(shape)});
  }
}

// Of the points from where the strip has their shares of its length (m).
double StripRests::distance(const ProfileRows& measured, std::size_t rest) {
  const StripProfile line = profile(rest, false);
  const std::vector<double> shares = measured.shares();
  double squares = 0;
  for (std::size_t i = 0; i < measured.points.size(); ++i) {
    squares += (line.at(shares[i] * length()).position - measured.points[i]).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(measured.points.size()));
}

std::size_t StripRests::nearest(const ProfileRows& measured) {
  std::size_t best = 0;
  double least = distance(measured, 0);
  if (least < kApart * length()) return best;
  for (std::size_t rest = 1; rest <= others().size(); ++rest) {
    const double away = distance(measured, rest);
    if (!(away < least)) continue;
    least = away;
    best = rest;
  }
  return best;
}

StripProfile StripRests::profile(std::size_t rest, bool with_derivatives) {
  HangingStrip& strip = rest == 0 ? hanging_ : others_->at(rest - 1);
  StripShape& shape = strip.shape;
  if (with_derivatives && shape.curvature_by_parameter.size() == 0) {
    strip.line.differentiate(law_, weight_, {}, strip.history, shape);
  }
  if (with_derivatives) return strip.line.profile({}, shape);
  return StripProfile(strip.line.line(), 0, shape.curvature, {});
}

}  // namespace pliant
