#pragma once

#include <string>
#include <vector>

#include "pliant/study/results.h"

namespace pliant::report {

/// Correlations of some estimates; NaN where one has no usable variance.
struct CorrelationBlock {
  std::string title;
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
};

/// The correlation matrix of the free, identified parameters and nuisance parameters.
///
/// One block a component where components are estimated independently of each other, one block of
/// everything where they are not. Empty without a covariance.
std::vector<CorrelationBlock> correlation_blocks(const Results& results);

}  // namespace pliant::report
