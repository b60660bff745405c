#include "estimation/interval_coverage.h"

#include <cmath>

#include <fmt/format.h>

#include "pliant/base/parallel.h"

namespace pliant::test {

Coverage coverage_of(const std::string& name, const std::vector<StudyResult>& results,
                     const std::function<Sample(const StudyResult&)>& sample_of) {
  Coverage coverage{name};
  double sum = 0, squares = 0, stated = 0;
  for (const StudyResult& result : results) {
    const Sample sample = sample_of(result);
    const ParameterEstimate& p = sample.estimate;
    if (p.identified) ++coverage.identified;
    if (!p.lower) continue;  // at a bound
    ++coverage.with_interval;
    if (*p.lower <= sample.truth && sample.truth <= *p.upper) ++coverage.covered;
    const double error = p.value - sample.truth;
    sum += error;
    squares += error * error;
    stated += *p.std_error;
  }
  const double mean = sum / coverage.with_interval;
  const double sd = std::sqrt(squares / coverage.with_interval - mean * mean);
  coverage.mean_error = mean / sd;
  coverage.std_error_ratio = stated / coverage.with_interval / sd;
  return coverage;
}

Coverage coverage_of_parameter(const std::string& name, const std::vector<StudyResult>& results,
                               const Material& truth) {
  return coverage_of(name, results, [&](const StudyResult& result) {
    return Sample{estimate_named(result, name), truth_of(truth, name)};
  });
}

std::vector<StudyResult> fit_seeds(const VirtualLab& lab, void (*edit)(VirtualStudy&), int seeds) {
  std::vector<StudyResult> results(static_cast<size_t>(seeds));
  // Each seed is on its own: the answer does not depend on the number of threads.
  parallel_for(seeds, 2, [&](int i) {
    VirtualStudy study(lab, static_cast<std::uint64_t>(1000 + i));
    edit(study);
    results[static_cast<size_t>(i)] = study.fit();
  });
  return results;
}

void print_rates(const std::string& title, const std::vector<Coverage>& table, int seeds) {
  fmt::print("{}: {} seeds\n{:<28} {:>10} {:>9} {:>11} {:>16}\n", title, seeds, "parameter",
             "identified", "covered", "bias per sd", "std error per sd");
  for (const Coverage& c : table) {
    fmt::print("{:<28} {:>10} {:>7.1f} % {:>11.2f} {:>16.2f}\n", c.name, c.identified,
               100 * c.rate(), c.mean_error, c.std_error_ratio);
  }
}

int fewest_covered(int intervals) {
  constexpr double kRate = 0.95, kRare = 1e-3;
  double all_below = 0;
  int covered = 0;
  for (; covered <= intervals; ++covered) {
    const double ways = std::lgamma(intervals + 1) - std::lgamma(covered + 1) -
                        std::lgamma(intervals - covered + 1);
    all_below +=
        std::exp(ways + covered * std::log(kRate) + (intervals - covered) * std::log(1 - kRate));
    if (all_below > kRare) break;
  }
  return covered;
}

}  // namespace pliant::test
