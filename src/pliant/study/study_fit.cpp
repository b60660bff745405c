#include "pliant/study/study_fit.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/name_pattern.h"
#include "pliant/base/parallel.h"
#include "pliant/base/stopwatch.h"
#include "pliant/estimation/component_work.h"
#include "pliant/estimation/friction_comparison.h"
#include "pliant/estimation/profile_likelihood.h"
#include "pliant/estimation/stated_options.h"
#include "pliant/experiment/registry.h"
#include "pliant/study/sheet_study.h"
#include "pliant/study/study_experiments.h"

namespace pliant {
namespace {

// Types whose experiments tell one component.
std::vector<std::string_view> names_of_table_tests() {
  std::vector<std::string_view> names;
  for (const TestType* type : test_types()) {
    if (!type->facts.measures_sheets) names.push_back(type->name);
  }
  return names;
}

std::vector<ComponentWork> group_by_component(const Experiments& experiments) {
  std::vector<ComponentWork> works;
  for (const auto& experiment : experiments) {
    const ExperimentInfo& info = experiment->info();
    auto work = std::find_if(works.begin(), works.end(),
                             [&](const ComponentWork& w) { return w.component == info.component; });
    if (work == works.end()) {
      works.emplace_back();
      work = works.end() - 1;
      work->component = info.component;
    }
    (info.role == ExperimentRole::fit ? work->fitted : work->validated).push_back(experiment.get());
  }
  return works;
}

void fit_one(ComponentWork& work, const StudyFitOptions& options, const StopToken& stop) {
  if (work.fitted.empty()) return;
  work.problem.emplace(work.fitted, stop);
  work.fit = fit_component(*work.problem, work.plan);
  if (options.compare_friction && work.plan.friction != FrictionLaw::none) {
    work.models = compare_friction(*work.problem, work.fit, work.plan);
  }
  if (work.plan.fit.estimator == EstimatorKind::anchor) return;
  const std::vector<Unknown>& unknowns = work.fit.fit.unknowns;
  for (size_t i = 0; i < unknowns.size(); ++i) {
    const bool wanted =
        std::any_of(options.profiles.begin(), options.profiles.end(),
                    [&](const std::string& pattern) { return matches(pattern, unknowns[i].name); });
    if (!wanted || unknowns[i].fixed) continue;
    work.profiles.push_back(
        profile_likelihood(*work.problem, work.fit, static_cast<Eigen::Index>(i)));
  }
}

void warn_of_unknown_profiles(const StudyFitOptions& options, StudyResult& result) {
  for (const std::string& pattern : options.profiles) {
    const bool known =
        std::any_of(result.profiles.begin(), result.profiles.end(),
                    [&](const Profile& profile) { return matches(pattern, profile.parameter); });
    if (!known)
      result.warnings.push_back("no free parameter is called " + pattern + ": no profile");
  }
}

// Components are fitted side by side; what threads they leave over, their experiments use.
void share_threads(const Experiments& experiments, size_t components, int threads) {
  const int each = std::max(threads / static_cast<int>(std::max<size_t>(components, 1)), 1);
  for (const auto& experiment : experiments) experiment->set_threads(each);
}

}  // namespace

StudyResult fit_study(const Study& study, const StudyFitOptions& options,
                      const RunContext& context) {
  if (fits_sheets(study)) return fit_sheet_study(study, context);
  if (study.model.isotropic) {
    throw InputError({study.file, 0, "model.variant"},
                     "components are fitted one by one: weft and warp have nothing to share",
                     "nonlinear-orthotropic or linear-orthotropic, or sessions to fit");
  }
  const Stopwatch watch;
  StudyResult result = describe(study);
  const Experiments experiments = read_experiments(study, result);
  std::vector<ComponentWork> works = group_by_component(experiments);
  const bool anything = std::any_of(works.begin(), works.end(),
                                    [](const ComponentWork& w) { return !w.fitted.empty(); });
  if (!anything) {
    throw InputError({study.file, 0, "experiments"}, "no experiment that this version can fit",
                     fmt::format("at least one of {} that is not under `validate`",
                                 fmt::join(names_of_table_tests(), ", ")));
  }
  result.assumptions = assumptions_of(study, experiments);
  const std::vector<std::string> stated = stated_options(study.fit);
  result.assumptions.insert(result.assumptions.end(), stated.begin(), stated.end());
  share_threads(experiments, works.size(), context.threads);
  for (ComponentWork& work : works) {
    if (work.fitted.empty()) {
      result.warnings.push_back(work.component + " has validation experiments alone: not fitted");
    } else {
      work.plan = plan_component(study, work.fitted, result.undetermined);
    }
  }

  std::atomic<int> done = 0;
  {
    ProgressTask task(context.progress, "fit", static_cast<double>(works.size()));
    std::mutex reporting;
    parallel_for(static_cast<int>(works.size()), context.threads, [&](int i) {
      fit_one(works[static_cast<size_t>(i)], options, context.stop);
      const std::lock_guard lock(reporting);
      task.advance(++done);
    });
  }

  for (const ComponentWork& work : works) {
    if (work.problem) add_component(work, result);
  }
  warn_of_unknown_profiles(options, result);
  result.covariance = joint_covariance(works);
  result.material = material_of(study, works);
  result.seconds = watch.seconds();
  return result;
}

}  // namespace pliant
