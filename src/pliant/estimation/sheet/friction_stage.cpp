#include "pliant/estimation/sheet/friction_stage.h"

#include <algorithm>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/estimation/sheet/curve_growth.h"
#include "pliant/estimation/statistics/model_growth.h"

namespace pliant {
namespace {

constexpr double kClearFall = 0.5;  // of the residual, that a curve cannot make up for

bool has_unknown_cords(const SheetStage& stage) {
  return std::ranges::any_of(stage.tests, [](const SheetTest* test) {
    return test->cord_friction().unknown && !test->cords().empty();
  });
}

/// Friction of a tenth of the largest stress, spread over the strain that fits best.
/// @return false where the sequence shows no friction, or no path of equilibria to begin with
bool guess_friction(SheetFitting& fitting, const SheetStage& stage, const ComponentGroup& group) {
  SheetProblem without = fitting.problem_of(stage);
  if (!fitting.search().shows_loop(stage, without)) return false;
  const bool own = asks_for_friction(fitting.settings(), group);
  if (own && !fitting.begin_at_best(
                 stage, group, "friction",
                 first_friction(law_of(fitting.fit().material, group), fitting.strain_of(group)))) {
    fitting.fit().warnings.push_back("friction of " + group.front() +
                                     " was not fitted: the sheets of " + names_of(stage.tests) +
                                     " have no path of equilibria with it");
    return false;
  }
  return fitting.guess_addends(stage, group, /*remembering=*/true) || own;
}

/// Loops that unknown cords make, or the cloth as well.
void fit_loops(SheetFitting& fitting, const SheetStage& stage, const ComponentGroup& group) {
  const SheetFitting::State before = fitting.state();
  const double by_cords = fitting.solve_and_record(stage);
  const SheetFitting::State dragged = fitting.state();
  // The cords have taken up what the cloth may explain.
  fitting.restore(before);
  if (guess_friction(fitting, stage, group)) {
    const double by_both = fitting.solve_and_record(stage);
    if (by_both < kClearFall * by_cords) {
      refine(fitting, stage, group, by_both);
      return;
    }
  }
  const ComponentLaw rubbing = law_of(fitting.fit().material, group);
  fitting.restore(dragged);
  const double refined = refine(fitting, stage, group, by_cords);
  if (!rubbing.remembers()) return;

  const SheetFitting::State elastic = fitting.state();
  ComponentLaw law = rubbing;
  law.stiffness = fitting.stiffness_of(group);
  set_law(fitting.fit().material, group, law);
  const double by_both = fitting.solve(stage);
  const int more = law.parameter_count() - law_of(elastic.material, group).parameter_count();
  const bool worthwhile = is_worth(stage, more, refined, by_both);
  fitting.record(stage, by_both, worthwhile);
  if (!worthwhile) fitting.restore(elastic);
}

int numbers_of(const SheetFitting::State& state, const SheetStage& stage) {
  int count = 0;
  for (const ComponentGroup& group : stage.groups) {
    count += law_of(state.material, group).parameter_count();
  }
  return count;
}

/// Gives all directions of a stage friction of a tenth of their largest stress, spread over the
/// share of strain that fits best, beside an even stiffness: curves that were fitted without
/// friction have bent in its place.
/// @throws SolverError where the sheets have no path with any
void begin_with_friction(SheetFitting& fitting, const SheetStage& stage) {
  const Material elastic = fitting.fit().material;
  std::vector<std::vector<ComponentLaw>> laws;  // of each group, from each start
  for (const ComponentGroup& group : stage.groups) {
    const double strain = fitting.strain_of(group);
    const double stiffness = law_of(elastic, group).elastic_secant(strain / 2);
    laws.push_back(
        first_friction({ScalarCurve::hermite({0.0}, {stiffness}, /*even=*/true)}, strain));
  }
  StartRecord record{names_of(stage.groups), "friction", unit_of(stage), {}, 0, /*followed=*/false};
  const auto give = [&](std::size_t start) {
    for (std::size_t g = 0; g < laws.size(); ++g) {
      set_law(fitting.fit().material, stage.groups[g], laws[g][start]);
    }
  };
  const auto begin = [&](std::size_t start, double least) {
    give(start);
    SheetProblem problem = fitting.problem_of(stage);
    const LeastSquaresSummary begun = fitting.search().at_start(stage, problem, least);
    record.ends.push_back(in_unit(stage, problem.rms(begun)));
    return begun.cost;
  };
  const StartSearch starts = search_from(laws.front().size(), begin);
  if (!starts.found()) {
    throw SolverError("a path of the sheets of " + names_of(stage.tests) + " with friction", 0, 0);
  }
  give(starts.best);
  record.reached_best = starts.reached_best;
  fitting.fit().starts.push_back(std::move(record));
}

/// Friction of all directions of a stage that bend, where it is worth its numbers or the study
/// insists on it.
void fit_bending_friction(SheetFitting& fitting, const SheetStage& stage) {
  const SheetFitting::State elastic = fitting.state();
  SheetProblem problem = fitting.problem_of(stage);
  const double without = problem.rms(fitting.search().at_start(stage, problem, 0));
  begin_with_friction(fitting, stage);
  double rms = fitting.solve_and_record(stage);
  for (const ComponentGroup& group : stage.groups) rms = refine(fitting, stage, group, rms);
  const double frames = frames_of(stage);
  const bool insists = std::ranges::all_of(stage.groups, [&](const ComponentGroup& group) {
    return model_of(fitting.settings(), group).friction->choice != FrictionChoice::automatic;
  });
  if (insists || is_worth({without, numbers_of(elastic, stage), 0, frames},
                          {rms, numbers_of(fitting.state(), stage), 0, frames})) {
    return;
  }
  fitting.restore(elastic);
  fitting.record(stage, without, true);
}

}  // namespace

void fit_friction(SheetFitting& fitting, const SheetStage& stage, const ComponentGroup& group) {
  if (is_bending(group.front())) return fit_bending_friction(fitting, stage);
  if (has_unknown_cords(stage)) return fit_loops(fitting, stage, group);
  if (guess_friction(fitting, stage, group))
    refine(fitting, stage, group, fitting.solve_and_record(stage));
}

}  // namespace pliant
