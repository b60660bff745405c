#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// What the noise of an experiment was taken from.
enum class NoiseSource {
  stated,             ///< the study states it, and the residuals do not exceed it
  residuals,          ///< at least five spare rows
  resolution,         ///< the instrument's: residuals are smaller
  other_experiments,  ///< assumed: the pooled noise of experiments that measure the same quantity
  measured_range,     ///< assumed: 1 % of the measured range
  few_residuals,      ///< fewer than five spare rows, which contradict what else would be assumed
};

/// An experiment at a solution.
struct ExperimentResiduals {
  Eigen::VectorXd residual;      ///< predicted - measured, in the measured unit, along the path
  std::vector<int> series;       ///< of each row: its specimen and run; neighbours join one series
  double leverage = 0;           ///< sum over the rows (`row_leverages`)
  std::string quantity;          ///< experiments of one quantity and instrument have one name
  std::optional<double> stated;  ///< standard deviation
  double resolution = 0;         ///< step of the instrument; 0: finer than matters
  double range = 0;              ///< of the measured values, > 0
  double carried_mean_square = 0;  ///< mean square that stated noise of another channel explains
};

/// How strongly its rows count: a row's weight is 1 / (sd sqrt(correlation_length)).
struct ExperimentNoise {
  double sd = 0;  ///< of a row, in the measured unit, without what another channel carries in
  NoiseSource source = NoiseSource::residuals;
  double correlation_length = 1;
  double rows = 0;
  double effective_rows = 0;  ///< rows / correlation length
  double spare_rows = 0;      ///< effective rows - leverage; may be negative
  double degrees = 0;         ///< of freedom of sd: infinite where it is stated, >= 1
  /// The fit says so: the residuals cannot tell the noise.
  bool is_assumed() const {
    return source == NoiseSource::other_experiments || source == NoiseSource::measured_range;
  }
};

/// The noise of each experiment at a solution.
///
/// sd^2 = sum r^2 / (rows - L leverage): what the unknowns took out of the residuals is put back,
/// also where they go together over L rows (`correlation_length`). With fewer than five rows -
/// leverage that says nothing; then the pooled sd of experiments of the same quantity is assumed
/// (their summed r^2 over their summed spare rows), else 1 % of the range, unless the residuals
/// contradict it (chi squared at 95 %). A stated sd is a floor where residuals can tell; so is the
/// resolution, step / sqrt(12), everywhere.
///
/// Noise and leverage depend on each other: fit, measure and fit again until both settle.
std::vector<ExperimentNoise> measure_noise(const std::vector<ExperimentResiduals>& experiments);

/// "stated", "residuals", "resolution", "other experiments", "1 % of the range", "few residuals".
std::string_view name_of(NoiseSource source);

/// Rows by how many of them are independent.
struct EffectiveRows {
  double rows = 0;
  double effective = 0;  ///< sum of rows / L
  double spare = 0;      ///< effective - leverage
};
EffectiveRows effective_rows(const std::vector<ExperimentNoise>& experiments);

/// Diagonal of the hat matrix: by how much a row's own measured value moves its prediction.
/// @param weighted       Jacobian of rows by unknowns, each row divided by its sd sqrt(L)
/// @param inverse_slope  inverse of G (`EstimatingSums::slope`), priors included
/// @param told           which unknowns these rows are allowed to tell; empty: all
Eigen::VectorXd row_leverages(const Eigen::MatrixXd& weighted, const Eigen::MatrixXd& inverse_slope,
                              const std::vector<char>& told = {});

}  // namespace pliant
