#include "pliant/material/density/dahl_constant_slope.h"

#include <cmath>

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

namespace pliant {
namespace {

// Derivatives w.r.t. (a, b, alpha, strain, strain0, stress0).
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 6, 1>>;

constexpr double kSeriesRange = 1e-3;  // below it five terms of a series are exact to rounding

// log(1 + x) / x
Dual log_ratio(const Dual& x) {
  if (std::abs(x.value()) > kSeriesRange) return log(Dual(1.0 + x)) / x;
  return 1.0 - x * (1.0 / 2 - x * (1.0 / 3 - x * (1.0 / 4 - x * (1.0 / 5 - x / 6.0))));
}

// (exp(z) - 1) / z for small z
Dual exp_ratio(const Dual& z) {
  return 1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0 * (1.0 + z / 5.0 * (1.0 + z / 6.0))));
}

// With m = a + b |strain|, x the relative growth of m over the stretch and w = the integral of
// alpha / m along it, the solution is sigma0 exp(-w) + alpha (integral of exp(w' - w)), written so
// that b -> 0 and alpha -> b have no 0 / 0.
Dual on_one_side(const Dual& a, const Dual& b, const Dual& alpha, const Dual& strain,
                 const Dual& strain0, const Dual& stress0, double s, double g) {
  const Dual m0 = a + g * b * strain0;
  const Dual x = g * b * (strain - strain0) / m0;
  const Dual length = (strain - strain0) * log_ratio(x);
  const Dual w = s * alpha * length / m0;
  const Dual decay = exp(Dual(-w));
  const Dual z = x * log_ratio(x) + w;
  const Dual growth =
      std::abs(z.value()) > kSeriesRange ? Dual((1.0 + x - decay) / z) : Dual(decay * exp_ratio(z));
  return stress0 * decay + alpha * length * growth;
}

}  // namespace

FrictionStress friction_stress(const ConstantSlopeParameters& dahl, double strain,
                               const FrictionState& from) {
  const Dual a(dahl.a, 6, 0), b(dahl.b, 6, 1), alpha(dahl.alpha, 6, 2);
  const Dual end(strain, 6, 3), start(from.strain, 6, 4), stress0(from.stress, 6, 5);
  const double s = strain < from.strain ? -1 : 1;
  const bool crosses_zero = (strain > 0 && from.strain < 0) || (strain < 0 && from.strain > 0);

  Dual stress;
  if (crosses_zero) {
    const Dual zero(0.0);
    const double side = from.strain < 0 ? -1 : 1;
    const Dual at_zero = on_one_side(a, b, alpha, zero, start, stress0, s, side);
    stress = on_one_side(a, b, alpha, end, zero, at_zero, s, -side);
  } else {
    stress = on_one_side(a, b, alpha, end, start, stress0, s, strain + from.strain < 0 ? -1 : 1);
  }

  const auto& d = stress.derivatives();
  return {stress.value(), d(3), d(4), d(5), {d(0), d(1), d(2)}};
}

}  // namespace pliant
