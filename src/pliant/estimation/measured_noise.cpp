#include "pliant/estimation/measured_noise.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/errors.h"
#include "pliant/estimation/estimating_equations.h"
#include "pliant/estimation/statistics/covariance.h"
#include "pliant/estimation/statistics/resolution.h"

namespace pliant {
namespace {

constexpr int kRounds = 6;
constexpr double kSettled = 1e-3;  // of sd and L

/// Rows that count, channel by channel in the order of measurement, and the channel of each.
struct CountedRows {
  std::vector<Eigen::Index> row;
  std::vector<int> channel;
};

CountedRows counted_rows(const ProblemPart& part) {
  CountedRows counted;
  int channel = 0;
  for (const std::vector<int>& series : part.experiment->series()) {
    for (const int row : series) {
      if (!(part.weight(row) > 0)) continue;
      counted.row.push_back(row);
      counted.channel.push_back(channel);
    }
    ++channel;
  }
  return counted;
}

/// Standard deviation of each row that noise of the length carries in.
Eigen::VectorXd carried_noise(const ExperimentInfo& info, const PredictedRows& rows) {
  if (info.measures_length() || !info.length_noise || rows.length_gain.size() == 0) {
    return Eigen::VectorXd::Zero(rows.value.size());
  }
  return *info.length_noise * rows.length_gain;
}

ExperimentResiduals residuals_of(const ProblemPart& part, const PredictedRows& rows,
                                 const CountedRows& counted, const Eigen::VectorXd& leverage,
                                 RobustLoss loss) {
  const Experiment& experiment = *part.experiment;
  const ExperimentInfo& info = experiment.info();
  ExperimentResiduals result;
  result.residual = (rows.value - experiment.measured())(counted.row);
  if (loss != RobustLoss::none) result.residual = tamed(result.residual);
  result.series = counted.channel;
  result.leverage = leverage(counted.row).sum();
  result.quantity = info.type + " " + info.quantity.name;
  if (part.takes_stated_noise) {
    result.stated = info.stated_noise();
    const std::vector<double> column(experiment.measured().begin(), experiment.measured().end());
    result.resolution = resolution_of(column).value_or(0);
  }
  result.range = experiment.reference();
  result.carried_mean_square = carried_noise(info, rows)(counted.row).squaredNorm() /
                               std::max(static_cast<double>(counted.row.size()), 1.0);
  return result;
}

void weigh(const Problem& problem, std::size_t p, MeasuredNoise& noise) {
  const ProblemPart& part = problem.parts()[p];
  const RobustLoss loss = problem.loss();
  const ExperimentNoise& own = noise.of[p];
  const Eigen::ArrayXd carried = carried_noise(part.experiment->info(), noise.rows[p]);
  noise.row_sd[p] = (carried.square() + own.sd * own.sd).sqrt();
  const Eigen::ArrayXd sd = noise.row_sd[p].array() * std::sqrt(own.correlation_length);
  Eigen::ArrayXd each = problem.emphasis(p) / sd;
  if (part.unit) each.setConstant(problem.emphasis(p) / *part.unit);
  noise.weight[p] = (part.weight.array() > 0).select(each, 0.0);
  noise.scatter[p] = each * sd;
  const Eigen::VectorXd residual = noise.rows[p].value - part.experiment->measured();
  for (Eigen::Index i = 0; loss != RobustLoss::none && i < residual.size(); ++i) {
    const double in_sd = residual(i) / noise.row_sd[p](i);
    noise.weight[p](i) *= std::sqrt(robust_weight(loss, in_sd * in_sd));
  }
}

/// By how much noise differs from what it was before.
double change(const std::vector<ExperimentNoise>& now, const std::vector<ExperimentNoise>& before) {
  double largest = before.empty() ? 1 : 0;
  for (std::size_t p = 0; p < before.size(); ++p) {
    largest = std::max({largest, std::abs(now[p].sd / before[p].sd - 1),
                        std::abs(now[p].correlation_length / before[p].correlation_length - 1)});
  }
  return largest;
}

void measure_leverages(const Problem& problem, const ToldUnknowns& told, MeasuredNoise& noise) {
  const std::vector<Eigen::Index> free = free_unknowns(problem.unknowns());
  if (free.empty()) return;
  const EstimatingSums sums =
      estimating_sums(problem, noise.rows, noise.weight, noise.scatter, free, told);
  const Eigen::VectorXd unit = units_of(problem.unknowns(), free);
  const std::vector<double> infinite(noise.of.size(), INFINITY);
  noise.inverse_slope = formula_covariance(sums, unit, infinite).inverse_slope;
  for (std::size_t p = 0; p < noise.rows.size(); ++p) {
    const Eigen::MatrixXd weighted =
        noise.weight[p].asDiagonal() * Eigen::MatrixXd(noise.rows[p].by(Eigen::all, free));
    noise.leverage[p] = row_leverages(weighted, noise.inverse_slope, told_of(told, p, free));
  }
}

}  // namespace

std::vector<Eigen::Index> free_unknowns(const std::vector<Unknown>& unknowns) {
  std::vector<Eigen::Index> free;
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    if (unknowns[u].lower < unknowns[u].upper) free.push_back(static_cast<Eigen::Index>(u));
  }
  return free;
}

MeasuredNoise measure_noise(const Problem& problem, const Eigen::VectorXd& values,
                            const ToldUnknowns& told) {
  const std::vector<ProblemPart>& parts = problem.parts();
  MeasuredNoise noise;
  std::vector<CountedRows> counted;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    auto rows = problem.predict(p, values, /*derivatives=*/true);
    if (!rows) {
      throw SolverError("the prediction of " + parts[p].experiment->info().name, 0, 0);
    }
    noise.rows.push_back(std::move(*rows));
    noise.leverage.push_back(Eigen::VectorXd::Zero(parts[p].weight.size()));
    counted.push_back(counted_rows(parts[p]));
  }
  noise.row_sd.resize(parts.size());
  noise.weight.resize(parts.size());
  noise.scatter.resize(parts.size());
  std::vector<ExperimentNoise> before;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<ExperimentResiduals> residuals;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      residuals.push_back(
          residuals_of(parts[p], noise.rows[p], counted[p], noise.leverage[p], problem.loss()));
    }
    noise.of = measure_noise(residuals);
    for (std::size_t p = 0; p < parts.size(); ++p) weigh(problem, p, noise);
    measure_leverages(problem, told, noise);
    if (change(noise.of, before) < kSettled) break;
    before = noise.of;
  }
  return noise;
}

}  // namespace pliant
