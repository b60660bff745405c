#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/experiment/experiment_role.h"
#include "pliant/experiment/test_spec.h"
#include "pliant/measurement/data_source.h"

namespace pliant {

/// Rows left out of a fit, numbered from 1 within the experiment's data.
struct ExcludedRows {
  int first = 0;
  int last = 0;
  std::string reason;
};

/// Stated standard deviations of the instrument's noise; absent: estimated from the residuals.
/// Which readings they are of, the channels of the test's type tell.
struct StatedNoise {
  std::optional<double> force;   ///< N, or N/m; of moments per width N
  std::optional<double> length;  ///< m
};

/// One experiment as a study describes it (docs/formats/study.md), SI units.
struct ExperimentSpec {
  std::string name;
  std::string type;       ///< name of the test's type
  std::string direction;  ///< warp, weft, bias; of an oblique strip its angle as the study writes
                          ///< it; empty where the type has none
  std::string standard;
  DataSource data;
  std::shared_ptr<const TestSpec> test;  ///< what the type has beside
  StatedNoise noise;
  std::string after;  ///< the experiment before it that was on the same specimens; empty: they were
                      ///< fresh
  double weight = 1;  ///< of its squared differences, beside those of other experiments
  std::vector<ExcludedRows> excluded;
  std::vector<std::string> told;  ///< what the data files told and the study did not, in sentences
  std::vector<std::string> doubts;  ///< what they tell otherwise than the study, as questions
  ExperimentRole role = ExperimentRole::fit;
  Location where;
};

/// Where `after` stands.
inline Location after_location(const ExperimentSpec& spec) {
  return {spec.where.file, spec.where.line, spec.where.field + ".after"};
}

/// The fields of an experiment's own type, which the caller knows.
template <class Spec>
const Spec& spec_of(const ExperimentSpec& experiment) {
  return dynamic_cast<const Spec&>(*experiment.test);
}

}  // namespace pliant
