#pragma once

#include <functional>
#include <string>
#include <vector>

#include "estimation/virtual_study.h"

namespace pliant::test {

/// An estimate beside what it is of.
struct Sample {
  ParameterEstimate estimate;
  double truth = 0;
};

/// What is said about one number over all seeds.
struct Coverage {
  std::string name;
  int identified = 0;
  int with_interval = 0;
  int covered = 0;
  double mean_error = 0;       ///< in true standard deviations
  double std_error_ratio = 0;  ///< mean stated standard error per true standard deviation
  double rate() const { return static_cast<double>(covered) / with_interval; }
};

Coverage coverage_of(const std::string& name, const std::vector<StudyResult>& results,
                     const std::function<Sample(const StudyResult&)>& sample_of);

Coverage coverage_of_parameter(const std::string& name, const std::vector<StudyResult>& results,
                               const Material& truth);

/// Fits the virtual measurements of some seeds; `edit` completes each study.
std::vector<StudyResult> fit_seeds(const VirtualLab& lab, void (*edit)(VirtualStudy&), int seeds);

void print_rates(const std::string& title, const std::vector<Coverage>& table, int seeds);

/// The fewest of so many intervals that hold the truth, with 95 % each, but once in a thousand
/// times.
int fewest_covered(int intervals);

}  // namespace pliant::test
