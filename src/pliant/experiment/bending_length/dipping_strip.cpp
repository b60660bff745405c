#include "pliant/experiment/bending_length/dipping_strip.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "pliant/base/assert.h"
#include "pliant/solver/elastica/elastica.h"

namespace pliant {
namespace {

constexpr double kShortest = 1e-3;  // m; no sheet dips far in that
constexpr double kLongest = 10;
constexpr double kGrowth = 1.5;  // of the length, from one trial to the next

// A strip of some length over the edge.
class Overhang {
 public:
  Overhang(const ComponentLaw& law, double weight, double length, const DipOptions& options)
      : law_(law), weight_(weight), strip_(length, options.elements), flat_(strip_.rested(law)) {
    StripShape guess;
    guess.curvature = flat_.curvature;
    shape_ = strip_.equilibrium(law, weight, {}, flat_, guess);
  }

  double length() const { return strip_.line().length(); }
  bool in_equilibrium() const { return shape_.has_value(); }

  // By which the tip lies below the edge (rad).
  double angle() const {
    const Eigen::Vector2d tip = position();
    return std::atan2(-tip.y(), tip.x());
  }

  double edge_curvature() const { return strip_.profile({}, *shape_).at(0).curvature; }

  double angle_by_length() const {
    return turn(strip_.tip_by_length(law_, weight_, {}, flat_, *shape_));
  }

  Eigen::VectorXd angle_by_parameter() const {
    StripShape shape = *shape_;
    strip_.differentiate(law_, weight_, {}, flat_, shape);
    const Eigen::MatrixXd tip = strip_.profile({}, shape).position_by_parameter(length());
    Eigen::VectorXd angle(law_.parameter_count());
    for (Eigen::Index i = 0; i < angle.size(); ++i) angle(i) = turn(tip.col(i));
    return angle;
  }

 private:
  Eigen::Vector2d position() const { return strip_.profile({}, *shape_).at(length()).position; }
  // Change of the angle when the tip moves.
  double turn(const Eigen::Vector2d& move) const {
    const Eigen::Vector2d tip = position();
    return (tip.y() * move.x() - tip.x() * move.y()) / tip.squaredNorm();
  }

  ComponentLaw law_;
  double weight_;
  Elastica strip_;
  StripHistory flat_;
  std::optional<StripShape> shape_;
};

bool has_two_sides(const ScalarCurve& stiffness) {
  return stiffness.kind() == CurveKind::hermite && !stiffness.even();
}

// The law of the strip turned over.
ComponentLaw mirrored(const ComponentLaw& law) {
  ComponentLaw result = law;
  if (!has_two_sides(law.stiffness)) return result;
  std::vector<double> strains(law.stiffness.knots().rbegin(), law.stiffness.knots().rend());
  for (double& strain : strains) strain = -strain;
  result.stiffness = ScalarCurve::hermite(
      strains, {law.stiffness.values().rbegin(), law.stiffness.values().rend()});
  return result;
}

DippingStrip turned_over(DippingStrip strip, const ComponentLaw& law) {
  strip.edge_curvature = -strip.edge_curvature;
  if (has_two_sides(law.stiffness) && strip.by_parameter.size() > 0) {
    strip.by_parameter.head(law.stiffness.size()).reverseInPlace();
  }
  return strip;
}

// Lengths below and above the first at which the angle is reached.
std::optional<std::pair<double, double>> bracket(const ComponentLaw& law, double weight,
                                                 double angle, const DipOptions& options) {
  double below = 0;
  for (double length = kShortest; length < kLongest; length *= kGrowth) {
    const Overhang trial(law, weight, length, options);
    if (!trial.in_equilibrium()) return std::nullopt;
    if (trial.angle() >= angle) {
      return below > 0 ? std::optional(std::pair(below, length)) : std::nullopt;
    }
    below = length;
  }
  return std::nullopt;
}

// Newton's method, kept within the bracket by halving it.
std::optional<Overhang> at_angle(const ComponentLaw& law, double weight, double angle,
                                 const DipOptions& options, std::pair<double, double> lengths) {
  constexpr double kTolerance = 1e-13;  // of the angle
  constexpr int kMost = 100;
  double length = (lengths.first + lengths.second) / 2;
  std::optional<Overhang> best;
  for (int i = 0; i < kMost; ++i) {
    Overhang trial(law, weight, length, options);
    if (!trial.in_equilibrium()) return std::nullopt;
    const double excess = trial.angle() - angle;
    (excess < 0 ? lengths.first : lengths.second) = length;
    const double next = length - excess / trial.angle_by_length();
    best.emplace(std::move(trial));
    // Rounding of the equilibrium may leave the last digits of the angle in doubt.
    if (std::abs(excess) < kTolerance * angle || std::abs(next - length) < kTolerance * length) {
      break;
    }
    const bool within = next > lengths.first && next < lengths.second;
    length = within ? next : (lengths.first + lengths.second) / 2;
  }
  return best;
}

}  // namespace

std::optional<DippingStrip> dipping_strip(const ComponentLaw& law, double weight, double angle,
                                          const DipOptions& options) {
  PLIANT_ASSERT(weight > 0, "its own weight bends the strip");
  PLIANT_ASSERT(angle > 0 && angle < std::numbers::pi / 2, "the tip lies below the edge");
  if (options.face == StripFace::down) {
    DipOptions up = options;
    up.face = StripFace::up;
    const auto strip = dipping_strip(mirrored(law), weight, angle, up);
    return strip ? std::optional(turned_over(*strip, law)) : std::nullopt;
  }
  const auto lengths = bracket(law, weight, angle, options);
  if (!lengths) return std::nullopt;
  const auto strip = at_angle(law, weight, angle, options, *lengths);
  if (!strip) return std::nullopt;
  DippingStrip result;
  result.overhang = strip->length();
  result.edge_curvature = strip->edge_curvature();
  if (options.with_derivatives) {
    result.by_parameter = -strip->angle_by_parameter() / strip->angle_by_length();
  }
  return result;
}

}  // namespace pliant
