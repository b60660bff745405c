#include "pliant/estimation/sheet/friction_stage.h"

#include <algorithm>

#include "pliant/estimation/sheet/bending_friction.h"
#include "pliant/estimation/sheet/curve_growth.h"

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
  if (rubbing.remembers()) fitting.record(stage, by_cords, true);  // what grows is told last
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

}  // namespace

void fit_friction(SheetFitting& fitting, const SheetStage& stage, const ComponentGroup& group) {
  if (is_bending(group.front())) return fit_bending_friction(fitting, stage);
  if (has_unknown_cords(stage)) return fit_loops(fitting, stage, group);
  if (guess_friction(fitting, stage, group))
    refine(fitting, stage, group, fitting.solve_and_record(stage));
}

}  // namespace pliant
