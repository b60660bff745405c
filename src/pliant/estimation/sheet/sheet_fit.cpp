#include "pliant/estimation/sheet/sheet_fit.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/sheet/curve_growth.h"
#include "pliant/estimation/sheet/friction_stage.h"
#include "pliant/estimation/sheet/limit_stage.h"
#include "pliant/estimation/sheet/sample_stage.h"
#include "pliant/estimation/sheet/sheet_fitting.h"
#include "pliant/experiment/session/lost_frames.h"
#include "pliant/material/addend/rubber_addends.h"

namespace pliant {
namespace {

class Fitter {
 public:
  Fitter(const FitSettings& settings, std::vector<SheetStage> plan, const RunContext& context,
         const Material* start, const KnownComponents& known)
      : fitting_(settings, std::move(plan), context, start, known) {}

  SheetFit run() && {
    ProgressTask task(fitting_.context().progress, "fit", static_cast<double>(fit().plan.size()));
    const std::size_t planned = fit().plan.size();
    for (std::size_t s = 0; s < fit().plan.size();) {
      fitting_.context().stop.throw_if_requested();
      leave_out_lost_frames(fit().plan[s]);
      if (has_ended_well(s)) ++s;
      task.advance(static_cast<double>(planned - fit().plan.size() + s));
    }
    for (const ComponentGroup& group : fit().groups) {
      const std::string missing =
          missing_addends(fitting_.settings(), group, law_of(fit().material, group));
      if (!missing.empty()) fit().warnings.push_back(missing);
    }
    fit().work = fitting_.search().work();
    return std::move(fit());
  }

 private:
  /// Runs a stage; one whose sheets lose their equilibria is taken off the plan, so that what the
  /// others find is kept.
  /// @throws SolverError where no other would be left
  bool has_ended_well(std::size_t place) {
    const SheetFitting::State before = fitting_.state();
    try {
      place_gaussians(fit().plan[place]);
      run_stage(fit().plan[place]);
      return true;
    } catch (const SolverError& error) {
      const SheetStage stage = fit().plan[place];
      fit().plan.erase(fit().plan.begin() + static_cast<std::ptrdiff_t>(place));
      std::erase_if(fit().plan, [&](const SheetStage& other) {
        return other.kind == StageKind::friction && !has_stiffness_stage(other.groups.front());
      });
      fit().groups = groups_of(fit().plan);
      if (fit().groups.empty()) throw;
      fitting_.restore(before);
      fit().converged = false;
      fit().warnings.push_back(fmt::format("{} is not fitted to {}: {}", names_of(stage.groups),
                                           names_of(stage.tests), error.what()));
      return false;
    }
  }

  bool has_stiffness_stage(const ComponentGroup& group) {
    return std::ranges::any_of(fit().plan, [&](const SheetStage& stage) {
      return stage.kind != StageKind::friction &&
             std::ranges::find(stage.groups, group) != stage.groups.end();
    });
  }

  void run_stage(const SheetStage& stage) {
    if (stage.kind == StageKind::hold) return;
    if (stage.kind == StageKind::friction)
      return fit_friction(fitting_, stage, stage.groups.front());
    if (stage.kind == StageKind::limit) return fit_limits(fitting_, stage);
    if (stage.kind == StageKind::sample) return fit_samples(fitting_, stage);
    for (const ComponentGroup& group : stage.groups) {
      if (!fitting_.is_fitted(group)) guess(stage, group);
    }
    double rms = fitting_.solve(stage);
    // Without a test of its own shear follows stretch.
    if (is_stretch(stage.groups.front()) && guess_shear()) rms = fitting_.solve(stage);
    fitting_.record(stage, rms, true);
    if (stage.kind == StageKind::grow) grow(fitting_, stage, stage.groups.front(), rms);
    for (const ComponentGroup& group : stage.groups) fitting_.mark_fitted(group);
  }

