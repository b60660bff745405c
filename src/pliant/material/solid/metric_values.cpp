#include "pliant/material/solid/metric_values.h"

#include <Eigen/Eigenvalues>

#include "pliant/base/assert.h"
#include "pliant/material/solid/metric.h"
#include "pliant/material/solid/pair_metric.h"
#include "pliant/material/solid/principal_metric.h"
#include "pliant/material/strain/green_strain.h"

namespace pliant {
namespace {

/// Logarithms of the principal stretches.
Eigen::Array3d log_stretches(const Eigen::Matrix<double, 6, 1>& strain) {
  Eigen::Matrix3d deformation;  // C = 2 E + 1
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      const double value = strain(kSolidStrainOf[a][b]);
      deformation(a, b) = a == b ? 2 * value + 1 : value;
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(deformation, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().array().log() / 2;
}

}  // namespace

std::vector<double> metric_values(const std::string& component,
                                  const Eigen::Matrix<double, 6, 1>& strain) {
  if (const PrincipalMetric* metric = find_principal_metric(component)) {
    const Eigen::Array3d logs = log_stretches(strain);
    std::vector<double> values;
    for (const double log : logs) {
      values.push_back(metric->of_log(log - (metric->isochoric ? logs.mean() : 0)).value);
    }
    return values;
  }
  const Eigen::Array<double, kLanes, kSolidStrains> lanes =
      strain.transpose().array().replicate<kLanes, 1>();
  const LaneView view(lanes.data(), kLanes, kSolidStrains);
  if (const auto pair = find_pair_metric(component)) return {pair->jet(view).value(0)};
  const StrainMetric* metric = find_strain_metric(component);
  PLIANT_ASSERT(metric, "a metric of solids");
  return {metric->jet(view).value(0)};
}

}  // namespace pliant
