#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/run_context.h"
#include "pliant/estimation/sheet/sheet_plan.h"
#include "pliant/estimation/sheet/sheet_problem.h"

namespace pliant {

/// Whether a stage compares positions, and not forces.
bool is_about_positions(const SheetStage& stage);

/// Differences that curves need no further control points for (N or m): the noise that the sessions
/// state, the least where they differ, else a ten-thousandth of what is measured.
double accuracy_of(const SheetStage& stage);

/// The names of tests, for people.
std::string names_of(const std::vector<const SheetTest*>& tests);
/// The names of groups: those of their first components.
std::string names_of(const std::vector<ComponentGroup>& groups);

/// What a fit of sheets asks of the tests of its stages. Answers go to the journal of the run, and
/// a fit that was stopped takes from there what it has found before.
class StageSearch {
 public:
  /// @param context  outlives the search
  /// @param shapes   where searches for equilibria begin
  StageSearch(const RunContext& context, SheetGuesses shapes)
      : context_(context), shapes_(std::move(shapes)) {}

  /// Where a search ends.
  struct Solution {
    Eigen::VectorXd values;  ///< of the unknowns
    double rms = 0;          ///< of the differences (N or m)
    bool converged = false;
  };
  /// The least differences. A search that was stopped goes on where it was.
  /// @throws SolverError where it begins without equilibria
  Solution least(const SheetStage& stage, SheetProblem& problem);

  /// A search that is left where it would begin; its cost is infinite without equilibria. The next
  /// search begins at the shapes of this one where they cost less than `others` did.
  LeastSquaresSummary at_start(const SheetStage& stage, SheetProblem& problem, double others);

  /// What all but the outliers of the sheets' strains stay below where a search would begin.
  double largest_strain(const SheetStage& stage, SheetProblem& problem,
                        const ComponentGroup& group);

  /// The largest energy per area of some components together in the sheets where a search would
  /// begin (J/m^2).
  double largest_energy(const SheetStage& stage, SheetProblem& problem, const Material& material,
                        const std::vector<std::string>& components);

  /// Whether the measured forces lie above the predicted ones while clips go on and below them
  /// while they return, by more than chance.
  bool shows_loop(const SheetStage& stage, SheetProblem& problem);

  /// How many of the positions of a stage are independent, by the differences where a search would
  /// begin (`pliant::independent_rows`); 0 where those are not known.
  double independent_rows(const SheetStage& stage, SheetProblem& problem);

  /// The frames of each test of a stage that have no equilibrium where a search would begin.
  std::vector<std::vector<int>> lost_frames(const SheetStage& stage, SheetProblem& problem);

  /// What all answers have cost; seconds: of this run alone.
  const EquilibriumWork& work() const { return work_; }

 private:
  using Numbers = Journal::Numbers;

  /// What work with a problem finds, or has found before this fit was stopped.
  Numbers ask(const char* what, const SheetStage& stage, SheetProblem& problem,
              const std::function<Numbers()>& work);
  Numbers search(const SheetStage& stage, SheetProblem& problem);
  void keep_shapes(const SheetProblem& problem);

  const RunContext& context_;
  SheetGuesses shapes_;
  EquilibriumWork work_;
};

}  // namespace pliant
