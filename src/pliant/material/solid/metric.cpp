#include "pliant/material/solid/metric.h"

#include <algorithm>
#include <array>

namespace pliant {
namespace {

// C = I + 2 E as the vector (C11, C22, C33, C23, C13, C12); its derivatives by E are 2, 2, 2, 1, 1,
// 1.
struct CauchyGreen {
  Lane x, y, z, yz, xz, xy;

  explicit CauchyGreen(const LaneView& e)
      : x(1 + 2 * e.col(0)),
        y(1 + 2 * e.col(1)),
        z(1 + 2 * e.col(2)),
        yz(e.col(3)),
        xz(e.col(4)),
        xy(e.col(5)) {}
};

Lane constant(double value) { return Lane::Constant(value); }

template <int kComponent>
MetricJet green(const LaneView& e) {
  MetricJet jet;
  jet.value = e.col(kComponent);
  jet.gradient.col(kComponent) = 1;
  return jet;
}

// E_i + E_j: with squares of both it makes products of strains, 2 E_i E_j = (E_i + E_j)^2 - ...
template <int kFirst, int kSecond>
MetricJet green_sum(const LaneView& e) {
  MetricJet jet;
  jet.value = e.col(kFirst) + e.col(kSecond);
  jet.gradient.col(kFirst) = 1;
  jet.gradient.col(kSecond) = 1;
  return jet;
}

MetricJet trace(const LaneView& e) {
  MetricJet jet;
  jet.value = e.col(0) + e.col(1) + e.col(2);
  jet.gradient.leftCols<3>() = 1;
  return jet;
}

MetricJet trace_of_square(const LaneView& e) {
  MetricJet jet;
  jet.value = e.leftCols(3).square().rowwise().sum() + e.rightCols(3).square().rowwise().sum() / 2;
  for (int i = 0; i < kSolidStrains; ++i) {
    const double second = i < 3 ? 2 : 1;
    jet.gradient.col(i) = second * e.col(i);
    jet.set_hessian(i, i, constant(second));
  }
  return jet;
}

// I1 - 3
MetricJet first_invariant(const LaneView& e) {
  MetricJet jet = trace(e);
  jet.value *= 2;
  jet.gradient *= 2;
  return jet;
}

// I2 - 3, in strains: no difference of large numbers near rest.
MetricJet second_invariant(const LaneView& e) {
  const CauchyGreen c(e);
  MetricJet jet;
  jet.value = 4 * (e.col(0) + e.col(1) + e.col(2)) +
              4 * (e.col(0) * e.col(1) + e.col(1) * e.col(2) + e.col(0) * e.col(2)) -
              e.rightCols(3).square().rowwise().sum();
  jet.gradient.col(0) = 2 * (c.y + c.z);
  jet.gradient.col(1) = 2 * (c.x + c.z);
  jet.gradient.col(2) = 2 * (c.x + c.y);
  jet.gradient.rightCols<3>() = -2 * e.rightCols(3);
  for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {1, 2}}) jet.set_hessian(i, j, constant(4));
  for (int i = 3; i < 6; ++i) jet.set_hessian(i, i, constant(-2));
  return jet;
}

// det C - 1
MetricJet determinant(const LaneView& e) {
  const CauchyGreen c(e);
  MetricJet jet;
  const Lane a = 2 * e.col(0), b = 2 * e.col(1), d = 2 * e.col(2);
  jet.value = a + b + d + a * b + b * d + a * d + a * b * d + 2 * c.yz * c.xz * c.xy -
              c.x * c.yz.square() - c.y * c.xz.square() - c.z * c.xy.square();
  jet.gradient.col(0) = 2 * (c.y * c.z - c.yz.square());
  jet.gradient.col(1) = 2 * (c.x * c.z - c.xz.square());
  jet.gradient.col(2) = 2 * (c.x * c.y - c.xy.square());
  jet.gradient.col(3) = 2 * (c.xz * c.xy - c.x * c.yz);
  jet.gradient.col(4) = 2 * (c.yz * c.xy - c.y * c.xz);
  jet.gradient.col(5) = 2 * (c.yz * c.xz - c.z * c.xy);
  jet.set_hessian(0, 1, 4 * c.z);
  jet.set_hessian(0, 2, 4 * c.y);
  jet.set_hessian(1, 2, 4 * c.x);
  jet.set_hessian(0, 3, -4 * c.yz);
  jet.set_hessian(1, 4, -4 * c.xz);
  jet.set_hessian(2, 5, -4 * c.xy);
  jet.set_hessian(3, 3, -2 * c.x);
  jet.set_hessian(4, 4, -2 * c.y);
  jet.set_hessian(5, 5, -2 * c.z);
  jet.set_hessian(3, 4, 2 * c.xy);
  jet.set_hessian(3, 5, 2 * c.xz);
  jet.set_hessian(4, 5, 2 * c.yz);
  return jet;
}

