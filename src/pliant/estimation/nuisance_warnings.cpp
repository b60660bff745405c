#include "pliant/estimation/nuisance_warnings.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

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

}  // namespace

std::vector<std::string> nuisance_warnings(const ComponentProblem& problem,
                                           const ComponentFit& fit) {
  std::vector<std::string> warnings;
  for (std::size_t e = 0; e < problem.experiments().size(); ++e) {
    warn_of_cancelling(problem, fit, e, warnings);
    warn_of_coarse_lengths(problem, fit, e, warnings);
  }
  return warnings;
}

}  // namespace pliant
