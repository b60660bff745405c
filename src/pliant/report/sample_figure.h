#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pliant/report/figure.h"
#include "pliant/study/results.h"

namespace pliant::report {

/// One number at each sample of a heterogeneous material.
struct SampledNumber {
  std::string name;  ///< without its sample: `J.k`
  std::vector<ResultParameter> at;
};

/// The numbers of the samples among a result's, in their order; none where nothing differs.
std::vector<SampledNumber> sampled_numbers(const std::vector<ResultParameter>& parameters);

/// A number at each sample with its 95 % interval; apart, what the data do not determine.
Figure sample_figure(const SampledNumber& number);

}  // namespace pliant::report
