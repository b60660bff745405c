#include "pliant/material/solid/principal_metric.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant {
namespace {

ScalarJet stretch(double log_stretch) {
  const double value = std::exp(log_stretch);
  return {std::expm1(log_stretch), value, value};
}

ScalarJet log_stretch(double log_stretch) { return {log_stretch, 1, 0}; }

constexpr std::array kMetrics{
    PrincipalMetric{"stretch", "principal stretches, less 1", false, stretch},
    PrincipalMetric{"stretch-bar", "principal stretches over J^(1/3), less 1", true, stretch},
    PrincipalMetric{"log-stretch", "logarithms of the principal stretches", false, log_stretch},
    PrincipalMetric{"log-stretch-bar", "logarithms of the principal stretches over J^(1/3)", true,
                    log_stretch},
};

}  // namespace

std::span<const PrincipalMetric> principal_metrics() { return kMetrics; }

const PrincipalMetric* find_principal_metric(std::string_view name) {
  const auto found = std::ranges::find(kMetrics, name, &PrincipalMetric::name);
  return found == kMetrics.end() ? nullptr : &*found;
}

}  // namespace pliant
