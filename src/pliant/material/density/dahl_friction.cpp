#include "pliant/material/density/dahl_friction.h"

#include <cmath>

namespace pliant {
namespace {

Eigen::Vector3d vector(const DahlParameters& dahl) { return {dahl.a, dahl.b, dahl.tau}; }

DahlParameters dahl_of(const Eigen::Vector3d& v) { return {v(0), v(1), v(2)}; }

Eigen::RowVector3d row(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

// The direction from zero strain in which friction is stiffer, and so the side.
double stiffer_side_of_zero(const DahlBySide& dahl, double stress) {
  const DahlParameters &p = dahl.positive, &n = dahl.negative;
  return (n.a + stress) / n.tau > (p.a - stress) / p.tau ? -1 : 1;
}

// Work, stress and slope of a stretch that lies on one side of zero in every lane: the same
// solution as `friction_stress`, eight points at once. Plain loops, which become vector
// instructions.
struct Lanes {
  Lane work, stress, slope;

  Lanes(const DahlBySide& dahl, bool by_side, const Lane& strain, const Lane& last,
        const Lane& from) {
    const Lane way = strain - last, side = strain + last;
    const DahlParameters &p = dahl.positive, &n = dahl.negative;
    Lane s, g;
    for (int i = 0; i < kLanes; ++i) {
      const double to_zero = -from(i), now = way(i);  // the stiffer direction undoes the stress
      s(i) = std::copysign(1.0, now == 0 ? to_zero : now);
      g(i) = std::copysign(1.0, side(i));
    }
    if (!by_side) {
      solve(p.a, p.b, p.tau, s, g, way, last, from);
      return;
    }
    Lane a, b, tau;
    for (int i = 0; i < kLanes; ++i) {
      if (way(i) == 0 && side(i) == 0) s(i) = g(i) = stiffer_side_of_zero(dahl, from(i));
      a(i) = g(i) < 0 ? n.a : p.a;
      b(i) = g(i) < 0 ? n.b : p.b;
      tau(i) = g(i) < 0 ? n.tau : p.tau;
    }
    solve(a, b, tau, s, g, way, last, from);
  }

 private:
  // Number: one for all lanes (double) or one for each (Lane).
  template <class Number>
  void solve(const Number& a, const Number& b, const Number& tau, const Lane& s, const Lane& g,
             const Lane& way, const Lane& last, const Lane& from) {
    const Number per_tau = 1 / tau;
    const Lane g_b = g * b;
    if ((way == 0).all()) {  // where a linearised step asks
      work = Lane::Zero();
      stress = from;
      slope = (a + g_b * last - s * from) * per_tau;
      return;
    }
    const Lane at_start = s * (a + g_b * last) - g_b * tau;
    const Lane excess = from - at_start;
    const Lane decay = (-s * way * per_tau).exp();
    const Lane s_g_b = s * g_b;
    work = way * (at_start + s_g_b * way / 2) + excess * s * tau * (1 - decay);
    stress = at_start + s_g_b * way + excess * decay;
    slope = s_g_b - s * excess * decay * per_tau;
  }
};

// Whether nothing changes where strain passes zero.
bool is_blind_to_zero(const DahlBySide& dahl) {
  const DahlParameters &p = dahl.positive, &n = dahl.negative;
  return p.b == 0 && n.b == 0 && p.a == n.a && p.tau == n.tau;
}

Lanes friction_lanes(const DahlBySide& dahl, bool by_side, int component, const Samples& samples) {
  const Lane strain = samples.strain.col(component), last = samples.last.col(component);
  const Lane from = samples.history.col(0);
  Lanes lanes(dahl, by_side, strain, last, from);
  if (is_blind_to_zero(dahl) || (strain * last).minCoeff() >= 0) return lanes;
  for (int i = 0; i < kLanes; ++i) {
    if (strain(i) * last(i) >= 0) continue;  // does not cross zero
    const FrictionState start{last(i), from(i)};
    const FrictionStress friction = friction_stress(dahl, strain(i), start).friction;
    lanes.work(i) = friction_work(dahl, strain(i), start);
    lanes.stress(i) = friction.stress;
    lanes.slope(i) = friction.slope;
  }
  return lanes;
}

}  // namespace

DahlFriction::DahlFriction(int component, const DahlParameters& dahl)
    : component_(component), dahl_{dahl, dahl}, by_side_(false) {}

DahlFriction::DahlFriction(int component, const DahlBySide& dahl)
    : component_(component), dahl_(dahl), by_side_(true) {}

void DahlFriction::add(const Samples& samples, const StepTime&, Response& response) const {
  const Lanes lanes = friction_lanes(dahl_, by_side_, component_, samples);
  response.work += lanes.work;
  response.stress.col(component_) += lanes.stress;
  response.tangent.col(component_ * samples.strain.cols() + component_) += lanes.slope;
}

void DahlFriction::advance(const Samples& samples, const StepTime&, MutableLaneView next,
                           Lane& work) const {
  const Lanes lanes = friction_lanes(dahl_, by_side_, component_, samples);
  next.col(0) = lanes.stress;
  work += lanes.work;
}

Eigen::VectorXd DahlFriction::parameters() const {
  Eigen::VectorXd values(by_side_ ? 6 : 3);
  values.head<3>() = vector(dahl_.positive);
  if (by_side_) values.tail<3>() = vector(dahl_.negative);
  return values;
}

std::unique_ptr<ParametricDensity> DahlFriction::with_parameters(
    const Eigen::VectorXd& values) const {
  const DahlParameters positive = dahl_of(values.head<3>());
  if (!by_side_) return std::make_unique<DahlFriction>(component_, positive);
  return std::make_unique<DahlFriction>(component_,
                                        DahlBySide{positive, dahl_of(values.tail<3>())});
}

void DahlFriction::differentiate(const Samples& samples, int lane, int first_history,
                                 int first_parameter, SampleDerivatives& derivatives) const {
  const FrictionState start{samples.last(lane, component_), samples.history(lane, 0)};
  const FrictionStressBySide sides =
      friction_stress(dahl_, samples.strain(lane, component_), start);
  const FrictionStress& friction = sides.friction;
  Eigen::Matrix<double, 1, 6> by_parameter;
  by_parameter << row(friction.parameters), row(sides.negative_parameters);
  if (!by_side_) by_parameter.head<3>() += by_parameter.tail<3>();
  const int count = by_side_ ? 6 : 3;

  derivatives.stress_by_last(component_, component_) += friction.from_strain;
  derivatives.stress_by_history(component_, first_history) += friction.from_stress;
  derivatives.stress_by_parameter.row(component_).segment(first_parameter, count) +=
      by_parameter.head(count);
  derivatives.next_by_strain(first_history, component_) = friction.slope;
  derivatives.next_by_last(first_history, component_) = friction.from_strain;
  derivatives.next_by_history(first_history, first_history) = friction.from_stress;
  derivatives.next_by_parameter.row(first_history).segment(first_parameter, count) =
      by_parameter.head(count);
}

}  // namespace pliant
