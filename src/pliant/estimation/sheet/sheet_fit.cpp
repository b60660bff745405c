#include "pliant/estimation/sheet/sheet_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/sheet/sheet_journal.h"
#include "pliant/estimation/sheet/sheet_options.h"
#include "pliant/estimation/sheet/sheet_problem.h"
#include "pliant/estimation/sheet/stage_search.h"
#include "pliant/estimation/statistics/model_growth.h"
#include "pliant/experiment/session/lost_frames.h"
#include "pliant/material/addend/rubber_addends.h"

namespace pliant {
namespace {

constexpr double kClearFall = 0.5;  // of the residual, that a curve cannot make up for

class Fitter {
 public:
  Fitter(const FitSettings& settings, std::vector<SheetStage> plan, const RunContext& context,
         const Material* start, const KnownComponents& known)
      : settings_(settings),
        context_(context),
        search_(context, begin_journal(context.journal, settings, plan, start)) {
    fit_.material = first_sheet_material(settings, known);
    for (const auto& [component, law] : known) known_.insert(component);
    fit_.groups = groups_of(plan);
    fit_.plan = std::move(plan);
    if (start) {
      fit_.material.components = start->components;
      fitted_ = fit_.groups;
    }
  }

  SheetFit run() && {
    ProgressTask task(context_.progress, "fit", static_cast<double>(fit_.plan.size()));
    for (std::size_t s = 0; s < fit_.plan.size(); ++s) {
      context_.stop.throw_if_requested();
      leave_out_lost_frames(fit_.plan[s]);
      place_gaussians(fit_.plan[s]);
      run_stage(fit_.plan[s]);
      task.advance(static_cast<double>(s + 1));
    }
    for (const ComponentGroup& group : fit_.groups) {
      const std::string missing = missing_addends(settings_, group, law_of(fit_.material, group));
      if (!missing.empty()) fit_.warnings.push_back(missing);
    }
    fit_.work = search_.work();
    return std::move(fit_);
  }

 private:
  void run_stage(const SheetStage& stage) {
    if (stage.kind == StageKind::hold) return;
    if (stage.kind == StageKind::friction) return fit_friction(stage, stage.groups.front());
    if (stage.kind == StageKind::limit) return fit_limits(stage);
    for (const ComponentGroup& group : stage.groups) {
      if (!is_fitted(group)) guess(stage, group);
    }
    double rms = solve(stage);
    // Without a test of its own shear follows stretch.
    if (is_stretch(stage.groups.front()) && guess_shear()) rms = solve(stage);
    record(stage, rms, true);
    if (stage.kind == StageKind::grow) grow(stage, stage.groups.front(), rms);
    for (const ComponentGroup& group : stage.groups) {
      if (!is_fitted(group)) fitted_.push_back(group);
    }
  }

