#include "pliant/study/component_study.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "pliant/base/name_pattern.h"
#include "pliant/base/parallel.h"
#include "pliant/estimation/apparatus_shares.h"
#include "pliant/estimation/fit_journal.h"
#include "pliant/estimation/friction_comparison.h"
#include "pliant/estimation/gauge_length_check.h"
#include "pliant/estimation/law_comparison.h"
#include "pliant/estimation/profile_likelihood.h"

namespace pliant {
namespace {

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

void fit_one(ComponentWork& work, const StudyFitOptions& options, const RunContext& context,
             int threads) {
  if (work.fitted.empty()) return;
  work.problem.emplace(work.fitted, context.stop, work.plan.fit.loss,
                       context.journal.part(work.component), threads);
  work.fit = fit_component(*work.problem, work.plan);
  if (options.compare_friction && work.plan.friction != FrictionLaw::none) {
    work.models = compare_friction(*work.problem, work.fit, work.plan);
  }
  if (work.plan.fit.estimator == EstimatorKind::anchor) return;
  work.apparatus = apparatus_shares(*work.problem, work.fit);
  work.lengths = gauge_length_warnings(*work.problem, work.fit);
  if (options.compare_laws) work.models = compare_laws(*work.problem, work.fit, work.plan);
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

// Components are fitted side by side; what threads they leave over, their experiments use.
int threads_of_each(size_t components, int threads) {
  return std::max(threads / static_cast<int>(std::max<size_t>(components, 1)), 1);
}

}  // namespace

std::vector<ComponentWork> fit_components(const FitSettings& settings,
                                          const Experiments& experiments,
                                          const StudyFitOptions& options, const RunContext& context,
                                          StudyResult& result) {
  std::vector<ComponentWork> works = group_by_component(experiments);
  const int threads = threads_of_each(works.size(), context.threads);
  for (const auto& experiment : experiments) experiment->set_threads(threads);
  std::string data;
  for (const auto& experiment : experiments) data += digest_of(*experiment);
  begin_fit(context.journal, settings, data);
  for (ComponentWork& work : works) {
    if (work.fitted.empty()) {
      result.warnings.push_back(work.component + " has validation experiments alone: not fitted");
    } else {
      work.plan = plan_component(settings, work.fitted, result.undetermined);
    }
  }
  std::atomic<int> done = 0;
  ProgressTask task(context.progress, "fit", static_cast<double>(works.size()));
  std::mutex reporting;
  parallel_for(static_cast<int>(works.size()), context.threads, [&](int i) {
    fit_one(works[static_cast<size_t>(i)], options, context, threads);
    const std::lock_guard lock(reporting);
    task.advance(++done);
  });
  return works;
}

}  // namespace pliant
