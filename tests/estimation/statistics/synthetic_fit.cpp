#include "estimation/statistics/synthetic_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace pliant::test {
namespace {

constexpr int kRounds = 12;  // weights settle to a few per cent in five

Eigen::MatrixXd prior_sum(const std::vector<SyntheticPrior>& priors, Eigen::Index unknowns) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(unknowns, unknowns);
  for (const SyntheticPrior& prior : priors) {
    sum(prior.unknown, prior.unknown) += 1 / (prior.sd * prior.sd);
  }
  return sum;
}

Eigen::VectorXd prior_part(const std::vector<SyntheticPrior>& priors, const Eigen::VectorXd& p) {
  Eigen::VectorXd part = Eigen::VectorXd::Zero(p.size());
  for (const SyntheticPrior& prior : priors) {
    part(prior.unknown) += (p(prior.unknown) - prior.mean) / (prior.sd * prior.sd);
  }
  return part;
}

double first_sd(const SyntheticExperiment& experiment) {
  const double range = experiment.measured.maxCoeff() - experiment.measured.minCoeff();
  return experiment.stated.value_or(0.01 * std::max(range, 1e-12));
}

double weight_of(const ExperimentNoise& noise) {
  return 1 / (noise.sd * std::sqrt(noise.correlation_length));
}

/// Groups of all experiments at the unknowns, with the weights of `noise`.
std::vector<GroupSum> group_sums(const std::vector<SyntheticExperiment>& experiments,
                                 const Eigen::VectorXd& p,
                                 const std::vector<ExperimentNoise>& noise) {
  std::vector<GroupSum> sums;
  for (size_t e = 0; e < experiments.size(); ++e) {
    const SyntheticExperiment& experiment = experiments[e];
    const Prediction prediction = experiment.predict(p);
    const int groups = 1 + *std::max_element(experiment.group.begin(), experiment.group.end());
    for (int group = 0; group < groups; ++group) {
      std::vector<Eigen::Index> rows;
      for (size_t i = 0; i < experiment.group.size(); ++i) {
        if (experiment.group[i] == group) rows.push_back(static_cast<Eigen::Index>(i));
      }
      const Eigen::VectorXd residual = prediction.value - experiment.measured;
      sums.push_back(group_sum(static_cast<int>(e),
                               weight_of(noise[e]) * prediction.jacobian(rows, Eigen::all),
                               weight_of(noise[e]) * residual(rows)));
    }
  }
  return sums;
}

std::vector<ExperimentResiduals> residuals_at(const std::vector<SyntheticExperiment>& experiments,
                                              const Eigen::VectorXd& p,
                                              const Eigen::MatrixXd& inverse_slope,
                                              const std::vector<ExperimentNoise>& noise) {
  std::vector<ExperimentResiduals> all;
  for (size_t e = 0; e < experiments.size(); ++e) {
    const SyntheticExperiment& experiment = experiments[e];
    const Prediction prediction = experiment.predict(p);
    ExperimentResiduals one;
    one.residual = prediction.value - experiment.measured;
    one.series = experiment.series;
    one.leverage = row_leverages(weight_of(noise[e]) * prediction.jacobian, inverse_slope).sum();
    one.quantity = experiment.quantity;
    one.stated = experiment.stated;
    one.range = std::max(experiment.measured.maxCoeff() - experiment.measured.minCoeff(),
                         experiment.measured.cwiseAbs().maxCoeff());
    all.push_back(one);
  }
  return all;
}

}  // namespace

SyntheticExperiment linear_experiment(const Eigen::MatrixXd& jacobian, std::vector<int> group) {
  SyntheticExperiment experiment;
  experiment.predict = [jacobian](const Eigen::VectorXd& p) {
    return Prediction{jacobian * p, jacobian};
  };
  const auto rows = static_cast<size_t>(jacobian.rows());
  experiment.series.assign(rows, 0);
  experiment.group = group.empty() ? std::vector<int>(rows, 0) : std::move(group);
  return experiment;
}

SyntheticFit fit_synthetic(const std::vector<SyntheticExperiment>& experiments,
                           const Eigen::VectorXd& start,
                           const std::vector<SyntheticPrior>& priors) {
  SyntheticFit fit;
  fit.estimate = start;
  const Eigen::VectorXd unit = start.cwiseAbs();
  fit.sums.priors = prior_sum(priors, start.size());
  fit.noise.resize(experiments.size());
  for (size_t e = 0; e < experiments.size(); ++e) fit.noise[e].sd = first_sd(experiments[e]);
  std::vector<double> degrees(experiments.size(), 1);
  for (int round = 0; round < kRounds; ++round) {
    fit.sums.groups = group_sums(experiments, fit.estimate, fit.noise);
    const FormulaCovariance formula = formula_covariance(fit.sums, unit, degrees);
    Eigen::VectorXd part = prior_part(priors, fit.estimate);
    for (const GroupSum& group : fit.sums.groups) part += group.part;
    fit.estimate -= formula.inverse_slope * part;
    if (round + 1 < kRounds) {
      fit.noise =
          measure_noise(residuals_at(experiments, fit.estimate, formula.inverse_slope, fit.noise));
    }
  }
  for (size_t e = 0; e < experiments.size(); ++e) degrees[e] = fit.noise[e].degrees;
  fit.sums.groups = group_sums(experiments, fit.estimate, fit.noise);
  fit.errors = parameter_errors(fit.sums, unit, degrees);
  return fit;
}

Eigen::VectorXd autoregressive_noise(Eigen::Index rows, double memory, RandomStream& random) {
  Eigen::VectorXd noise(rows);
  double last = random.normal();
  for (Eigen::Index i = 0; i < rows; ++i) {
    noise(i) = last;
    last = memory * last + std::sqrt(1 - memory * memory) * random.normal();
  }
  return noise;
}

void measure(SyntheticExperiment& experiment, const Eigen::VectorXd& truth, double sd,
             const Eigen::VectorXd& noise) {
  experiment.measured = experiment.predict(truth).value + sd * noise;
}

double rate_of(int seeds, const std::function<bool(RandomStream& random)>& holds) {
  int held = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed));
    if (holds(random)) ++held;
  }
  return static_cast<double>(held) / seeds;
}

StrainPath strain_cycles(int rows, int cycles) {
  StrainPath path{Eigen::VectorXd(rows), Eigen::VectorXd(rows), {}};
  for (int i = 0; i < rows; ++i) {
    const double phase = (i + 0.5) / rows * cycles * 2;
    const int half = static_cast<int>(phase);
    const double share = phase - half;
    const double amplitude = 0.2 * (half / 2 + 1) / cycles;
    const bool up = half % 2 == 0;
    path.strain(i) = amplitude * (up ? share : 1 - share);
    // Dahl's law from saturation on the other side, tau = 0.02.
    path.friction(i) = (up ? 1 : -1) * (1 - 2 * std::exp(-amplitude * share / 0.02));
    path.half_cycle.push_back(half);
  }
  return path;
}

Eigen::MatrixXd strip_jacobian(const StrainPath& path, int unknowns) {
  const Eigen::ArrayXd x = path.strain.array() / 0.2, friction = path.friction.array();
  Eigen::MatrixXd all(x.size(), 5);
  all << x, x * x, friction, x * friction, Eigen::ArrayXd::Ones(x.size());
  return all.leftCols(unknowns);
}

}  // namespace pliant::test