// (1 + x)^power - 1
MetricJet power(const MetricJet& x, double power) {
  const Lane log = x.value.log1p(), less = power * ((power - 1) * log).exp();
  return composed(x, (power * log).expm1(), less, (power - 1) * less / (1 + x.value));
}

MetricJet volume(const LaneView& e) { return power(determinant(e), 0.5); }

MetricJet log_volume(const LaneView& e) {
  const MetricJet det = determinant(e);
  const Lane inverse = 1 / (1 + det.value);
  return composed(det, det.value.log1p() / 2, inverse / 2, -inverse.square() / 2);
}

// (x + 3) (1 + y) - 3 for x = I - 3 and y = J^n - 1
MetricJet isochoric(MetricJet invariant, MetricJet volume) {
  const Lane less = invariant.value + (invariant.value + 3) * volume.value;
  invariant.value += 3;
  volume.value += 1;
  MetricJet jet = product(invariant, volume);
  jet.value = less;
  return jet;
}

MetricJet first_isochoric(const LaneView& e) {
  return isochoric(first_invariant(e), power(determinant(e), -1.0 / 3));
}

MetricJet second_isochoric(const LaneView& e) {
  return isochoric(second_invariant(e), power(determinant(e), -2.0 / 3));
}

// Stretch of fibres along an axis, less one.
template <int kAxis>
MetricJet fibre(const LaneView& e) {
  MetricJet square = green<kAxis>(e);
  square.value *= 2;
  square.gradient *= 2;
  return power(square, 0.5);
}

constexpr std::array kMetrics{
    StrainMetric{"green.xx", "Green strain along x", false, false, green<0>},
    StrainMetric{"green.yy", "Green strain along y", false, false, green<1>},
    StrainMetric{"green.zz", "Green strain along z", false, false, green<2>},
    StrainMetric{"green.yz", "shear strain between y and z, 2 E_yz", true, false, green<3>},
    StrainMetric{"green.xz", "shear strain between x and z, 2 E_xz", true, false, green<4>},
    StrainMetric{"green.xy", "shear strain between x and y, 2 E_xy", true, false, green<5>},
    StrainMetric{"green.xx+yy", "sum of the Green strains along x and y", false, false,
                 green_sum<0, 1>},
    StrainMetric{"green.yy+zz", "sum of the Green strains along y and z", false, false,
                 green_sum<1, 2>},
    StrainMetric{"green.xx+zz", "sum of the Green strains along x and z", false, false,
                 green_sum<0, 2>},
    StrainMetric{"trace", "trace of the Green strain", false, false, trace},
    StrainMetric{"trace-of-square", "trace of the square of the Green strain", false, true,
                 trace_of_square},
    StrainMetric{"I1", "first invariant of C, less 3", false, false, first_invariant},
    StrainMetric{"I2", "second invariant of C, less 3", false, false, second_invariant},
    StrainMetric{"I1-bar", "first invariant of C / J^(2/3), less 3", false, true, first_isochoric},
    StrainMetric{"I2-bar", "second invariant of C / J^(2/3), less 3", false, true,
                 second_isochoric},
    StrainMetric{"J", "volume over rest volume, less 1", false, false, volume},
    StrainMetric{"log-J", "logarithm of volume over rest volume", false, false, log_volume},
    StrainMetric{"fibre.x", "stretch along x, less 1", false, false, fibre<0>},
    StrainMetric{"fibre.y", "stretch along y, less 1", false, false, fibre<1>},
    StrainMetric{"fibre.z", "stretch along z, less 1", false, false, fibre<2>},
};

}  // namespace

std::span<const StrainMetric> strain_metrics() { return kMetrics; }

const StrainMetric* find_strain_metric(std::string_view name) {
  const auto found = std::ranges::find(kMetrics, name, &StrainMetric::name);
  return found == kMetrics.end() ? nullptr : &*found;
}

}  // namespace pliant
