#include "pliant/estimation/nuisance_warnings.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <Eigen/QR>
#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/estimation/reading_grid.h"

namespace pliant {
namespace {

/// A number of an experiment's own, and what it adds to the weighted predictions.
struct NuisanceEffect {
  std::string name, unit;
  double value = 0;
  Eigen::VectorXd added;
};

std::vector<NuisanceEffect> effects_of(const ComponentProblem& problem, const ComponentFit& fit,
                                       std::size_t e) {
  const MeasuredNoise& noise = fit.uncertainty.noise;
  const auto count = static_cast<Eigen::Index>(problem.experiments()[e]->nuisance().size());
  const Eigen::Index first = fit.fit.law.parameter_count() + problem.first_nuisance(e);
  std::vector<NuisanceEffect> effects;
  for (Eigen::Index u = first; u < first + count; ++u) {
    const Unknown& unknown = fit.fit.unknowns[static_cast<std::size_t>(u)];
    if (unknown.fixed) continue;
    const double value = fit.fit.solution.parameters(u);
    effects.push_back(
        {unknown.name, unknown.unit, value,
         noise.weight[e].cwiseProduct(noise.rows[e].by.col(u)) * (value - unknown.start)});
  }
  return effects;
}

/// Numbers that each move the predictions by much, and together by little.
void warn_of_cancelling(const ComponentProblem& problem, const ComponentFit& fit, std::size_t e,
                        std::vector<std::string>& warnings) {
  constexpr double kMatters = 0.01;  // of the reference, by the root mean square
  constexpr double kAboveNoise = 3, kLeft = 0.5;
  const ComponentExperiment& experiment = *problem.experiments()[e];
  const Eigen::VectorXd& weight = fit.uncertainty.noise.weight[e];
  const double much = std::max(kMatters * experiment.reference() * weight.norm(),
                               kAboveNoise * std::sqrt((weight.array() > 0).cast<double>().sum()));
  const std::vector<NuisanceEffect> effects = effects_of(problem, fit, e);
  for (std::size_t i = 0; i < effects.size(); ++i) {
    for (std::size_t j = i + 1; j < effects.size(); ++j) {
      const double less = std::min(effects[i].added.norm(), effects[j].added.norm());
      if (less < much || (effects[i].added + effects[j].added).norm() > kLeft * less) continue;
      warnings.push_back(fmt::format(
          "{}: {} of {:.3g} {} and {} of {:.3g} {} undo each other: the data do not tell them "
          "apart, and the law bears what they miss; hold one of them",
          experiment.info().name, effects[i].name, effects[i].value, effects[i].unit,
          effects[j].name, effects[j].value, effects[j].unit));
    }
  }
}

/// Lengths that drive a test and are read coarsely.
void warn_of_coarse_lengths(const ComponentProblem& problem, const ComponentFit& fit, std::size_t e,
                            std::vector<std::string>& warnings) {
  const ComponentExperiment& experiment = *problem.experiments()[e];
  const auto count = static_cast<Eigen::Index>(experiment.nuisance().size());
  const auto prediction = experiment.predict(
      fit.fit.law, fit.fit.nuisance.segment(problem.first_nuisance(e), count), false);
  const auto loop = experiment.loop(experiment.measured());
  if (!prediction || prediction->length_gain.size() == 0 || !loop) return;
  const Eigen::VectorXd counts =
      (fit.uncertainty.noise.weight[e].array() > 0).cast<double>().matrix();
  const double misfit = counts.cwiseProduct(prediction->value - experiment.measured()).norm();
  const double gain = counts.cwiseProduct(prediction->length_gain).norm();
  const auto step = coarse_step(loop->abscissa, misfit / gain);
  if (!step) return;
  warnings.push_back(fmt::format(
      "{}: lengths stand on a grid of {}, and their rounding is most of the misfit: a finer "
      "resolution tells more",
      experiment.info().name, format_quantity(*step, Dimension::length, 3)));
}

/// d prediction / d gauge length (1/m of the measured quantity) of a strip that is pulled, at fixed
/// distances of the clamps or weights; nothing where no length is stated, or it is looked for.
std::optional<Eigen::VectorXd> by_gauge_length(const ComponentExperiment& experiment,
                                               const ComponentLaw& law,
                                               const Eigen::VectorXd& nuisance) {
  const ExperimentInfo& info = experiment.info();
  if (info.test.deformation != Deformation::stretch) return std::nullopt;
  for (const NuisanceParameter& own : experiment.nuisance()) {
    if (own.name.ends_with(".rest_length_change")) return std::nullopt;
  }
  const auto prediction = experiment.predict(law, nuisance, false);
  if (!prediction) return std::nullopt;
  Eigen::VectorXd stretch(experiment.rows());
  for (Eigen::Index i = 0; i < stretch.size(); ++i) {
    stretch(i) = 1 + experiment.path().strain[static_cast<std::size_t>(i)];
  }
  if (info.measures_length()) return stretch;
  if (prediction->length_gain.size() == 0) return std::nullopt;
  return (-prediction->length_gain.array() * stretch.array()).matrix();
}

/// How much longer a strip would be than stated by a score test: one step of Gauss and Newton with
/// its length free, all else following. Nothing where that explains less than a third of what the
/// fit misses of it.
std::optional<double> better_length(const ComponentFit& fit, std::size_t e,
                                    const Eigen::VectorXd& measured, const Eigen::VectorXd& by) {
  constexpr double kShare = 1.0 / 3;
  const MeasuredNoise& noise = fit.uncertainty.noise;
  const std::vector<Eigen::Index>& free = fit.uncertainty.free;
  const Eigen::VectorXd column = noise.weight[e].cwiseProduct(by);
  const Eigen::VectorXd residual = noise.weight[e].cwiseProduct(measured - noise.rows[e].value);
  const Eigen::MatrixXd own = noise.weight[e].asDiagonal() * noise.rows[e].by(Eigen::all, free);
  const Eigen::MatrixXd scaled = own * fit.uncertainty.unit.asDiagonal();
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(scaled.cols(), scaled.cols());
  for (std::size_t p = 0; p < noise.rows.size(); ++p) {
    const Eigen::MatrixXd part = noise.weight[p].asDiagonal() * noise.rows[p].by(Eigen::all, free) *
                                 fit.uncertainty.unit.asDiagonal();
    normal += part.transpose() * part;
  }
  const Eigen::VectorXd shared = scaled.transpose() * column;
  const double left =
      column.squaredNorm() - shared.dot(normal.completeOrthogonalDecomposition().solve(shared));
  if (!(left > 1e-9 * column.squaredNorm())) return std::nullopt;
  const double score = column.dot(residual);
  if (score * score / left < kShare * residual.squaredNorm()) return std::nullopt;
  return score / left;
}

void warn_of_length(const ComponentProblem& problem, const ComponentFit& fit, std::size_t e,
                    std::vector<std::string>& warnings) {
  constexpr double kMatters = 1e-4;  // m
  const ComponentExperiment& experiment = *problem.experiments()[e];
  const auto count = static_cast<Eigen::Index>(experiment.nuisance().size());
  const auto by = by_gauge_length(experiment, fit.fit.law,
                                  fit.fit.nuisance.segment(problem.first_nuisance(e), count));
  if (!by) return;
  const auto longer = better_length(fit, e, experiment.measured(), *by);
  if (!longer || std::abs(*longer) < kMatters) return;
  warnings.push_back(fmt::format(
      "{}: the data contradict the stated gauge length: a third of the misfit or more would go "
      "with a strip that is {} {}; measure it again, or look for it "
      "(`rest_length: unknown`)",
      experiment.info().name, format_quantity(std::abs(*longer), Dimension::length, 2),
      *longer > 0 ? "longer" : "shorter"));
}

}  // namespace

std::vector<std::string> nuisance_warnings(const ComponentProblem& problem,
                                           const ComponentFit& fit) {
  std::vector<std::string> warnings;
  for (std::size_t e = 0; e < problem.experiments().size(); ++e) {
    warn_of_cancelling(problem, fit, e, warnings);
    warn_of_coarse_lengths(problem, fit, e, warnings);
    warn_of_length(problem, fit, e, warnings);
  }
  return warnings;
}

}  // namespace pliant
