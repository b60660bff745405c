#include "pliant/material/density/dahl_friction.h"

#include "pliant/math/simd.h"

namespace pliant {
namespace {

Eigen::Vector3d vector(const DahlParameters& dahl) { return {dahl.a, dahl.b, dahl.tau}; }

DahlParameters dahl_of(const Eigen::Vector3d& v) { return {v(0), v(1), v(2)}; }

Eigen::RowVector3d row(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

// Work, stress and slope of a stretch on one side of zero: the same solution as `friction_stress`.
template <class V>
struct Stretch {
  V work, stress, slope;
};

// @param s, g  signs of the strain's rate and of the side
template <class V>
PLIANT_INLINE Stretch<V> stretch_on_one_side(const DahlBySide& dahl, const V& s, const V& g,
                                             const V& way, const V& last, const V& from) {
  const DahlParameters &p = dahl.positive, &n = dahl.negative;
  const V zero{};
  const auto negative = g < zero;
  const V a = negative ? zero + n.a : zero + p.a;
  const V g_b = g * (negative ? zero + n.b : zero + p.b);
  const V tau = negative ? zero + n.tau : zero + p.tau;
  const V at_start = s * (a + g_b * last) - g_b * tau, excess = from - at_start;
  const V s_g_b = s * g_b;
  const V decay = simd::any(way != zero) ? simd::exp_of_negative(V(-s * way / tau)) : zero + 1;
  return {way * (at_start + s_g_b * way / 2) + excess * s * tau * (1 - decay),
          way == zero ? from : at_start + s_g_b * way + excess * decay,
          s_g_b - s * excess * decay / tau};
}

// Whether nothing changes where strain passes zero.
bool is_blind_to_zero(const DahlBySide& dahl) {
  const DahlParameters &p = dahl.positive, &n = dahl.negative;
  return p.b == 0 && n.b == 0 && p.a == n.a && p.tau == n.tau;
}

struct FrictionLanes {
  Lane work, stress, slope;

  FrictionLanes(const DahlBySide& dahl, int component, const Samples& samples) {
    simd::run<Solution>(&dahl, is_blind_to_zero(dahl), samples.strain.col(component).data(),
                        samples.last.col(component).data(), samples.history.col(0).data(), this);
  }

 private:
  struct Solution {
    template <class V>
    PLIANT_INLINE static void run(const DahlBySide* dahl, bool blind, const double* strains,
                                  const double* lasts, const double* stresses,
                                  FrictionLanes* lanes) {
      for (int l = 0; l < kLanes; l += simd::kWidth<V>) {
        const Stretch<V> stretch = solved(*dahl, blind, simd::load<V>(strains + l),
                                          simd::load<V>(lasts + l), simd::load<V>(stresses + l));
        simd::store(stretch.work, lanes->work.data() + l);
        simd::store(stretch.stress, lanes->stress.data() + l);
        simd::store(stretch.slope, lanes->slope.data() + l);
      }
    }

    template <class V>
    PLIANT_INLINE static Stretch<V> solved(const DahlBySide& dahl, bool blind, const V& strain,
                                           const V& last, const V& from) {
      const DahlParameters &p = dahl.positive, &n = dahl.negative;
      const V zero{}, one = zero + 1, way = strain - last;
      const auto crossing = blind ? zero != zero : strain * last < zero;
      const V end = crossing ? zero : strain;
      // Where nothing has moved yet, the stiffer direction undoes the stress.
      V s = simd::with_sign(one, way == zero ? -from : way);
      V g = simd::with_sign(one, V(end + last));
      const auto at_zero =
          (way == zero) & (end + last == zero) & (blind ? zero != zero : zero == zero);
      const auto negative = (n.a + from) / n.tau > (p.a - from) / p.tau;  // is stiffer there
      s = at_zero ? (negative ? -one : one) : s;
      g = at_zero ? (negative ? -one : one) : g;
      Stretch<V> stretch = stretch_on_one_side(dahl, s, g, V(end - last), last, from);
      if (!simd::any(crossing)) return stretch;
      const Stretch<V> beyond =
          stretch_on_one_side(dahl, s, simd::with_sign(one, strain), strain, zero, stretch.stress);
      stretch.work = crossing ? stretch.work + beyond.work : stretch.work;
      stretch.stress = crossing ? beyond.stress : stretch.stress;
      stretch.slope = crossing ? beyond.slope : stretch.slope;
      return stretch;
    }
  };
};

}  // namespace

DahlFriction::DahlFriction(int component, const DahlParameters& dahl)
    : component_(component), dahl_{dahl, dahl}, by_side_(false) {}

DahlFriction::DahlFriction(int component, const DahlBySide& dahl)
    : component_(component), dahl_(dahl), by_side_(true) {}

void DahlFriction::add(const Samples& samples, const StepTime&, Response& response) const {
  const FrictionLanes lanes(dahl_, component_, samples);
  response.work += lanes.work;
  response.stress.col(component_) += lanes.stress;
  response.tangent.col(component_ * samples.strain.cols() + component_) += lanes.slope;
}

void DahlFriction::advance(const Samples& samples, const StepTime&, MutableLaneView next,
                           Lane& work) const {
  const FrictionLanes lanes(dahl_, component_, samples);
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

void DahlFriction::differentiate(const Samples& samples, const StepTime&, int lane,
                                 int first_history, int first_parameter,
                                 SampleDerivatives& derivatives) const {
  const FrictionState start{samples.last(lane, component_), samples.history(lane, 0)};
  const FrictionStressBySide sides =
      friction_stress(dahl_, samples.strain(lane, component_), start);
  FrictionStress friction = sides.friction;
  // A step of no length keeps the stress, whichever way its tangent counts.
  if (samples.strain(lane, component_) == start.strain) {
    friction.slope = FrictionLanes(dahl_, component_, samples).slope(lane);
    friction.from_strain = -friction.slope;
  }
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
