#include "pliant/study/joint_study.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/stopwatch.h"
#include "pliant/estimation/component_work.h"
#include "pliant/estimation/joint_fit.h"
#include "pliant/estimation/monotone_stress.h"
#include "pliant/estimation/sampled_numbers.h"
#include "pliant/estimation/sheet/independent_rows.h"
#include "pliant/estimation/sheet/sheet_options.h"
#include "pliant/estimation/stated_options.h"
#include "pliant/estimation/statistics/model_growth.h"
#include "pliant/study/component_study.h"
#include "pliant/study/sheet_predictions.h"
#include "pliant/study/sheet_study.h"
#include "pliant/study/study_experiments.h"

namespace pliant {
namespace {

/// The unknowns and the parts of a joint fit that one component's strips have, or the sheets.
struct Share {
  std::vector<Eigen::Index> unknowns;  // ascending: laws come before nuisances
  std::vector<std::size_t> parts;
};

struct JointLayout {
  JointProblem problem;
  std::vector<Share> strips;  // of each component
  Share sheets;

  void add(std::vector<Unknown> unknowns, Share& share) {
    for (Unknown& unknown : unknowns) {
      share.unknowns.push_back(std::ssize(problem.unknowns));
      problem.unknowns.push_back(std::move(unknown));
    }
  }
  void add(const Experiment& experiment, Share& share) {
    share.parts.push_back(problem.experiments.size());
    problem.experiments.push_back(&experiment);
  }
};

/// The unknowns of a component's fit from one place to another, beginning where it has ended.
std::vector<Unknown> found_unknowns(const LawFit& fit, Eigen::Index first, Eigen::Index last) {
  std::vector<Unknown> unknowns;
  for (Eigen::Index i = first; i < last; ++i) {
    unknowns.push_back(fit.unknowns[static_cast<std::size_t>(i)]);
    unknowns.back().start = fit.solution.parameters(i);
  }
  return unknowns;
}

/// No elastic stress of a law falls, whose control values are the unknowns from `first` on.
void keep_monotone(const ComponentLaw& law, Eigen::Index first, double largest_strain,
                   JointProblem& problem) {
  const Eigen::MatrixXd tangents = elastic_tangents(law.stiffness, largest_strain);
  Eigen::MatrixXd& rows = problem.not_negative;
  const Eigen::Index above = rows.rows();
  rows.conservativeResize(above + tangents.rows(), std::ssize(problem.unknowns));
  rows.bottomRows(tangents.rows()).setZero();
  rows.block(above, first, tangents.rows(), tangents.cols()) = tangents;
}

JointLayout layout_of(const FitSettings& settings, const std::vector<ComponentWork>& works,
                      const SheetFit& sheets) {
  JointLayout layout;
  layout.problem.material = sheets.material;
  layout.problem.loss = settings.fit.loss;
  layout.strips.resize(works.size());
  const std::vector<const SheetTest*> tests = tests_of(sheets.plan);
  for (std::size_t w = 0; w < works.size(); ++w) {
    if (!works[w].problem) continue;
    const LawFit& fit = works[w].fit.fit;
    layout.add(found_unknowns(fit, 0, fit.law.parameter_count()), layout.strips[w]);
  }
  for (const ComponentGroup& group : sheets.groups) {
    std::vector<Unknown> unknowns = unknowns_of(
        sheets.material, {group}, {largest_strain(sheets, group)}, shortest_edge(*tests.front()));
    apply_options(settings.fit, unknowns);
    layout.add(std::move(unknowns), layout.sheets);
  }
  for (std::size_t w = 0; w < works.size(); ++w) {
    if (!works[w].problem) continue;
    const LawFit& fit = works[w].fit.fit;
    layout.add(found_unknowns(fit, fit.law.parameter_count(), fit.solution.parameters.size()),
               layout.strips[w]);
    for (const ComponentExperiment* strip : works[w].fitted) layout.add(*strip, layout.strips[w]);
  }
  for (const SheetTest* test : tests) {
    std::vector<Unknown> cords = cord_unknowns(*test, sheets.cords);
    apply_options(settings.fit, cords);
    layout.add(std::move(cords), layout.sheets);
    layout.add(*test, layout.sheets);
  }
  if (!settings.fit.monotone_stress) return layout;
  layout.problem.not_negative.resize(0, std::ssize(layout.problem.unknowns));
  for (std::size_t w = 0; w < works.size(); ++w) {
    if (!works[w].problem) continue;
    keep_monotone(works[w].fit.fit.law, layout.strips[w].unknowns.front(),
                  works[w].problem->largest_strain(), layout.problem);
  }
  Eigen::Index first = layout.sheets.unknowns.empty() ? 0 : layout.sheets.unknowns.front();
  for (const ComponentGroup& group : sheets.groups) {
    const ComponentLaw law = law_of(sheets.material, group);
    keep_monotone(law, first, largest_strain(sheets, group), layout.problem);
    first += law.parameter_count();
  }
  return layout;
}

/// Gives a component's fit what the joint one found of it.
void take(const JointFit& joint, const Share& share, ComponentFit& component) {
  LawFit& fit = component.fit;
  fit.solution.parameters = joint.values(share.unknowns);
  fit.solution.converged = joint.converged;
  fit.law = fit.law.with_parameters(fit.solution.parameters);
  fit.nuisance = fit.solution.parameters.tail(fit.nuisance.size());
  component.uncertainty = part_of(joint.uncertainty, share.unknowns, share.parts);
  raise_errors(component);
  // Those are of the strips alone, and profiles of everything would take long.
  component.limits.assign(component.limits.size(), std::nullopt);
}

/// Names the experiments of a component that scatter more about what everything together says than
/// about what they say alone.
/// @param alone  their noise at the component's own fit
void warn_of_misfit(const std::vector<ExperimentNoise>& alone, const ComponentWork& work,
                    StudyResult& result) {
  constexpr double kClear = 1.3;  // more than sheets of the same law ask of strips
  const std::vector<ExperimentNoise>& together = work.fit.uncertainty.noise.of;
  for (std::size_t e = 0; e < together.size(); ++e) {
    const double times = together[e].sd / alone[e].sd;
    if (times < kClear) continue;
    result.warnings.push_back(
        fmt::format("{}: fitted together with the sheets its errors are {:.2g} times those alone: "
                    "strips and sheets do not follow one law, or there is a better fit",
                    work.fitted[e]->info().name, times));
  }
}

/// Names sheets over a table whose shapes miss the measured ones all in one way, where strips tell
/// how they bend.
void warn_of_misfit(const SheetTest& test, const Eigen::VectorXd& predicted, StudyResult& result) {
  constexpr double kClear = 2;      // times the scatter of the points
  constexpr double kShare = 0.003;  // of the sample, which meshes may cost
  if (test.objective() != SheetObjective::positions) return;
  const Eigen::VectorXd missed = predicted - test.measured();
  const double rms = std::sqrt(missed.squaredNorm() / static_cast<double>(missed.size()));
  const double scatter = own_scatter(test, missed);
  if (rms < kClear * scatter || rms < kShare * test.reference()) return;
  result.warnings.push_back(fmt::format(
      "{}: fitted together with the strips its points are {:.2g} mm off, and scatter by "
      "{:.2g} mm: strips and sheets do not follow one law, or there is a better fit",
      test.name(), 1e3 * rms, 1e3 * scatter));
}

/// Gives the fit of sheets what the joint one found of it.
SheetUncertainty take(const JointFit& joint, const Share& share,
                      const std::vector<Unknown>& unknowns, SheetFit& sheets) {
  sheets.converged = sheets.converged && joint.converged;
  SheetUncertainty result;
  for (const Eigen::Index u : share.unknowns) {
    result.unknowns.push_back(unknowns[static_cast<std::size_t>(u)]);
  }
  result.values = joint.values(share.unknowns);
  result.uncertainty = part_of(joint.uncertainty, share.unknowns, share.parts);
  Eigen::Index next = 0;
  for (const ComponentGroup& group : sheets.groups) {
    next = set_numbers(result.values, next, group, sheets.material);
  }
  for (; next < result.values.size(); ++next) {
    sheets.cords[result.unknowns[static_cast<std::size_t>(next)].name] = result.values(next);
  }
  return result;
}

/// Standard errors that specimens have raised stand in the covariance of everything, too.
Eigen::MatrixXd raised_covariance(const JointFit& joint, const JointLayout& layout,
                                  const std::vector<ComponentWork>& works) {
  Eigen::VectorXd sd = joint.uncertainty.std_error;
  for (std::size_t w = 0; w < works.size(); ++w) {
    if (works[w].problem) sd(layout.strips[w].unknowns) = works[w].fit.uncertainty.std_error;
  }
  return raised_to(joint.uncertainty.covariance, sd);
}

FittedModel judged(const ComponentWork& work, const LawFit& fit) {
  const double rows = effective_rows(work.fit.uncertainty.noise.of).effective;
  return {std::sqrt(2 * fit.solution.cost / work.problem->used_rows()), free_count(fit.unknowns), 0,
          rows};
}

/// Friction that strips do not show is no burden in one dimension. Sheets would have to be followed
/// along whole paths for it, and would tell it from what they lack otherwise.
void leave_out_unseen_friction(const Study& study, std::vector<ComponentWork>& works,
                               StudyResult& result) {
  for (ComponentWork& work : works) {
    if (!work.problem || !work.fit.elastic) continue;
    if (friction_of(study.model, work.component).choice != FrictionChoice::automatic) continue;
    if (is_worth(judged(work, *work.fit.elastic), judged(work, work.fit.fit))) continue;
    work.plan.friction = FrictionLaw::none;
    work.fit = fit_component(*work.problem, work.plan);
    result.undetermined.push_back("friction of " + work.component +
                                  ": the loops of its strips are no wider than chance makes them");
  }
}

void warn_of_slip(const std::vector<ComponentWork>& works, StudyResult& result) {
  for (const ComponentWork& work : works) {
    if (!work.problem || !is_bending(work.component)) continue;
    if (work.fit.fit.law.friction_law == FrictionLaw::none) continue;
    result.assumptions.push_back(
        work.component +
        ": its friction acts in sheets through the hinges of their meshes, which "
        "slip up to a third too hard");
  }
}

std::string about_everything(const Study& study, std::size_t experiments) {
  if (!fits_strips(study)) {
    return fmt::format(
        "after the stages all {} experiments are fitted together by the loss, each weighed by its "
        "own noise; standard errors do not contain that of the mesh",
        experiments);
  }
  return fmt::format(
      "strips and sheets: {} experiments are fitted together in the end, each weighed by its own "
      "noise; the numbers have one covariance",
      experiments);
}

KnownComponents known_components(const Study& study, const std::vector<ComponentWork>& works) {
  const Material material = material_of(study, works);
  KnownComponents known;
  for (const ComponentWork& work : works) {
    if (!work.problem) continue;
    if (is_bending(work.component) && study.model.bending == "spring") {
      throw InputError({study.file, 0, "model.bending"},
                       "springs on a grid have no bending stiffness that a strip could tell, and " +
                           work.component + " is measured on strips",
                       "discrete-shells, or sheets alone");
    }
    known[work.component] = material.components.at(work.component);
  }
  return known;
}

/// Threads that rub where strips bend do so in all directions: friction of those that sheets alone
/// tell is then left to the data, where the study says nothing of it.
FitSettings with_bending_friction(FitSettings settings, const KnownComponents& known) {
  const bool rubs = std::ranges::any_of(known, [](const auto& component) {
    return is_bending(component.first) && component.second.friction;
  });
  if (!rubs) return settings;
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    if (known.contains(name)) continue;
    std::optional<FrictionModel>& friction = settings.model.components[name].friction;
    if (!friction) friction.emplace();
  }
  return settings;
}

std::vector<std::string> names_of(const KnownComponents& known) {
  std::vector<std::string> names;
  for (const auto& [name, component] : known) names.push_back(name);
  return names;
}

}  // namespace

