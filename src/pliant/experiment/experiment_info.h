#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/experiment/experiment_role.h"
#include "pliant/experiment/test_facts.h"
#include "pliant/measurement/data_source.h"

namespace pliant {

/// What an experiment measures row by row, and how results print it.
struct MeasuredQuantity {
  std::string name;   ///< column suffix: measured_NAME, e.g. force_N
  std::string kind;   ///< force, length, ...
  std::string unit;   ///< unit of the column
  double per_si = 1;  ///< column value = per_si * SI value
};

/// Facts of an experiment that hold whatever the law.
struct ExperimentInfo {
  std::string name;
  std::string type;
  TestFacts test;  ///< what holds of all of its type
  std::string direction;
  std::string component;  ///< strain component that it determines, e.g. stretch.warp
  ExperimentRole role = ExperimentRole::fit;
  MeasuredQuantity quantity;
  std::vector<std::string> specimens;
  std::vector<char> used;              ///< a row: does it take part in the fit
  std::optional<double> force_noise;   ///< stated standard deviation of the force (N or N/m)
  std::optional<double> length_noise;  ///< of the length (m)
  double weight = 1;                   ///< of its squared differences, beside those of others
  std::vector<std::string> handled;    ///< what was found in the data and how it was dealt with
  std::vector<std::string> warnings;
  std::vector<std::string> questions;  ///< units and sizes that are hardly right, as warnings
  std::vector<OwnColumn> columns;
  std::vector<double> time;  ///< s; empty unless measured

  /// Whether rows are of different kinds, each in units of its noise.
  bool measures_readings() const { return quantity.kind == "reading"; }
  /// Whether what is measured is a length or a distance, and not a force.
  bool measures_length() const { return quantity.kind == "length" || quantity.kind == "distance"; }
  /// What the study states of the noise of what is measured (SI).
  const std::optional<double>& stated_noise() const {
    return measures_length() ? length_noise : force_noise;
  }
};

}  // namespace pliant
