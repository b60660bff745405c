#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/random.h"
#include "pliant/estimation/statistics/covariance.h"
#include "pliant/estimation/statistics/experiment_noise.h"

namespace pliant::test {

/// What an experiment measures as a function of the unknowns, without units.
struct Prediction {
  Eigen::VectorXd value;
  Eigen::MatrixXd jacobian;
};

/// An experiment made of numbers.
struct SyntheticExperiment {
  std::function<Prediction(const Eigen::VectorXd& unknowns)> predict;
  Eigen::VectorXd measured;
  std::vector<int> series;  ///< of each row
  std::vector<int> group;   ///< of each row: the half cycle, from 0
  std::string quantity = "force";
  std::optional<double> stated;
};

/// A linear one whose rows are one series and, if none are given, one group.
SyntheticExperiment linear_experiment(const Eigen::MatrixXd& jacobian, std::vector<int> group = {});

/// Prior knowledge of one unknown.
struct SyntheticPrior {
  Eigen::Index unknown = 0;
  double mean = 0, sd = 1;
};

/// A fit by Gauss and Newton's method whose weights have settled.
struct SyntheticFit {
  Eigen::VectorXd estimate;
  EstimatingSums sums;
  std::vector<ExperimentNoise> noise;
  ParameterErrors errors;
  double cost = 0;  ///< half the sum of squares in units of sd sqrt(L), priors included

  /// Whether the 95 % interval of an unknown holds a value.
  bool holds(Eigen::Index unknown, double value) const {
    return std::abs(estimate(unknown) - value) <= errors.half_width(unknown);
  }
};

/// @param start   of the search; also the unit of each unknown
SyntheticFit fit_synthetic(const std::vector<SyntheticExperiment>& experiments,
                           const Eigen::VectorXd& start,
                           const std::vector<SyntheticPrior>& priors = {});

/// Noise of standard deviation 1 that remembers the row before it.
Eigen::VectorXd autoregressive_noise(Eigen::Index rows, double memory, RandomStream& random);

/// Prediction at the true unknowns plus noise of this size becomes the measured column.
void measure(SyntheticExperiment& experiment, const Eigen::VectorXd& truth, double sd,
             const Eigen::VectorXd& noise);

/// Share of the seeds, from 0, for which something holds.
double rate_of(int seeds, const std::function<bool(RandomStream& random)>& holds);

/// Strains of load-unload cycles to 0.2, with the group (half cycle) and the share of friction's
/// saturation, -1 to 1, of each row.
struct StrainPath {
  Eigen::VectorXd strain, friction;
  std::vector<int> half_cycle;
};
StrainPath strain_cycles(int rows, int cycles);

/// Columns: strain, strain^2, friction, strain * friction, 1 (the first `unknowns` of them), all of
/// the size of 1.
Eigen::MatrixXd strip_jacobian(const StrainPath& path, int unknowns);

}  // namespace pliant::test
