#include "pliant/estimation/statistics/experiment_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/base/assert.h"
#include "pliant/estimation/statistics/correlation_length.h"
#include "pliant/estimation/statistics/resolution.h"
#include "pliant/math/quantiles.h"

namespace pliant {
namespace {

constexpr double kFewestSpareRows = 5;
constexpr double kAssumedShare = 0.01;   // of the measured range
constexpr double kSmallestShare = 1e-9;  // of the range: noise-free data still has a weight
constexpr double kContradiction = 0.95;  // chi squared beyond it contradicts an assumption

std::vector<ResidualSeries> series_of(const ExperimentResiduals& experiment) {
  PLIANT_ASSERT(experiment.series.size() == static_cast<size_t>(experiment.residual.size()),
                "each row belongs to a series");
  std::vector<ResidualSeries> series;
  for (size_t i = 0; i < experiment.series.size(); ++i) {
    if (i == 0 || experiment.series[i] != experiment.series[i - 1]) series.emplace_back();
    series.back().push_back(experiment.residual(static_cast<Eigen::Index>(i)));
  }
  return series;
}

/// Sum of squares of the residuals that the noise itself has to explain.
double own_squares(const ExperimentResiduals& experiment) {
  const auto rows = static_cast<double>(experiment.residual.size());
  return std::max(experiment.residual.squaredNorm() - rows * experiment.carried_mean_square, 0.0);
}

bool tells_noise(const ExperimentResiduals& experiment) {
  return static_cast<double>(experiment.residual.size()) - experiment.leverage >= kFewestSpareRows;
}

/// Rows that sd is told by: rows - L leverage.
double spare_for_sd(const ExperimentNoise& noise) {
  return noise.spare_rows * noise.correlation_length;
}

/// From the residuals alone; sd is 0 where too few rows are spare.
ExperimentNoise from_residuals(const ExperimentResiduals& experiment) {
  ExperimentNoise noise;
  noise.rows = static_cast<double>(experiment.residual.size());
  noise.correlation_length = correlation_length(series_of(experiment), experiment.leverage);
  noise.effective_rows = noise.rows / noise.correlation_length;
  noise.spare_rows = noise.effective_rows - experiment.leverage;
  noise.degrees = std::max(noise.spare_rows, 1.0);
  if (tells_noise(experiment)) {
    noise.sd = std::sqrt(own_squares(experiment) / spare_for_sd(noise));
  }
  return noise;
}

/// What an experiment with too few rows is assumed to have.
struct Assumption {
  double sd = 0;
  NoiseSource source = NoiseSource::measured_range;
  double degrees = std::numeric_limits<double>::infinity();
};

Assumption assumed_noise(const ExperimentResiduals& experiment,
                         const std::vector<ExperimentResiduals>& all,
                         const std::vector<ExperimentNoise>& told) {
  double squares = 0, spare = 0, degrees = 0;
  for (size_t e = 0; e < all.size(); ++e) {
    if (!tells_noise(all[e]) || all[e].quantity != experiment.quantity) continue;
    squares += own_squares(all[e]);
    spare += spare_for_sd(told[e]);
    degrees += told[e].spare_rows;
  }
  if (spare == 0) return {kAssumedShare * experiment.range};
  return {std::sqrt(squares / spare), NoiseSource::other_experiments, degrees};
}

void assume(const Assumption& assumption, const ExperimentResiduals& experiment,
            ExperimentNoise& noise) {
  noise.sd = assumption.sd;
  noise.source = assumption.source;
  noise.degrees = assumption.degrees;
  if (noise.spare_rows <= 0) return;
  const double expected = spare_for_sd(noise);
  const double squares = own_squares(experiment);
  const double possible =
      chi_square_quantile(kContradiction, expected) * assumption.sd * assumption.sd;
  if (squares <= possible) return;
  noise.sd = std::sqrt(squares / expected);
  noise.source = NoiseSource::few_residuals;
  noise.degrees = std::max(noise.spare_rows, 1.0);
}

void take_stated(const ExperimentResiduals& experiment, ExperimentNoise& noise) {
  if (tells_noise(experiment) && noise.sd > *experiment.stated) return;
  noise.sd = *experiment.stated;
  noise.source = NoiseSource::stated;
  noise.degrees = std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<ExperimentNoise> measure_noise(const std::vector<ExperimentResiduals>& experiments) {
  std::vector<ExperimentNoise> told;
  for (const ExperimentResiduals& experiment : experiments) {
    told.push_back(from_residuals(experiment));
  }
  std::vector<ExperimentNoise> result = told;
  for (size_t e = 0; e < experiments.size(); ++e) {
    const ExperimentResiduals& experiment = experiments[e];
    ExperimentNoise& noise = result[e];
    if (experiment.stated) {
      take_stated(experiment, noise);
    } else if (!tells_noise(experiment)) {
      assume(assumed_noise(experiment, experiments, told), experiment, noise);
    }
    const double rounding = rounding_sd(experiment.resolution);
    if (noise.sd < rounding) {
      noise.sd = rounding;
      noise.source = NoiseSource::resolution;
    }
    noise.sd = std::max(noise.sd, kSmallestShare * experiment.range);
  }
  return result;
}

std::string_view name_of(NoiseSource source) {
  switch (source) {
    case NoiseSource::stated:
      return "stated";
    case NoiseSource::residuals:
      return "residuals";
    case NoiseSource::resolution:
      return "resolution";
    case NoiseSource::other_experiments:
      return "other experiments";
    case NoiseSource::measured_range:
      return "1 % of the range";
    case NoiseSource::few_residuals:
      return "few residuals";
  }
  return "";
}

EffectiveRows effective_rows(const std::vector<ExperimentNoise>& experiments) {
  EffectiveRows sum;
  for (const ExperimentNoise& noise : experiments) {
    sum.rows += noise.rows;
    sum.effective += noise.effective_rows;
    sum.spare += noise.spare_rows;
  }
  return sum;
}

Eigen::VectorXd row_leverages(const Eigen::MatrixXd& weighted, const Eigen::MatrixXd& inverse_slope,
                              const std::vector<char>& told) {
  Eigen::MatrixXd telling = weighted;
  for (size_t u = 0; u < told.size(); ++u) {
    if (!told[u]) telling.col(static_cast<Eigen::Index>(u)).setZero();
  }
  return (weighted * inverse_slope).cwiseProduct(telling).rowwise().sum();
}

}  // namespace pliant
