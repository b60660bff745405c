#include "pliant/estimation/solid/solid_fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/mesh_error.h"
#include "pliant/estimation/sampled_numbers.h"
#include "pliant/estimation/solid/energy_growth.h"
#include "pliant/estimation/solid/limit_starts.h"
#include "pliant/estimation/solid/sample_growth.h"
#include "pliant/estimation/solid/solid_growth.h"
#include "pliant/estimation/solid/solid_plan.h"
#include "pliant/estimation/solid/solid_starts.h"
#include "pliant/estimation/solid/true_stress.h"
#include "pliant/estimation/statistics/model_growth.h"
#include "pliant/material/material_samples.h"

namespace pliant {
namespace {

constexpr LeastSquaresOptions kFirst{
    .max_iterations = 60, .function_tolerance = 1e-6, .parameter_tolerance = 1e-6};

struct Start {
  Material material;
  LeastSquaresSummary solution;
  std::vector<FitStage> stages = {};  ///< of the study's plan
};

/// Which row has no equilibrium, with which numbers of the material.
std::string what_is_lost(SolidProblem& problem, const Material& start) {
  const Problem own = problem.problem(start);
  std::string numbers;
  for (const Unknown& unknown : own.unknowns()) {
    numbers +=
        fmt::format("{}{} = {:.3g}", numbers.empty() ? "" : ", ", unknown.name, unknown.start);
    if (!unknown.unit.empty()) numbers += " " + unknown.unit;
  }
  for (const ProblemPart& part : own.parts()) {
    const Workers workers{problem.context().threads, problem.context().stop};
    const std::vector<int> lost = part.predictor->lost_frames(part.predictor->values(), workers);
    if (lost.empty()) continue;
    const Frame frame = part.experiment->frames()[static_cast<std::size_t>(lost.front())];
    return fmt::format("the equilibrium of {}, rows {} to {} of {}, at {} or another start",
                       part.experiment->info().name, frame.first + 1, frame.first + frame.count,
                       part.experiment->rows(), numbers);
  }
  return "the prediction of the solid's experiments at " + numbers;
}

/// Follows all starts by the plan and a way further, and the best to its end.
Start search(const FitSettings& settings, SolidProblem& problem, std::vector<Material> starts,
             SolidFit& fit) {
  std::vector<Start> ends(starts.size());
  const bool one = starts.size() == 1;
  const StartSearch search = search_from(starts.size(), [&](std::size_t s, double least) {
    ends[s].material = std::move(starts[s]);
    ends[s].stages =
        follow_plan(settings, problem.experiments(), problem.context(), ends[s].material);
    LeastSquaresOptions options = one ? LeastSquaresOptions{} : kFirst;
    if (std::isfinite(least)) {
      options.hopeless_cost = 30 * least;
      options.patience = 15;
    }
    ends[s].solution = problem.solve(ends[s].material, options);
    return ends[s].solution.cost;
  });
  if (!search.found()) {
    throw SolverError(what_is_lost(problem, ends.front().material), 0, 0);
  }
  fit.starts = {"solid", "law", kDifferenceUnit, {}, search.reached_best};
  for (const double cost : search.costs) {
    fit.starts.ends.push_back(std::sqrt(2 * cost / std::max(problem.rows(), 1)));
  }
  Start best = std::move(ends[search.best]);
  if (!one) best.solution = problem.solve(best.material);
  std::ranges::move(best.stages, std::back_inserter(fit.stages));
  return best;
}

/// An experiment that no number of the material changes tells nothing.
void refuse_unseen(const FitSettings& settings, const Problem& problem) {
  if (free_count(problem.unknowns()) == 0) return;  // limits alone are looked for
  for (std::size_t p = 0; p < problem.parts().size(); ++p) {
    const auto rows = problem.predict(p, starts_of(problem.unknowns()), /*derivatives=*/true);
    if (!rows || rows->by.cwiseAbs().maxCoeff() > 0) continue;
    const std::string& name = problem.parts()[p].experiment->info().name;
    throw InputError({settings.file, 0, "experiments"},
                     quoted_value(name) +
                         " shows nothing of the material: no number of its "
                         "components changes the stress there",
                     "a model with components that this test strains");
  }
}

/// What convexity in two strains has to do with the fitted numbers.
void tell_convexity(const FitSettings& settings, SolidProblem& problem, SolidFit& fit) {
  const bool free = settings.fit.convexity == Convexity::free;
  const double touching = free ? -1e-5 : 1e-5;  // of the largest second derivative
  for (const auto& [pair, domain] : problem.pair_domains(fit.material)) {
    const double least = least_convexity(fit.material, domain);
    if (least > touching) continue;
    fit.notes.push_back(
        free
            ? fmt::format("the energy is not convex in {} over what the data show", pair)
            : fmt::format("convexity in {} holds back what the data would have: numbers lie at its "
                          "limit, which their errors do not know",
                          pair));
  }
}

/// @param what  has grown, in the singular
void append_stages(const std::vector<SolidGrowthStage>& stages, const char* what, SolidFit& fit) {
  for (const SolidGrowthStage& stage : stages) {
    fit.stages.push_back({"solid",
                          fmt::format("{} {}{}", stage.size, what, stage.size == 1 ? "" : "s"),
                          kDifferenceUnit, stage.rms, stage.accepted,
                          std::string(stage.end ? name_of(*stage.end) : "")});
  }
}

/// Gives the fitted solid samples and lets these differ.
void add_samples(const SampleOptions& options, const MaterialSamples& samples,
                 SolidProblem& problem, GrownSolid& grown, SolidFit& fit) {
  Material& material = grown.material;
  const double before = rms_of(grown.solution, problem.rows());
  const auto count_before = static_cast<int>(grown.solution.parameters.size());
  material.samples = samples;
  for (SampledComponents& sample : material.samples.at) {
    for (const auto& [name, component] : material.components) {
      if (options.differ_in(name)) sample.components[name] = component;
    }
  }
  grown.solution = problem.solve(material);
  const double rms = rms_of(grown.solution, problem.rows());
  fit.stages.push_back({"solid", fmt::format("{} samples", samples.at.size()), kDifferenceUnit, rms,
                        /*accepted=*/true});
  const FittedModel simple{before, count_before, 0, static_cast<double>(problem.rows())};
  FittedModel rich = simple;
  rich.rms = rms;
  rich.parameters = static_cast<int>(grown.solution.parameters.size());
  if (is_worth(simple, rich)) return;
  fit.notes.emplace_back(kNoSamples);
}

/// Lets a fitted solid grow samples.
void grow_samples(const SampleOptions& options, const MaterialSamples& choices,
                  SolidProblem& problem, GrownSolid& grown, SolidFit& fit) {
  GrownSolid sampled = with_samples(problem, options, choices, grown);
  append_stages(sampled.stages, "sample", fit);
  if (!is_heterogeneous(sampled.material)) fit.notes.emplace_back(kNoSamples);
  grown = std::move(sampled);
}

/// Weights of a robust loss and numbers depend on each other.
void settle_loss(const FitSettings& settings, int rounds, SolidProblem& problem, Material& material,
                 LeastSquaresSummary& solution) {
  constexpr double kSettled = 1e-3;
  if (settings.fit.loss == RobustLoss::none) return;
  for (int round = 0; round < rounds && problem.count_by_loss(material) > kSettled; ++round) {
    solution = problem.solve(material);
  }
}

/// Elements of first order err with the square of their size: of the whole error three quarters go
/// where it is halved.
void add_mesh_error(const Problem& problem, const std::vector<const Experiment*>& finer,
                    const Material& material, const RunContext& context, SolidFit& fit) {
  constexpr double kOfHalvedSize = 4.0 / 3;
  std::vector<ProblemPart> parts;
  for (std::size_t p = 0; p < finer.size(); ++p) {
    parts.push_back({finer[p], finer[p]->predictor(material)});
    parts.back().unit = problem.parts()[p].unit;
  }
  const Problem other(std::move(parts), problem.unknowns(), {context.threads, context.stop});
  const Eigen::VectorXd moved = moved_on(other, fit.uncertainty.noise.weight, problem, fit.values,
                                         fit.uncertainty, /*told=*/{});
  if (moved.size() == 0) return;
  fit.mesh_error = kOfHalvedSize * moved;
  add_systematic(fit.mesh_error, fit.unknowns, fit.values, fit.uncertainty);
}

}  // namespace

SolidFit fit_solid(const FitSettings& settings,
                   const std::map<std::string, ComponentModel>& components,
                   const MaterialSamples& samples,
                   const std::vector<const Experiment*>& experiments,
                   const std::vector<const Experiment*>& finer, const RunContext& context) {
  SolidFit fit;
  SolidProblem problem(settings, experiments, context);
  std::vector<Material> starts = solid_starts(settings, components, problem);
  refuse_unseen(settings, problem.problem(starts.front()));
  const Material first = starts.front();
  Start best = search(settings, problem, std::move(starts), fit);
  best.solution = add_limits(problem, settings.model.limits, first, best.material, best.solution);
  settle_loss(settings, /*rounds=*/1, problem, best.material, best.solution);
  GrownSolid grown = grow_splines(problem, {best.material, best.solution, {}});
  grown = grow_energies(problem, grown);
  append_stages(grown.stages, "control point", fit);
  if (grown.stages.empty()) {
    fit.stages.push_back({"solid", "law", kDifferenceUnit, rms_of(grown.solution, problem.rows()),
                          /*accepted=*/true});
  }
  if (!samples.at.empty()) {
    const SampleOptions& options = *settings.model.samples;
    (options.grown > 0 ? grow_samples : add_samples)(options, samples, problem, grown, fit);
  }
  settle_loss(settings, /*rounds=*/30, problem, grown.material, grown.solution);
  const Problem own = problem.problem(grown.material);
  fit.unknowns = own.unknowns();
  fit.values = grown.solution.parameters;
  fit.converged = grown.solution.converged;
  fit.iterations = grown.solution.iterations;
  fit.rms = rms_of(grown.solution, problem.rows());
  fit.uncertainty = uncertainty_of(own, fit.values);
  if (!finer.empty()) add_mesh_error(own, finer, grown.material, context, fit);
  for (auto& [name, component] : grown.material.components) {
    const MetricData& data = problem.data_of(name);
    component.range = {std::min(data.low(), 0.0), data.high()};
    for (SampledComponents& sample : grown.material.samples.at) {
      const auto of_sample = sample.components.find(name);
      if (of_sample != sample.components.end()) of_sample->second.range = component.range;
    }
  }
  fit.material = std::move(grown.material);
  tell_convexity(settings, problem, fit);
  fit.questions = true_stress_questions(settings, fit.material, experiments, context);
  return fit;
}

}  // namespace pliant
