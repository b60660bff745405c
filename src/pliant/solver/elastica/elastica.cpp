#include "pliant/solver/elastica/elastica.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>

#include "pliant/base/assert.h"
#include "pliant/solver/elastica/point_moment.h"

namespace pliant {
namespace {

int constraint_count(const StripEnds& ends) {
  return (ends.far_angle ? 1 : 0) + (ends.far_x ? 1 : 0) + (ends.far_y ? 1 : 0);
}

// The loads of the far end in the order of its gaps.
Eigen::VectorXd loads_of(const StripEnds& ends, const StripShape& shape) {
  Eigen::VectorXd loads(constraint_count(ends));
  Eigen::Index next = 0;
  if (ends.far_angle) loads(next++) = shape.far_load.z();
  if (ends.far_x) loads(next++) = shape.far_load.x();
  if (ends.far_y) loads(next++) = shape.far_load.y();
  return loads;
}

void add_loads(const StripEnds& ends, const Eigen::VectorXd& change, StripShape& shape) {
  Eigen::Index next = 0;
  if (ends.far_angle) shape.far_load.z() += change(next++);
  if (ends.far_x) shape.far_load.x() += change(next++);
  if (ends.far_y) shape.far_load.y() += change(next++);
}

}  // namespace

/// The strip at some curvatures: energy and its first derivatives, and how far the far end is from
/// where it is held.
struct Elastica::Balance {
  double energy = 0;        // N, without the far end's loads
  Eigen::VectorXd moment;   // N
  Eigen::VectorXd tangent;  // d moment / d curvature
  Eigen::VectorXd cosine, sine;
  Eigen::VectorXd force;  // on the cross-section, along y: what hangs on it, less the far load
  double force_x = 0;
  Eigen::VectorXd gradient;  // of energy and loads, by curvature
  Eigen::MatrixXd border;    // d gap / d curvature, a column each
  Eigen::VectorXd gap;       // of the far end: angle, x, y
};

Elastica::Elastica(double length, int elements) : line_(length, elements) {}

StripHistory Elastica::rested(const ComponentLaw& law) const { return rolled(law, 0); }

StripHistory Elastica::rolled(const ComponentLaw& law, double curvature) const {
  PLIANT_ASSERT(law.friction_law != FrictionLaw::constant_slope, "no energy is known of this law");
  const int parameters = law.parameter_count() + 1;
  Eigen::Index numbers = 0;
  for (const Addend& addend : law.addends) numbers += addend.history_size();
  StripHistory flat;
  flat.curvature = Eigen::VectorXd::Zero(line_.size());
  flat.friction = flat.curvature;
  flat.curvature_by_parameter = Eigen::MatrixXd::Zero(line_.size(), parameters);
  flat.friction_by_parameter = flat.curvature_by_parameter;
  flat.memory = Eigen::MatrixXd::Zero(line_.size(), numbers);
  flat.memory_by_parameter.assign(static_cast<size_t>(line_.size()),
                                  Eigen::MatrixXd::Zero(numbers, parameters));
  StripShape round;
  round.curvature = Eigen::VectorXd::Constant(line_.size(), curvature);
  round.curvature_by_parameter = flat.curvature_by_parameter;
  return remembered(law, flat, round);
}

Elastica::Balance Elastica::balance(const ComponentLaw& law, double weight, const StripEnds& ends,
                                    const StripHistory& history, const Eigen::VectorXd& held,
                                    const StripShape& shape) const {
  const Eigen::VectorXd& w = line_.weights();
  const Eigen::VectorXd turned = line_.integrals(shape.curvature);
  Balance b;
  b.cosine.resize(line_.size());
  b.sine.resize(line_.size());
  b.moment.resize(line_.size());
  b.tangent.resize(line_.size());
  for (int i = 0; i < line_.size(); ++i) {
    const double angle = turned(i) + ends.clamp_angle;
    b.cosine(i) = std::cos(angle);  // beside each other they cost one call
    b.sine(i) = std::sin(angle);
    const PointMoment point = point_moment(law, history, i, shape.curvature(i), false);
    b.moment(i) = point.moment;
    b.tangent(i) = point.tangent;
    b.energy += w(i) * point.work;
  }
  const Eigen::VectorXd hanging = weight * (line_.length() - line_.places().array());
  b.energy += w.dot(hanging.cwiseProduct(b.sine));
  b.gradient = w.cwiseProduct(b.moment);
  if (held.size() > 0) {
    b.energy -= w.dot(held.cwiseProduct(shape.curvature));
    b.gradient -= w.cwiseProduct(held);
  }
  b.force = hanging;
  if (ends.far_y) b.force.array() -= shape.far_load.y();
  if (ends.far_x) b.force_x = shape.far_load.x();
  b.gradient += line_.transposed_integrals(
      w.cwiseProduct(b.force.cwiseProduct(b.cosine) + b.force_x * b.sine));

  b.gap.resize(constraint_count(ends));
  b.border.resize(line_.size(), b.gap.size());
  Eigen::Index next = 0;
  if (ends.far_angle) {
    b.gap(next) = w.dot(shape.curvature) - *ends.far_angle;
    b.border.col(next++) = w;
    b.gradient -= shape.far_load.z() * w;
  }
  if (ends.far_x) {
    b.gap(next) = w.dot(b.cosine) - *ends.far_x;
    b.border.col(next++) = -line_.transposed_integrals(w.cwiseProduct(b.sine));
  }
  if (ends.far_y) {
    b.gap(next) = w.dot(b.sine) - *ends.far_y;
    b.border.col(next++) = line_.transposed_integrals(w.cwiseProduct(b.cosine));
  }
  return b;
}

// Of the energy: the law's tangents, and what turning does to the moments of weight and loads; or,
// convex, a stand-in without what makes the energy fall.
Elastica::Stiffness Elastica::stiffness(const Balance& b, bool convex) const {
  const Eigen::VectorXd& w = line_.weights();
  Eigen::VectorXd turning = b.force_x * b.cosine - b.force.cwiseProduct(b.sine);
  Eigen::VectorXd tangent = b.tangent;
  if (convex) {
    turning = turning.cwiseMax(0);
    tangent = tangent.cwiseMax(1e-3 * tangent.cwiseAbs().maxCoeff());
  }
  return {w.cwiseProduct(tangent), w.cwiseProduct(turning)};
}

Eigen::MatrixXd Elastica::matrix(const Stiffness& stiffness) const {
  Eigen::MatrixXd h = line_.integration_gram(stiffness.turning);
  h.diagonal() += stiffness.bending;
  return h;
}

LineFactor Elastica::factor(const Stiffness& stiffness) const {
  return {line_, stiffness.bending, stiffness.turning};
}

// The same, bordered by the derivatives of the gaps.
Eigen::MatrixXd Elastica::bordered(const Balance& b) const {
  const Eigen::Index n = line_.size(), m = b.gap.size();
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n + m, n + m);
  k.topLeftCorner(n, n) = matrix(stiffness(b, false));
  k.topRightCorner(n, m) = -b.border;
  k.bottomLeftCorner(m, n) = -b.border.transpose();
  return k;
}

