#include "pliant/estimation/sheet/limit_stage.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

/// Gives components a limit of the share of an energy from which the differences are least.
/// @param softer  than now, the components
/// @param most    the largest energy that the sheets then reach without it (J/m^2)
/// @return false where the sheets have no equilibria with any
bool begin_at_limit(SheetFitting& fitting, const SheetStage& stage,
                    const std::vector<std::string>& components, double softer, double most) {
  constexpr std::array kShares{1.1, 0.8, 0.6, 0.4, 0.2};  // of the first the data tell nothing
  for (const std::string& component : components) {
    MaterialComponent& own = fitting.fit().material.components.at(component);
    own = scaled(own, softer);
  }
  fitting.fit().material.limits.push_back({components, most});
  const auto begin = [&](std::size_t start, double least) {
    fitting.fit().material.limits.back().energy = kShares[start] * most;
    SheetProblem trial = fitting.problem_of(stage);
    return fitting.search().at_start(stage, trial, least).cost;
  };
  const StartSearch starts = search_from(kShares.size(), begin);
  fitting.fit().material.limits.back().energy = kShares[starts.best] * most;
  return starts.found();
}

}  // namespace

void fit_limits(SheetFitting& fitting, const SheetStage& stage) {
  // A curve without a limit has become stiff in place of one.
  constexpr std::array kSofter{1.0, 0.3, 0.1};
  for (const std::vector<std::string>& components : fitting.settings().model.limits) {
    const SheetFitting::State without = fitting.state();
    SheetProblem problem = fitting.problem_of(stage);
    const double most =
        fitting.search().largest_energy(stage, problem, fitting.fit().material, components);
    SheetFitting::State best;
    StartRecord record{limit_name(components), "limit", unit_of(stage), {}, 0};
    const auto follow = [&](std::size_t start, double least) {
      fitting.restore(without);
      const double softer = kSofter[start];
      const bool begun = begin_at_limit(fitting, stage, components, softer, softer * most);
      const double rms = (begun ? fitting.solved(stage) : std::nullopt).value_or(INFINITY);
      record.ends.push_back(in_unit(stage, rms));
      if (rms < least) best = fitting.state();
      return rms;
    };
    const StartSearch starts = search_from(kSofter.size(), follow);
    if (!starts.found()) throw SolverError("the limit " + limit_name(components), 0, 0);
    record.reached_best = starts.reached_best;
    fitting.fit().starts.push_back(std::move(record));
    fitting.restore(best);
    fitting.record(stage, starts.costs[starts.best], true);
  }
}

}  // namespace pliant
