#include "pliant/estimation/sheet/bending_friction.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/estimation/sheet/curve_growth.h"
#include "pliant/estimation/statistics/model_growth.h"

namespace pliant {
namespace {

int numbers_of(const SheetFitting::State& state, const SheetStage& stage) {
  int count = 0;
  for (const ComponentGroup& group : stage.groups) {
    count += law_of(state.material, group).parameter_count();
  }
  return count;
}

/// The friction of a direction that is known, at several shares of it: threads that rub do so in
/// all directions that bend.
void add_known_friction(const SheetStage& stage, const Material& material,
                        std::vector<std::vector<ComponentLaw>>& starts) {
  for (const auto& [name, component] : material.components) {
    const std::optional<ComponentLaw> known = law_of(material, name);
    if (!is_bending(name) || !known || known->friction_law == FrictionLaw::none) continue;
    for (const double share : {0.5, 1.0, 2.0}) {
      starts.emplace_back(stage.groups.size(), law_of(scaled(component, share)));
    }
  }
}

/// Friction of each direction beside an even stiffness, the same share of the strains in each:
/// curves that were fitted without friction have bent in its place.
std::vector<std::vector<ComponentLaw>> starts_of(const SheetFitting& fitting,
                                                 const SheetStage& stage, const Material& elastic) {
  std::vector<std::vector<ComponentLaw>> starts;
  for (const ComponentGroup& group : stage.groups) {
    const double strain = fitting.strain_of(group);
    const double stiffness = law_of(elastic, group).elastic_secant(strain / 2);
    const std::vector<ComponentLaw> own =
        first_friction({ScalarCurve::hermite({0.0}, {stiffness}, /*even=*/true)}, strain);
    starts.resize(own.size());
    for (std::size_t i = 0; i < own.size(); ++i) starts[i].push_back(own[i]);
  }
  add_known_friction(stage, elastic, starts);
  return starts;
}

}  // namespace

void fit_bending_friction(SheetFitting& fitting, const SheetStage& stage) {
  const SheetFitting::State elastic = fitting.state();
  SheetProblem problem = fitting.problem_of(stage);
  const double without = problem.rms(fitting.search().at_start(stage, problem, 0));
  if (!fitting.begin_at_best(stage, stage.groups, "friction",
                             starts_of(fitting, stage, elastic.material))) {
    throw SolverError("a path of the sheets of " + names_of(stage.tests) + " with friction", 0, 0);
  }
  double rms = fitting.solve_and_record(stage);
  for (const ComponentGroup& group : stage.groups) rms = refine(fitting, stage, group, rms);
  SheetProblem rich = fitting.problem_of(stage);
  const double rows = std::max(frames_of(stage), fitting.search().independent_rows(stage, rich));
  const bool insists = std::ranges::all_of(stage.groups, [&](const ComponentGroup& group) {
    return model_of(fitting.settings(), group).friction->choice != FrictionChoice::automatic;
  });
  if (insists || is_worth({without, numbers_of(elastic, stage), 0, rows},
                          {rms, numbers_of(fitting.state(), stage), 0, rows})) {
    return;
  }
  fitting.restore(elastic);
  fitting.record(stage, without, true);
}

}  // namespace pliant