// Change of the curvatures, then of the far end's loads; nothing where the strip has no stiffness.
std::optional<Eigen::VectorXd> Elastica::newton_step(const Balance& b) const {
  if (b.gap.size() == 0) {
    for (const bool convex : {false, true}) {
      const LineFactor line = factor(stiffness(b, convex));
      if (line.is_positive()) return line.solve(-b.gradient);
    }
    return std::nullopt;
  }
  Eigen::VectorXd right(line_.size() + b.gap.size());
  right << -b.gradient, b.gap;
  Eigen::MatrixXd k = bordered(b);
  Eigen::VectorXd step = k.partialPivLu().solve(right);
  const auto bend = step.head(line_.size());
  if (bend.dot(k.topLeftCorner(line_.size(), line_.size()) * bend) > 0) return step;
  k.topLeftCorner(line_.size(), line_.size()) = matrix(stiffness(b, true));
  return k.partialPivLu().solve(right);
}

// Changes of the curvatures, then of the far end's loads, that balance small moments and gaps, a
// column each.
Eigen::MatrixXd Elastica::respond(const Balance& b, const Eigen::MatrixXd& right) const {
  if (b.gap.size() == 0) {
    const LineFactor line = factor(stiffness(b, false));
    if (line.is_positive()) return line.solve(right);
  }
  return bordered(b).partialPivLu().solve(right);
}