bool fits_strips(const Study& study) {
  return std::ranges::any_of(study.experiments, [&](const ExperimentSpec& spec) {
    return !is_sheet(spec, study.model) && spec.role == ExperimentRole::fit;
  });
}

StudyResult fit_joint_study(const Study& study, const StudyFitOptions& options,
                            const RunContext& context) {
  const Stopwatch watch;
  StudyResult result = describe(study);
  refuse_foreign_options(study);
  if (study.model.samples) {
    throw InputError(study.model.samples->where,
                     "stands beside strips, of which nobody knows from where they were cut",
                     "sessions alone to fit");
  }
  if (study.model.isotropic && fits_strips(study)) {
    throw InputError({study.file, 0, "model.variant"},
                     "strips are fitted along weft and along warp, with nothing to share",
                     "nonlinear-orthotropic or linear-orthotropic, or sheets alone");
  }
  const Experiments strips = read_experiments(study, result);
  const std::vector<SheetExperiment> data = read_sheet_experiments(study, result);
  result.assumptions = assumptions_of(study, strips);
  std::ranges::move(stated_options(study.fit), std::back_inserter(result.assumptions));
  if (!fits_strips(study)) require_known_parameters(study, tests_to_fit(data));

  std::vector<ComponentWork> works =
      fit_components(settings_of(study), strips, options, context, result);
  leave_out_unseen_friction(study, works, result);
  const KnownComponents known = known_components(study, works);
  const FitSettings settings = with_bending_friction(settings_of(study), known);
  const std::vector<SheetStage> plan = sheet_plan(settings, tests_to_fit(data), names_of(known));
  SheetFit sheets = fit_sheets(settings, plan, context, nullptr, known);
  std::erase_if(sheets.groups,
                [&](const ComponentGroup& group) { return known.contains(group.front()); });

  const JointLayout layout = layout_of(study, works, sheets);
  const JointFit joint = fit_jointly(layout.problem, context);
  for (std::size_t w = 0; w < works.size(); ++w) {
    if (!works[w].problem) continue;
    const std::vector<ExperimentNoise> alone = works[w].fit.uncertainty.noise.of;
    take(joint, layout.strips[w], works[w].fit);
    warn_of_misfit(alone, works[w], result);
  }
  for (const std::size_t part : layout.sheets.parts) {
    if (!fits_strips(study)) break;
    warn_of_misfit(dynamic_cast<const SheetTest&>(*layout.problem.experiments[part]),
                   joint.uncertainty.noise.rows[part].value, result);
  }
  const SheetUncertainty uncertainty = take(joint, layout.sheets, layout.problem.unknowns, sheets);
  set_status(study, sheets);
  for (const auto& [name, component] : known_components(study, works)) {
    sheets.material.components[name] = component;
  }
  if (sheets.material.density == 0) sheets.material.density = stated_density(data);
  EquilibriumWork work = sheets.work;
  work += joint.work;
  std::vector<ExperimentResult> predictions =
      sheet_predictions(data, sheets.material, sheets.cords, context, work);
  for (const ComponentWork& component : works) {
    if (component.problem) add_component(component, result);
  }
  add_sheets(sheets, uncertainty, data, std::move(predictions), result);
  for (const ComponentWork& component : works) {
    if (component.problem) add_figures(component, result.material, result);
  }
  warn_of_unmatched_options(study.fit, result);
  result.stages.push_back({"all", "together", "times the noise", joint.rms, true});
  add_starts({"all", "together", "times the noise", {joint.rms}, 1}, result);
  result.assumptions.push_back(about_everything(study, layout.problem.experiments.size()));
  if (!result.profiles.empty() || !result.models.empty()) {
    result.assumptions.emplace_back(
        "profiles and rankings of models are those of each component's strips alone");
  }
  warn_of_slip(works, result);
  result.covariance = raised_covariance(joint, layout, works);
  result.work = work;
  result.seconds = watch.seconds();
  return result;
}

}  // namespace pliant
