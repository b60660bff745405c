#pragma once

#include "pliant/material/density/scalar_density.h"
#include "pliant/material/solid/metric.h"

namespace pliant {

/// The law of a solid's point by a law of one strain on a scalar of the Green strain.
class MetricDensity : public ScalarDensity<StrainMetric> {
 public:
  MetricDensity(const StrainMetric& metric, std::shared_ptr<const ParametricDensity> law)
      : ScalarDensity(metric, std::move(law)) {}
};

}  // namespace pliant