bool Elastica::is_stable(const ComponentLaw& law, double weight, const StripEnds& ends,
                         const StripHistory& history, const StripShape& shape) const {
  const Balance b = balance(law, weight, ends, history, {}, shape);
  const Stiffness all = stiffness(b, false);
  if (b.gap.size() == 0) return factor(all).is_positive();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(b.border);
  const Eigen::MatrixXd directions = qr.householderQ();
  const auto allowed = directions.rightCols(line_.size() - b.gap.size());
  const Eigen::MatrixXd h = allowed.transpose() * matrix(all) * allowed;
  return Eigen::LLT<Eigen::MatrixXd>(h).info() == Eigen::Success;
}

std::optional<StripShape> Elastica::equilibrium(const ComponentLaw& law, double weight,
                                                const StripEnds& ends, const StripHistory& history,
                                                const StripShape& guess,
                                                const Eigen::VectorXd& held) const {
  constexpr double kTolerance = 1e-11, kShare = 1e-4, kShortest = 1e-8, kRounding = 1e-13;
  constexpr int kMost = 200;
  // Relative to what bends the strip into an arc of one radian, and to what hangs on it.
  const auto error = [&](const Balance& b) {
    const double scale = b.tangent.cwiseAbs().maxCoeff() / line_.length() +
                         b.moment.cwiseAbs().maxCoeff() + weight * line_.length() * line_.length();
    const double gap = b.gap.size() > 0 ? b.gap.cwiseAbs().maxCoeff() : 0;
    return std::max((b.gradient.array() / line_.weights().array()).abs().maxCoeff() / scale, gap);
  };
  StripShape shape;  // what else the guess knows is not true of it
  shape.curvature = guess.curvature;
  shape.far_load = guess.far_load;
  Balance here = balance(law, weight, ends, history, held, shape);
  for (int iteration = 0; iteration < kMost && here.gradient.allFinite(); ++iteration) {
    const double wrong = error(here);
    if (wrong < kTolerance) return shape;
    const std::optional<Eigen::VectorXd> step = newton_step(here);
    if (!step || !step->allFinite()) return std::nullopt;
    // Down the energy, the gaps of the far end weighed in by its new loads and a penalty.
    const Eigen::VectorXd bend = step->head(line_.size()), load = step->tail(here.gap.size());
    StripShape loaded = shape;
    add_loads(ends, load, loaded);
    const Eigen::VectorXd loads = loads_of(ends, loaded);
    const double penalty = here.tangent.maxCoeff() / std::pow(line_.length(), 3);
    const auto merit = [&](const Balance& b) {
      return b.energy - loads.dot(b.gap) + penalty / 2 * b.gap.squaredNorm();
    };
    const double slope =
        here.gradient.dot(bend) + load.dot(here.gap) - penalty * here.gap.squaredNorm();
    const bool lost = -slope <= kRounding * std::abs(here.energy);  // in rounding
    bool better = false;
    for (double share = 1; share > kShortest && !better; share /= 2) {
      StripShape trial = loaded;
      trial.curvature += share * bend;
      Balance there = balance(law, weight, ends, history, held, trial);
      better = lost ? error(there) < (1 - kShare * share) * wrong
                    : merit(there) <= merit(here) + kShare * share * slope;
      if (!better) continue;
      shape = std::move(trial);
      here = std::move(there);
    }
    if (!better) return std::nullopt;
  }
  return std::nullopt;
}