  /// Frames between clips that have no equilibrium, as one with a wrong pose, would end the search.
  /// Over a table no pose is wrong, and the first guess of the stiffness says little.
  void leave_out_lost_frames(const SheetStage& planned) {
    SheetStage stage = planned;
    std::erase_if(stage.tests, [&](const SheetTest* test) {
      return test->session().table || !examined_.insert(test->name()).second;
    });
    if (stage.tests.empty()) return;
    SheetProblem problem(stage.tests, fit_.material, stage.groups, usual_strains(stage), context_);
    const std::vector<std::vector<int>> lost = search_.lost_frames(stage, problem);
    for (std::size_t t = 0; t < lost.size(); ++t) {
      const SheetTest& test = *stage.tests[t];
      const auto count = static_cast<double>(lost[t].size());
      if (count == 0 || count > kLostShare * test.frame_count()) continue;
      fit_.warnings.push_back(fmt::format(
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
      const int count = model_of(settings_, group).gaussians;
      if (count == 0) continue;
      const auto [first, second] = strains_of_sheet_pair(group.front());
      SheetProblem problem = problem_of(stage);
      const std::array<double, 2> strains{search_.largest_strain(stage, problem, {first}),
                                          search_.largest_strain(stage, problem, {second})};
      fit_.material.components.erase(group.front());
      std::vector<ComponentGroup> terms;
      for (const std::string& name : sheet_gaussians(group.front(), count, strains)) {
        set_law(fit_.material.components[name], first_pair_law({&linear_addend()}));
        terms.push_back({name});
      }
      replace(group, terms);
    }
  }

  void replace(const ComponentGroup& group, const std::vector<ComponentGroup>& by) {
    for (SheetStage& stage : fit_.plan) {
      const auto place = std::ranges::find(stage.groups, group);
      if (place == stage.groups.end()) continue;
      const auto next = stage.groups.erase(place);
      stage.groups.insert(next, by.begin(), by.end());
    }
    fit_.groups = groups_of(fit_.plan);
  }

  void replace(const SheetTest& test, std::shared_ptr<const SheetTest> by) {
    for (SheetStage& stage : fit_.plan) {
      std::ranges::replace(stage.tests, &test, by.get());
    }
    fit_.thinned.push_back(std::move(by));
  }

  /// Limits of energies ([T] 4.2.5), each fitted together with the curves; what fits best is kept.
  /// @throws SolverError where no limit lets the sheets be predicted
  void fit_limits(const SheetStage& stage) {
    // A curve without a limit has become stiff in place of one.
    constexpr std::array kSofter{1.0, 0.3, 0.1};
    for (const std::vector<std::string>& components : settings_.model.limits) {
      const State without = state();
      State best;
      StartRecord record{limit_name(components), "limit", unit_of(stage), {}, 0};
      const auto follow = [&](std::size_t start, double least) {
        restore(without);
        const bool begun = begin_at_limit(stage, components, kSofter[start]);
        const double rms = (begun ? solved(stage) : std::nullopt).value_or(INFINITY);
        record.ends.push_back(in_unit(stage, rms));
        if (rms < least) best = state();
        return rms;
      };
      const StartSearch starts = search_from(kSofter.size(), follow);
      if (!starts.found()) throw SolverError("the limit " + limit_name(components), 0, 0);
      record.reached_best = starts.reached_best;
      fit_.starts.push_back(std::move(record));
      restore(best);
      this->record(stage, starts.costs[starts.best], true);
    }
  }

  /// Gives components a limit of the share of the largest energy that the sheets reach without it
  /// from which the differences are least.
  /// @param softer  than now, the components
  /// @return false where the sheets have no equilibria with any
  bool begin_at_limit(const SheetStage& stage, const std::vector<std::string>& components,
                      double softer) {
    constexpr std::array kShares{1.1, 0.8, 0.6, 0.4, 0.2};  // of the first the data tell nothing
    SheetProblem problem = problem_of(stage);
    const double most = softer * search_.largest_energy(stage, problem, fit_.material, components);
    for (const std::string& component : components) {
      MaterialComponent& own = fit_.material.components.at(component);
      own = scaled(own, softer);
    }
    fit_.material.limits.push_back({components, most});
    const auto begin = [&](std::size_t start, double least) {
      fit_.material.limits.back().energy = kShares[start] * most;
      SheetProblem trial = problem_of(stage);
      return search_.at_start(stage, trial, least).cost;
    };
    const StartSearch starts = search_from(kShares.size(), begin);
    fit_.material.limits.back().energy = kShares[starts.best] * most;
    return starts.found();
  }

  /// As `solve`; nothing where the search begins without equilibria.
  std::optional<double> solved(const SheetStage& stage) {
    try {
      return solve(stage);
    } catch (const SolverError&) {
      return std::nullopt;
    }
  }

  /// Friction, where the loops of a stage are not those of its cords. Now that something makes the
  /// loops, the curve gets the control points that it is worth.
  void fit_friction(const SheetStage& stage, const ComponentGroup& group) {
    if (has_unknown_cords(stage)) return fit_loops(stage, group);
    if (guess_friction(stage, group)) refine(stage, group, solve_and_record(stage));
  }

  /// Loops that unknown cords make, or the cloth as well.
  void fit_loops(const SheetStage& stage, const ComponentGroup& group) {
    const State before = state();
    const double by_cords = solve_and_record(stage);
    const State dragged = state();
    // The cords have taken up what the cloth may explain.
    restore(before);
    if (guess_friction(stage, group)) {
      const double by_both = solve_and_record(stage);
      if (by_both < kClearFall * by_cords) {
        refine(stage, group, by_both);
        return;
      }
    }
    const ComponentLaw rubbing = law_of(fit_.material, group);
    restore(dragged);
    const double refined = refine(stage, group, by_cords);
    if (!rubbing.remembers()) return;

    const State elastic = state();
    ComponentLaw law = rubbing;
    law.stiffness = stiffness_of(group);
    set_law(fit_.material, group, law);
    const double by_both = solve(stage);
    const int more = law.parameter_count() - law_of(elastic.material, group).parameter_count();
    const bool worthwhile = is_worth(stage, more, refined, by_both);
    record(stage, by_both, worthwhile);
    if (!worthwhile) restore(elastic);
  }

  /// The noise of a pose is in all forces of a frame: frames count, not rows.
  static double frames_of(const SheetStage& stage) {
    double frames = 0;
    for (const SheetTest* test : stage.tests) frames += test->frame_count();
    return frames;
  }

  /// Whether the residual falls by what more parameters are worth.
  static bool is_worth(const SheetStage& stage, int parameters, double without, double with) {
    const double frames = frames_of(stage);
    return pliant::is_worth({without, 0, 0, frames}, {with, parameters, 0, frames});
  }

  /// Before the stage of friction an elastic curve goes through the middle of loops, whatever makes
  /// them: cords would take those of the cloth for their own, and bend the curve at rest.
  bool with_cords(const SheetStage& stage) const {
    return stage.kind == StageKind::friction ||
           std::ranges::none_of(stage.tests,
                                [&](const SheetTest* test) { return has_friction_stage(*test); });
  }

  bool has_friction_stage(const SheetTest& test) const {
    return std::ranges::any_of(fit_.plan, [&](const SheetStage& stage) {
      return stage.kind == StageKind::friction &&
             std::ranges::find(stage.tests, &test) != stage.tests.end();
    });
  }

  static bool has_unknown_cords(const SheetStage& stage) {
    return std::ranges::any_of(stage.tests, [](const SheetTest* test) {
      return test->cord_friction().unknown && !test->cords().empty();
    });
  }

  static bool is_stretch(const ComponentGroup& group) {
    return group.front() == "stretch.weft" || group.front() == "stretch.warp";
  }

  bool is_fitted(const ComponentGroup& group) const {
    return std::ranges::find(fitted_, group) != fitted_.end();
  }

  /// Whether the study states the stiffness of a group, or other experiments have told it.
  bool is_fixed(const ComponentGroup& group) const {
    return fixed_stiffness(settings_.fit, group).has_value() ||
           std::ranges::any_of(group, [&](const auto& name) { return known_.contains(name); });
  }

  /// The curve over the strains of the fitted sheets, with the addends beside it.
  void grow(const SheetStage& stage, const ComponentGroup& group, double rms) {
    SheetProblem problem = problem_of(stage);
    const double largest = search_.largest_strain(stage, problem, group);
    for (const std::string& component : group) fit_.strains[component] = largest;
    if (!is_fixed(group) && !is_sheet_pair(group.front()) &&
        guess_addends(stage, group, /*remembering=*/false)) {
      rms = solve_and_record(stage);
    }
    if (with_cords(stage)) {
      refine(stage, group, rms);
    } else {
      add_points(stage, group, rms);
    }
  }

  bool has_constant_stiffness(const ComponentGroup& group) const {
    const std::optional<CurveKind> own = model_of(settings_, group).stiffness;
    return (own ? own : settings_.model.stiffness) == CurveKind::constant;
  }

  /// As many control points as the curve is worth, where they are worth most.
  /// @return the root mean square of the differences then (N or m)
  double refine(const SheetStage& stage, const ComponentGroup& group, double rms) {
    return grade(stage, group, add_points(stage, group, rms));
  }

  /// One control point after the other, at equal distances.
  double add_points(const SheetStage& stage, const ComponentGroup& group, double rms) {
    const int first = stiffness_of(group).size();
    if (has_constant_stiffness(group) || is_fixed(group) || first == 0) return rms;
    std::vector<State> states;  // of each number of points that was tried
    const auto fit_of = [&](int points) -> std::optional<FittedModel> {
      if (points > first) {
        give_stiffness(going_along({group}).front(),
                       with_points(stiffness_of(group), grown_kind(settings_, group), points,
                                   strain_of(group)));
        rms = solve(stage);
      }
      states.push_back(state());
      return FittedModel{rms, points, 0, frames_of(stage)};
    };
    // Each search along a path with friction takes long.
    const bool rubs = law_of(fit_.material, group).remembers();
    const Growth growth = grow_model(first, settings_.fit.control_points, fit_of,
                                     accuracy_of(stage), /*patience=*/rubs ? 1 : 2);
    for (const GrowthStep& step : growth.steps) {
      restore(states[static_cast<std::size_t>(step.points - first)]);
      if (step.points > first) record(stage, step.fit.rms, step.accepted);
    }
    restore(states[static_cast<std::size_t>(growth.points - first)]);
    return growth.steps[static_cast<std::size_t>(growth.points - first)].fit.rms;
  }

  /// The control points once more, denser towards rest. They stay there where that pays.
  double grade(const SheetStage& stage, const ComponentGroup& group, double even) {
    const ScalarCurve curve = stiffness_of(group);
    if (curve.size() < 3 || even < accuracy_of(stage)) return even;
    const State before = state();
    give_stiffness(going_along({group}).front(),
                   with_points(curve, curve.kind(), curve.size(), curve.knots().back(),
                               /*power=*/2));
    const double graded = solve(stage);
    const bool worthwhile = is_worth(stage, 0, even, graded);
    record(stage, graded, worthwhile);
    if (worthwhile) return graded;
    restore(before);
    return even;
  }

  /// What searches change.
  struct State {
    Material material;
    CordFrictions cords;
  };
  State state() const { return {fit_.material, fit_.cords}; }
  void restore(const State& state) {
    fit_.material = state.material;
    fit_.cords = state.cords;
  }

  /// Friction of a tenth of the largest stress, spread over the strain that fits best.
  /// @return false where the sequence shows no friction, or no path of equilibria to begin with
  bool guess_friction(const SheetStage& stage, const ComponentGroup& group) {
    SheetProblem without = problem_of(stage);
    if (!search_.shows_loop(stage, without)) return false;
    const bool own = asks_for_friction(settings_, group);
    if (own && !begin_at_best(stage, group, "friction",
                              first_friction(law_of(fit_.material, group), strain_of(group)))) {
      fit_.warnings.push_back("friction of " + group.front() + " was not fitted: the sheets of " +
                              names_of(stage.tests) + " have no path of equilibria with it");
      return false;
    }
    return guess_addends(stage, group, /*remembering=*/true) || own;
  }

  /// The addends that the study asks for, those that remember or the others.
  /// @return whether there are any
  bool guess_addends(const SheetStage& stage, const ComponentGroup& group, bool remembering) {
    return begin_at_best(stage, group, remembering ? "addends that remember" : "elastic addends",
                         first_addends(law_of(fit_.material, group), model_of(settings_, group),
                                       strain_of(group), remembering));
  }

  /// Gives a group the law of some whose differences are least; none of them where they have no
  /// equilibria. Each needs the equilibria of all frames, and so does each step of a search: only
  /// the best is followed.
  bool begin_at_best(const SheetStage& stage, const ComponentGroup& group, const char* what,
                     const std::vector<ComponentLaw>& laws, const StartOptions& options = {}) {
    if (laws.empty()) return false;
    const ComponentLaw before = law_of(fit_.material, group);
    StartRecord record{group.front(), what, unit_of(stage), {}, 0, /*followed=*/false};
    const auto begin = [&](std::size_t start, double least) {
      set_law(fit_.material, group, laws[start]);
      SheetProblem problem = problem_of(stage);
      const LeastSquaresSummary begun = search_.at_start(stage, problem, least);
      record.ends.push_back(in_unit(stage, problem.rms(begun)));
      return begun.cost;
    };
    const StartSearch starts = search_from(laws.size(), begin, options);
    set_law(fit_.material, group, starts.found() ? laws[starts.best] : before);
    record.reached_best = starts.reached_best;
    fit_.starts.push_back(std::move(record));
    return starts.found();
  }

  double strain_of(const ComponentGroup& group) const { return largest_strain(fit_, group); }

  SheetProblem problem_of(const SheetStage& stage) {
    std::vector<ComponentGroup> groups = going_along(stage.groups);
    std::vector<double> strains;
    for (const ComponentGroup& group : groups) strains.push_back(strain_of(group));
    return {stage.tests, fit_.material, std::move(groups), std::move(strains),
            context_,    fit_.cords,    settings_.fit,     with_cords(stage)};
  }

  /// Where the strains of a stage are not known yet, nor needed.
  static std::vector<double> usual_strains(const SheetStage& stage) {
    return std::vector<double>(stage.groups.size(), kUsualStrain);
  }

  void give_stiffness(const ComponentGroup& group, const ScalarCurve& stiffness) {
    for (const std::string& component : group) {
      fit_.material.components[component].stiffness = stiffness;
    }
  }

  const ScalarCurve& stiffness_of(const ComponentGroup& group) const {
    return *fit_.material.components.at(group.front()).stiffness;
  }

  /// One stiffness to begin with. Forces tell it at once; how far a sheet hangs is tried from stiff
  /// to soft.
  void guess(const SheetStage& stage, const ComponentGroup& group) {
    if (is_fixed(group) || !is_bending(group.front())) return;
    begin_at_best(stage, going_along({group}).front(), "stiffness",
                  first_bending(fit_.material, group), {.patience = 2});
  }

  /// Without a test of shear the sheet has a fifth of its stretch stiffness.
  bool guess_shear() {
    const auto stretched = std::ranges::find_if(fit_.groups, [](const ComponentGroup& group) {
      return is_stretch(group);
    });
    if (stretched == fit_.groups.end() || is_fitted({"shear"}) || is_fixed({"shear"})) return false;
    const double stretch = law_of(fit_.material, *stretched).elastic_secant(0);
    fit_.material.components.at("shear").stiffness =
        ScalarCurve::hermite({0.0}, {0.2 * stretch}, true);
    return true;
  }

  static const char* unit_of(const SheetStage& stage) {
    return is_about_positions(stage) ? "mm" : "N";
  }
  /// @param rms  N or m
  static double in_unit(const SheetStage& stage, double rms) {
    return is_about_positions(stage) ? 1e3 * rms : rms;
  }

  double solve_and_record(const SheetStage& stage) {
    const double rms = solve(stage);
    record(stage, rms, true);
    return rms;
  }

  /// The search of a stage, whose result the material gets.
  /// @return the root mean square of the differences (N or m)
  double solve(const SheetStage& stage) {
    SheetProblem problem = problem_of(stage);
    const StageSearch::Solution found = search_.least(stage, problem);
    problem.keep_cords(found.values, fit_.cords);
    fit_.converged = fit_.converged && found.converged;
    fit_.material = problem.material_at(found.values);
    return found.rms;
  }

  /// Bending in the directions that are not fitted yet is taken to be like that of the first group
  /// that is: a sheet does not bend along one thread alone.
  std::vector<ComponentGroup> going_along(std::vector<ComponentGroup> groups) const {
    if (groups.size() != 1 || !is_bending(groups.front().front()) || is_fixed(groups.front())) {
      return groups;
    }
    const auto first = std::ranges::find_if(
        fitted_, [](const ComponentGroup& group) { return is_bending(group.front()); });
    if (first != fitted_.end() && *first != groups.front()) return groups;
    for (const char* component : {"bend.weft", "bend.warp", "bend.diagonal"}) {
      const bool known = std::ranges::any_of(fitted_, [&](const ComponentGroup& group) {
        return std::ranges::find(group, component) != group.end();
      });
      ComponentGroup& group = groups.front();
      const bool own = std::ranges::find(group, component) != group.end();
      if (!known && !own && !is_fixed({component})) group.emplace_back(component);
    }
    return groups;
  }

  void record(const SheetStage& stage, double rms, bool accepted) {
    std::vector<std::string> components;
    for (const ComponentGroup& group : stage.groups) components.push_back(group.front());
    const int points = stiffness_of(stage.groups.front()).size();
    std::string what = points == 0
                           ? "addends alone"
                           : fmt::format("{} control point{}", points, points == 1 ? "" : "s");
    if (stage.groups.size() > 1) what = "together";
    if (stage.kind == StageKind::limit) what += " with a limit of energy";
    if (stage.kind == StageKind::friction) {
      const bool rubs = law_of(fit_.material, stage.groups.front()).remembers();
      what += rubs ? " and friction" : " and cords";
    }
    fit_.stages.push_back({fmt::format("{}", fmt::join(components, ", ")), what, unit_of(stage),
                           in_unit(stage, rms), accepted});
  }

  const FitSettings& settings_;
  const RunContext& context_;
  SheetFit fit_;
  StageSearch search_;
  std::vector<ComponentGroup> fitted_;
  std::set<std::string> known_;     // components
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
