#include "pliant/estimation/sheet/curve_growth.h"

#include <optional>
#include <vector>

namespace pliant {
namespace {

bool has_constant_stiffness(const FitSettings& settings, const ComponentGroup& group) {
  const std::optional<CurveKind> own = model_of(settings, group).stiffness;
  return (own ? own : settings.model.stiffness) == CurveKind::constant;
}

/// One control point after the other, at equal distances.
double add_points(SheetFitting& fitting, const SheetStage& stage, const ComponentGroup& group,
                  double rms) {
  const int first = fitting.stiffness_of(group).size();
  if (has_constant_stiffness(fitting.settings(), group) || fitting.is_fixed(group) || first == 0)
    return rms;
  std::vector<SheetFitting::State> states;  // of each number of points that was tried
  const auto fit_of = [&](int points) -> std::optional<FittedModel> {
    if (points > first) {
      fitting.give_stiffness(
          fitting.going_along({group}).front(),
          with_points(fitting.stiffness_of(group), grown_kind(fitting.settings(), group), points,
                      fitting.strain_of(group)));
      const std::optional<double> grown = fitting.solved(stage);
      if (!grown) return std::nullopt;
      rms = *grown;
    }
    states.push_back(fitting.state());
    return FittedModel{rms, points, 0, frames_of(stage)};
  };
  // Each search along a path with friction takes long.
  const bool rubs = law_of(fitting.fit().material, group).remembers();
  const Growth growth = grow_model(first, fitting.settings().fit.control_points, fit_of,
                                   accuracy_of(stage), /*patience=*/rubs ? 1 : 2);
  for (const GrowthStep& step : growth.steps) {
    fitting.restore(states[static_cast<std::size_t>(step.points - first)]);
    if (step.points > first) fitting.record(stage, step.fit.rms, step.accepted);
  }
  // A stage of several groups was recorded before any of them grew.
  if (growth.steps.size() > 1 || stage.groups.size() == 1) fitting.record_end(growth.end);
  fitting.restore(states[static_cast<std::size_t>(growth.points - first)]);
  return growth.steps[static_cast<std::size_t>(growth.points - first)].fit.rms;
}

/// The control points once more, denser towards rest. They stay there where that pays.
double grade(SheetFitting& fitting, const SheetStage& stage, const ComponentGroup& group,
             double even) {
  const ScalarCurve curve = fitting.stiffness_of(group);
  if (curve.size() < 3 || even < accuracy_of(stage)) return even;
  const SheetFitting::State before = fitting.state();
  fitting.give_stiffness(fitting.going_along({group}).front(),
                         with_points(curve, curve.kind(), curve.size(), curve.knots().back(),
                                     /*power=*/2));
  const std::optional<double> graded = fitting.solved(stage);
  const bool worthwhile = graded && is_worth(stage, 0, even, *graded);
  if (graded) fitting.record(stage, *graded, worthwhile);
  if (worthwhile) return *graded;
  fitting.restore(before);
  return even;
}

}  // namespace

double refine(SheetFitting& fitting, const SheetStage& stage, const ComponentGroup& group,
              double rms) {
  return grade(fitting, stage, group, add_points(fitting, stage, group, rms));
}

void grow(SheetFitting& fitting, const SheetStage& stage, const ComponentGroup& group, double rms) {
  SheetProblem problem = fitting.problem_of(stage);
  const double largest = fitting.search().largest_strain(stage, problem, group);
  for (const std::string& component : group) fitting.fit().strains[component] = largest;
  if (!fitting.is_fixed(group) && !is_sheet_pair(group.front()) &&
      fitting.guess_addends(stage, group, /*remembering=*/false)) {
    rms = fitting.solve_and_record(stage);
  }
  if (fitting.with_cords(stage)) {
    refine(fitting, stage, group, rms);
  } else {
    add_points(fitting, stage, group, rms);
  }
}

}  // namespace pliant