Eigen::VectorXd Elastica::holding_moments(const ComponentLaw& law, double weight,
                                          const StripEnds& ends,
                                          const StripHistory& history) const {
  StripShape shape;
  shape.curvature = history.curvature;
  return balance(law, weight, ends, history, {}, shape).gradient.cwiseQuotient(line_.weights());
}

void Elastica::differentiate(const ComponentLaw& law, double weight, const StripEnds& ends,
                             const StripHistory& history, StripShape& shape,
                             const Eigen::VectorXd& least_tangent) const {
  Balance b = balance(law, weight, ends, history, {}, shape);
  if (least_tangent.size() > 0) b.tangent = b.tangent.cwiseMax(least_tangent);
  const Eigen::VectorXd& w = line_.weights();
  const Eigen::Index n = line_.size(), parameters = law.parameter_count() + 1;
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n + b.gap.size(), parameters);
  for (int i = 0; i < n; ++i) {
    right.row(i) = -w(i) * point_moment(law, history, i, shape.curvature(i), true).by_parameter;
  }
  right.col(parameters - 1).head(n) -= line_.transposed_integrals(
      w.cwiseProduct((line_.length() - line_.places().array()).matrix().cwiseProduct(b.cosine)));
  const Eigen::MatrixXd change = respond(b, right);
  shape.curvature_by_parameter = change.topRows(n);
  shape.far_load_by_parameter = Eigen::MatrixXd::Zero(3, parameters);
  Eigen::Index next = n;
  if (ends.far_angle) shape.far_load_by_parameter.row(2) = change.row(next++);
  if (ends.far_x) shape.far_load_by_parameter.row(0) = change.row(next++);
  if (ends.far_y) shape.far_load_by_parameter.row(1) = change.row(next++);
}

// The points keep their shares of the length, so that the weights of the line, its integration and
// what hangs on a point all grow like the length.
Eigen::Vector2d Elastica::tip_by_length(const ComponentLaw& law, double weight,
                                        const StripEnds& ends, const StripHistory& history,
                                        const StripShape& shape) const {
  PLIANT_ASSERT(constraint_count(ends) == 0, "the far end is free");
  const Balance b = balance(law, weight, ends, history, {}, shape);
  const Eigen::VectorXd& w = line_.weights();
  const Eigen::VectorXd turned = line_.integrals(shape.curvature) / line_.length();
  const Eigen::VectorXd moment_change =
      b.force.cwiseProduct(2 / line_.length() * b.cosine - b.sine.cwiseProduct(turned));
  const Eigen::VectorXd bend =
      respond(b, -line_.transposed_integrals(w.cwiseProduct(moment_change)));
  const Eigen::VectorXd turn = turned + line_.integrals(bend);
  return {w.dot(b.cosine / line_.length() - b.sine.cwiseProduct(turn)),
          w.dot(b.sine / line_.length() + b.cosine.cwiseProduct(turn))};
}

Eigen::MatrixXd Elastica::response_to_turns(const ComponentLaw& law, double weight,
                                            const StripEnds& ends, const StripHistory& history,
                                            const StripShape& shape, const Eigen::MatrixXd& turns,
                                            const Eigen::VectorXd& least_tangent) const {
  PLIANT_ASSERT(constraint_count(ends) == 0, "the far end is free");
  Balance b = balance(law, weight, ends, history, {}, shape);
  b.tangent = b.tangent.cwiseMax(least_tangent);
  Eigen::MatrixXd right(line_.size(), turns.cols());
  for (Eigen::Index i = 0; i < turns.cols(); ++i) {
    right.col(i) = line_.transposed_integrals(
        line_.weights().cwiseProduct(b.force.cwiseProduct(b.sine).cwiseProduct(turns.col(i))));
  }
  return respond(b, right);
}

StripHistory Elastica::accepted(const ComponentLaw& law, const StripHistory& history,
                                const StripShape& shape) const {
  return remembered(law, history, shape);
}

StripProfile Elastica::profile(const StripEnds& ends, const StripShape& shape) const {
  return StripProfile(line_, ends.clamp_angle, shape.curvature, shape.curvature_by_parameter);
}

}  // namespace pliant
