#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pliant/estimation/sheet/sheet_fit.h"
#include "pliant/estimation/sheet/stage_search.h"
#include "pliant/estimation/start_search.h"
#include "pliant/estimation/statistics/model_growth.h"

namespace pliant {

/// A fit of sheets under way: the material so far, and what all stages do with it.
class SheetFitting {
 public:
  /// @param settings, context  outlive it
  /// @param start  null, or a material whose curves are the first ones
  /// @param known  laws that stay as they are
  SheetFitting(const FitSettings& settings, std::vector<SheetStage> plan, const RunContext& context,
               const Material* start, const KnownComponents& known);

  const FitSettings& settings() const { return settings_; }
  const RunContext& context() const { return context_; }
  SheetFit& fit() { return fit_; }
  StageSearch& search() { return search_; }

  /// What searches change.
  struct State {
    Material material;
    CordFrictions cords;
    bool converged = true;  ///< all searches that have led here
  };
  State state() const { return {fit_.material, fit_.cords, fit_.converged}; }
  void restore(const State& state);

  SheetProblem problem_of(const SheetStage& stage) const;
  /// The search of a stage, whose result the material gets.
  /// @return the root mean square of the differences (N or m)
  double solve(const SheetStage& stage);
  /// The same; nothing where the search begins without equilibria.
  std::optional<double> solved(const SheetStage& stage);
  double solve_and_record(const SheetStage& stage);
  /// Tells of a stage where its search has ended.
  /// @param rms  N or m
  void record(const SheetStage& stage, double rms, bool accepted);
  /// Tells why a growth has ended, whose last step was recorded last.
  void record_end(GrowthEnd end);

  bool is_fitted(const ComponentGroup& group) const;
  void mark_fitted(const ComponentGroup& group);
  /// Whether the study states the stiffness of a group, or other experiments have told it.
  bool is_fixed(const ComponentGroup& group) const;
  double strain_of(const ComponentGroup& group) const { return largest_strain(fit_, group); }
  const ScalarCurve& stiffness_of(const ComponentGroup& group) const;
  void give_stiffness(const ComponentGroup& group, const ScalarCurve& stiffness);

  /// Bending in the directions that are not fitted yet is taken to be like that of the first group
  /// that is: a sheet does not bend along one thread alone.
  std::vector<ComponentGroup> going_along(std::vector<ComponentGroup> groups) const;

  /// Before the stage of friction an elastic curve goes through the middle of loops, whatever makes
  /// them: cords would take those of the cloth for their own, and bend the curve at rest.
  bool with_cords(const SheetStage& stage) const;

  /// Gives a group the law of some whose differences are least; none of them where they have no
  /// equilibria. Each needs the equilibria of all frames, and so does each step of a search: only
  /// the best is followed.
  bool begin_at_best(const SheetStage& stage, const ComponentGroup& group, const char* what,
                     const std::vector<ComponentLaw>& laws, const StartOptions& options = {});
  /// The same of several groups at once.
  /// @param starts  of each a law for every group
  bool begin_at_best(const SheetStage& stage, const std::vector<ComponentGroup>& groups,
                     const char* what, const std::vector<std::vector<ComponentLaw>>& starts,
                     const StartOptions& options = {});

  /// Begins with the addends that the study asks for, those that remember or the others.
  /// @return whether there are any
  bool guess_addends(const SheetStage& stage, const ComponentGroup& group, bool remembering);

 private:
  bool has_friction_stage(const SheetTest& test) const;

  const FitSettings& settings_;
  const RunContext& context_;
  SheetFit fit_;
  StageSearch search_;
  std::vector<ComponentGroup> fitted_;
  std::set<std::string> known_;  // components
};

/// The noise of a pose is in all forces of a frame: frames count, not rows.
double frames_of(const SheetStage& stage);

/// Whether the residual of a stage falls by what more parameters are worth.
bool is_worth(const SheetStage& stage, int parameters, double without, double with);

/// What the differences of a stage are told in: mm or N.
const char* unit_of(const SheetStage& stage);
/// @param rms  N or m
double in_unit(const SheetStage& stage, double rms);

}  // namespace pliant