  /// Frames between clips that have no equilibrium, as one with a wrong pose, would end the search.
  /// Over a table no pose is wrong, and the first guess of the stiffness says little.
  void leave_out_lost_frames(const SheetStage& planned) {
    SheetStage stage = planned;
    std::erase_if(stage.tests, [&](const SheetTest* test) {
      return test->session().table || !examined_.insert(test->name()).second;
    });
    if (stage.tests.empty()) return;
    SheetProblem problem(stage.tests, fit().material, stage.groups, usual_strains(stage),
                         fitting_.context());
    const std::vector<std::vector<int>> lost = fitting_.search().lost_frames(stage, problem);
    for (std::size_t t = 0; t < lost.size(); ++t) {
      const SheetTest& test = *stage.tests[t];
      const auto count = static_cast<double>(lost[t].size());
      if (count == 0 || count > kLostShare * test.frame_count()) continue;
      fit().warnings.push_back(fmt::format(
          "{}: no equilibrium is found of frame{} {} (of {}), left out of the fit", test.name(),
          count == 1 ? "" : "s", fmt::join(lost[t], ", "), test.frame_count()));
      replace(test, std::make_shared<SheetTest>(test.without(lost[t])));
    }
  }

  /// Terms of two strains at several places, where the model asks for them, over the strains that
  /// the sheets have without them.
  void place_gaussians(const SheetStage& stage) {
    const std::vector<ComponentGroup> groups = stage.groups;
    for (const ComponentGroup& group : groups) {
      const int count = model_of(fitting_.settings(), group).gaussians;
      if (count == 0) continue;
      const auto [first, second] = strains_of_sheet_pair(group.front());
      SheetProblem problem = fitting_.problem_of(stage);
      const std::array<double, 2> strains{
          fitting_.search().largest_strain(stage, problem, {first}),
          fitting_.search().largest_strain(stage, problem, {second})};
      fit().material.components.erase(group.front());
      std::vector<ComponentGroup> terms;
      for (const std::string& name : sheet_gaussians(group.front(), count, strains)) {
        set_law(fit().material.components[name], first_pair_law({&linear_addend()}));
        terms.push_back({name});
      }
      replace(group, terms);
    }
  }

  void replace(const ComponentGroup& group, const std::vector<ComponentGroup>& by) {
    for (SheetStage& stage : fit().plan) {
      const auto place = std::ranges::find(stage.groups, group);
      if (place == stage.groups.end()) continue;
      const auto next = stage.groups.erase(place);
      stage.groups.insert(next, by.begin(), by.end());
    }
    fit().groups = groups_of(fit().plan);
  }

  void replace(const SheetTest& test, std::shared_ptr<const SheetTest> by) {
    for (SheetStage& stage : fit().plan) {
      std::ranges::replace(stage.tests, &test, by.get());
    }
    fit().thinned.push_back(std::move(by));
  }

  static bool is_stretch(const ComponentGroup& group) {
    return group.front() == "stretch.weft" || group.front() == "stretch.warp";
  }

  /// Where the strains of a stage are not known yet, nor needed.
  static std::vector<double> usual_strains(const SheetStage& stage) {
    return std::vector<double>(stage.groups.size(), kUsualStrain);
  }

  /// One stiffness to begin with. Forces tell it at once; how far a sheet hangs is tried from stiff
  /// to soft.
  void guess(const SheetStage& stage, const ComponentGroup& group) {
    if (fitting_.is_fixed(group) || !is_bending(group.front())) return;
    fitting_.begin_at_best(stage, fitting_.going_along({group}).front(), "stiffness",
                           first_bending(fit().material, group), {.patience = 2});
  }

  /// Without a test of shear the sheet has a fifth of its stretch stiffness.
  bool guess_shear() {
    const auto stretched = std::ranges::find_if(
        fit().groups, [](const ComponentGroup& group) { return is_stretch(group); });
    if (stretched == fit().groups.end() || fitting_.is_fitted({"shear"}) ||
        fitting_.is_fixed({"shear"}))
      return false;
    const double stretch = law_of(fit().material, *stretched).elastic_secant(0);
    fit().material.components.at("shear").stiffness =
        ScalarCurve::hermite({0.0}, {0.2 * stretch}, true);
    return true;
  }

  SheetFit& fit() { return fitting_.fit(); }

  SheetFitting fitting_;
  std::set<std::string> examined_;  // tests whose lost frames are left out
};

}  // namespace

double largest_strain(const SheetFit& fit, const ComponentGroup& group) {
  const auto known = fit.strains.find(group.front());
  return known == fit.strains.end() ? kUsualStrain : known->second;
}

SheetFit fit_sheets(const FitSettings& settings, std::vector<SheetStage> plan,
                    const RunContext& context, const Material* start,
                    const KnownComponents& known) {
  return Fitter(settings, std::move(plan), context, start, known).run();
}

}  // namespace pliant
