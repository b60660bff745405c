#include "pliant/estimation/sheet/sheet_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/sheet/sheet_journal.h"
#include "pliant/estimation/sheet/sheet_options.h"
#include "pliant/estimation/sheet/sheet_problem.h"
#include "pliant/experiment/session/frame_measures.h"
#include "pliant/experiment/sheet/sheet_system.h"

namespace pliant {
namespace {

constexpr double kWorthwhileFall = 0.01;  // [T] 3.4.2
constexpr double kOutlierShare = 0.01;    // of strains, before the range is taken
constexpr int kNoiseRounds = 3;
constexpr double kNoiseSettled = 0.1;
constexpr LeastSquaresOptions kStageSearch{
    .max_iterations = 25, .function_tolerance = 1e-4, .parameter_tolerance = 1e-6};

class Fitter {
 public:
  using Numbers = Journal::Numbers;

  Fitter(const Study& study, const RunContext& context) : study_(study), context_(context) {
    fit_.material = first_sheet_material(study);
  }

  SheetFit run(const std::vector<SheetStage>& plan, const Material* start) && {
    shapes_ = begin_journal(context_.journal, study_, plan, start);
    fit_.groups = groups_of(plan);
    for (const SheetStage& stage : plan) {
      if (stage.kind != StageKind::friction) continue;
      with_friction_.insert(with_friction_.end(), stage.tests.begin(), stage.tests.end());
    }
    if (start) {
      fit_.material.components = start->components;
      fitted_ = fit_.groups;
    }
    ProgressTask task(context_.progress, "fit", static_cast<double>(plan.size()));
    for (std::size_t s = 0; s < plan.size(); ++s) {
      context_.stop.throw_if_requested();
      run_stage(plan[s]);
      task.advance(static_cast<double>(s + 1));
    }
    return std::move(fit_);
  }

 private:
  void run_stage(const SheetStage& stage) {
    if (stage.kind == StageKind::friction) return fit_friction(stage, stage.groups.front());
    for (const ComponentGroup& group : stage.groups) {
      if (!is_fitted(group)) guess(stage, group);
    }
    double rms = solve(stage);
    // Without a test of its own shear follows stretch.
    if (stage.groups.front().front().starts_with("stretch") && guess_shear()) rms = solve(stage);
    record(stage, rms, true);
    if (stage.kind == StageKind::grow) grow(stage, stage.groups.front(), rms);
    for (const ComponentGroup& group : stage.groups) {
      if (!is_fitted(group)) fitted_.push_back(group);
    }
  }

  /// Friction, where the loops of a stage are not those of its cords.
  void fit_friction(const SheetStage& stage, const ComponentGroup& group) {
    const bool cords_drag = has_unknown_cords(stage);
    const double without = cords_drag ? solve(stage) : INFINITY;
    const Material elastic = fit_.material;
    const CordFrictions cords = fit_.cords;
    // Else the cords would have taken up what the cloth may explain.
    for (const SheetTest* test : stage.tests) {
      for (const SheetUnknown& cord : cord_unknowns(*test)) fit_.cords.erase(cord.name);
    }
    if (!guess_friction(stage, group)) {
      fit_.cords = cords;
      return;
    }
    const double rms = solve(stage);
    const bool worthwhile = !cords_drag || is_worth_friction(stage, without, rms);
    record(stage, rms, worthwhile);
    if (worthwhile) return grade(stage, group, rms);
    fit_.material = elastic;
    fit_.cords = cords;
  }

  /// Whether the residual falls by what three more parameters are worth: by the Bayesian
  /// information criterion, and by as much as a control point.
  static bool is_worth_friction(const SheetStage& stage, double without, double with) {
    double rows = 0;
    for (const SheetTest* test : stage.tests) rows += test->rows();
    return with < (1 - kWorthwhileFall) * without &&
           2 * rows * std::log(without / with) > 3 * std::log(rows);
  }

  /// Before the stage of friction an elastic curve goes through the middle of loops, whatever makes
  /// them: cords would take those of the cloth for their own, and bend the curve at rest.
  bool with_cords(const SheetStage& stage) const {
    return stage.kind == StageKind::friction ||
           std::ranges::none_of(stage.tests, [&](const SheetTest* test) {
             return std::ranges::find(with_friction_, test) != with_friction_.end();
           });
  }

  static bool has_unknown_cords(const SheetStage& stage) {
    return std::ranges::any_of(stage.tests, [](const SheetTest* test) {
      return test->cord_friction().unknown && !test->cords().empty();
    });
  }

  bool is_fitted(const ComponentGroup& group) const {
    return std::ranges::find(fitted_, group) != fitted_.end();
  }

  /// Whether the study states the stiffness of a group.
  bool is_fixed(const ComponentGroup& group) const {
    return fixed_stiffness(study_.fit, group).has_value();
  }

  /// One control point after the other, at equal distances.
  void grow(const SheetStage& stage, const ComponentGroup& group, double best) {
    const double largest = measure_strain(stage, group);
    for (const std::string& component : group) fit_.strains[component] = largest;
    if (study_.model.stiffness == CurveKind::constant || is_fixed(group)) return;
    const bool even = is_even(group.front());
    const int first = stiffness_of(group).size() + 1;
    Material accepted = fit_.material;
    CordFrictions cords = fit_.cords;
    int useless = 0;
    for (int points = first; points <= study_.fit.control_points && useless < 2; ++points) {
      if (best < accuracy_of(stage)) break;
      const ScalarCurve last = stiffness_of(group);
      std::vector<double> knots, values;
      for (int i = 0; i < points; ++i) {
        knots.push_back(largest * i / (points - 1));
        values.push_back(last.value(knots.back()));
      }
      give_stiffness(going_along({group}).front(), ScalarCurve::hermite(knots, values, even));
      const double rms = solve(stage);
      const bool worthwhile = rms < (1 - kWorthwhileFall) * best;
      record(stage, rms, worthwhile);
      useless = worthwhile ? 0 : useless + 1;
      if (!worthwhile) continue;
      best = rms;
      accepted = fit_.material;
      cords = fit_.cords;
    }
    fit_.material = accepted;
    fit_.cords = cords;
  }

  /// The control points once more, denser towards rest, where friction no longer hides what the
  /// curve is like. They stay there where that pays.
  void grade(const SheetStage& stage, const ComponentGroup& group, double even) {
    const ScalarCurve curve = stiffness_of(group);
    if (curve.size() < 3 || even < accuracy_of(stage)) return;
    const Material before = fit_.material;
    const CordFrictions cords = fit_.cords;
    std::vector<double> knots, values;
    for (int i = 0; i < curve.size(); ++i) {
      const double share = static_cast<double>(i) / (curve.size() - 1);
      knots.push_back(curve.knots().back() * share * share);
      values.push_back(curve.value(knots.back()));
    }
    give_stiffness(group, ScalarCurve::hermite(knots, values, is_even(group.front())));
    const double graded = solve(stage);
    const bool worthwhile = graded < (1 - kWorthwhileFall) * even;
    record(stage, graded, worthwhile);
    if (worthwhile) return;
    fit_.material = before;
    fit_.cords = cords;
  }

  /// Whether the forces of a stage lie above the elastic ones while clips go on and below them
  /// while they return, by more than chance.
  bool shows_loop(const SheetStage& stage) {
    const SheetProblem problem = problem_of(stage);
    return ask(problem, "loop", stage, [&] {
             return Numbers{has_loop(stage, problem) ? 1.0 : 0.0};
           }).front() > 0;
  }

  bool has_loop(const SheetStage& stage, const SheetProblem& problem) const {
    constexpr double kChance = 4, kSmallest = 0.005;  // standard errors; of the forces
    double loop = 0, squares = 0, forces = 0;
    int rows = 0;
    for (std::size_t t = 0; t < stage.tests.size(); ++t) {
      const SheetTest& test = *stage.tests[t];
      const auto shapes = problem.predict(t, problem.start(), false, context_.threads);
      if (!shapes) return true;
      for (int frame = 1; frame < test.frame_count(); ++frame) {
        const double step = travel(test.session(), frame) - travel(test.session(), frame - 1);
        const Eigen::ArrayXd force = test.measured(frame).array();
        const Eigen::ArrayXd above =
            force - test.predicted(frame, (*shapes)[static_cast<std::size_t>(frame)]).array();
        loop += (step > 0 ? 1 : -1) * (above * force.sign()).sum();
        squares += above.square().sum();
        forces += force.square().sum();
        rows += static_cast<int>(force.size());
      }
    }
    return loop > kChance * std::sqrt(squares) && loop > kSmallest * std::sqrt(forces * rows);
  }

  /// Friction of a tenth of the largest stress, spread over the strain that fits best.
  /// @return false where the sequence shows no friction, or no path of equilibria to begin with
  bool guess_friction(const SheetStage& stage, const ComponentGroup& group) {
    if (!shows_loop(stage)) return false;
    const double strain = strain_of(group);
    const ComponentLaw elastic = law_of(fit_.material, group);
    ComponentLaw law = elastic;
    law.friction_law = FrictionLaw::dahl;
    double least = INFINITY;
    std::array<double, 3> best{};
    for (const double share : {0.02, 0.06, 0.2}) {
      law.friction = {0.1 * law.elastic_stress(strain), 0, share * strain};
      set_law(fit_.material, group, law);
      const double cost = cost_at_start(stage, problem_of(stage), least);
      if (cost >= least) continue;
      least = cost;
      best = law.friction;
    }
    if (!std::isfinite(least)) {
      fit_.warnings.push_back("friction of " + group.front() + " was not fitted: the sheets of " +
                              names(stage.tests) + " have no path of equilibria with it");
      set_law(fit_.material, group, elastic);
      return false;
    }
    law.friction = best;
    set_law(fit_.material, group, law);
    return true;
  }

  double strain_of(const ComponentGroup& group) const { return largest_strain(fit_, group); }

  SheetProblem problem_of(const SheetStage& stage) {
    std::vector<ComponentGroup> groups = going_along(stage.groups);
    std::vector<double> strains;
    for (const ComponentGroup& group : groups) strains.push_back(strain_of(group));
    SheetProblem problem(stage.tests, fit_.material, std::move(groups), std::move(strains),
                         context_, fit_.cords, study_.fit, with_cords(stage));
    problem.set_noise(accuracy_of(stage));
    problem.begin_at(shapes_);
    return problem;
  }

  void give_stiffness(const ComponentGroup& group, const ScalarCurve& stiffness) {
    for (const std::string& component : group) {
      fit_.material.components[component].stiffness = stiffness;
    }
  }

  const ScalarCurve& stiffness_of(const ComponentGroup& group) const {
    return *fit_.material.components.at(group.front()).stiffness;
  }

  /// Differences that no instrument sees: curves need no further control points for them.
  static double accuracy_of(const SheetStage& stage) {
    constexpr double kForce = 1e-3, kPosition = 1e-5;  // N, m; a third of [T] 3.2.3 and less
    return is_about_positions(stage) ? kPosition : kForce;
  }

  static bool is_about_positions(const SheetStage& stage) {
    return stage.tests.front()->objective() == SheetObjective::positions;
  }

  /// One stiffness to begin with. Forces tell it at once; how far a sheet hangs is tried from stiff
  /// to soft.
  void guess(const SheetStage& stage, const ComponentGroup& group) {
    if (is_fixed(group)) return;
    const bool even = is_even(group.front());
    const ComponentGroup all = going_along({group}).front();
    const auto constant = [&](double value) {
      give_stiffness(all, ScalarCurve::hermite({0.0}, {value}, even));
    };
    constant(stiffness_of(group).value(0));
    if (!is_bending(group.front())) return;
    constexpr double kPlateau = 1.1;  // of the least cost: stiffness may not matter yet
    double least = INFINITY, best = 0;
    int worse = 0;
    for (const double value : first_bending(group)) {
      constant(value);
      SheetProblem problem(stage.tests, fit_.material, stage.groups,
                           std::vector<double>(stage.groups.size(), 0.01), context_);
      problem.begin_at(shapes_);
      const double cost = cost_at_start(stage, problem, least);
      const bool nothing_yet = !std::isfinite(least);
      worse = nothing_yet || cost < kPlateau * least ? 0 : worse + 1;
      if (cost < least) {
        least = cost;
        best = value;
      }
      if (worse == 2) break;
    }
    constant(best);
  }

  /// Stiffnesses to try, stiff ones first: soft sheets fold, and take long. What bends diagonally
  /// is not far from what bends along the threads.
  std::vector<double> first_bending(const ComponentGroup& group) const {
    const auto known = [&](const char* component) {
      return fit_.material.components.at(component).stiffness->value(0);
    };
    std::vector<double> values;
    if (group.front() == "bend.diagonal") {
      const double mean = (known("bend.weft") + known("bend.warp")) / 2;
      for (const double share : {2.0, 1.0, 0.5, 0.25}) values.push_back(share * mean);
      return values;
    }
    const bool springs = fit_.material.bending == "spring";
    for (double value = springs ? 0.1 : 1e-3; value > (springs ? 1e-4 : 3e-8); value *= 0.4) {
      values.push_back(value);
    }
    return values;
  }

  /// Without a test of shear the sheet has a fifth of its stretch stiffness.
  bool guess_shear() {
    const auto stretched = std::ranges::find_if(fit_.groups, [](const ComponentGroup& group) {
      return group.front().starts_with("stretch");
    });
    if (stretched == fit_.groups.end() || is_fitted({"shear"}) || is_fixed({"shear"})) return false;
    const double stretch = fit_.material.components.at(stretched->front()).stiffness->value(0);
    fit_.material.components.at("shear").stiffness =
        ScalarCurve::hermite({0.0}, {0.2 * stretch}, true);
    return true;
  }

  /// The search of a stage, whose result the material gets.
  /// @return the root mean square of the differences (N or m)
  double solve(const SheetStage& stage) {
    SheetProblem problem = problem_of(stage);
    const Numbers found = ask(problem, "search", stage, [&] { return search(stage, problem); });
    const auto count = static_cast<Eigen::Index>(problem.unknowns().size());
    const Eigen::VectorXd values = Eigen::VectorXd::Map(found.data(), count);
    const double rms = found[found.size() - 2];
    problem.keep_cords(values, fit_.cords);
    fit_.converged = fit_.converged && found.back() > 0;
    fit_.material = problem.material_at(values);
    return rms;
  }

  /// Where a stage's search ends: the unknowns, the root mean square of the differences (N or m),
  /// and whether it converged. One that was stopped goes on where it was.
  Numbers search(const SheetStage& stage, SheetProblem& problem) {
    const Numbers& reached = context_.journal.reached();
    LeastSquaresSummary summary;
    summary.parameters = problem.start();
    if (!reached.empty()) {
      summary.parameters = Eigen::VectorXd::Map(reached.data(), std::ssize(reached));
    }
    double noise = accuracy_of(stage), rms = 0;
    // Priors are weighed against the noise, which the residuals tell.
    for (int round = 0; round < (problem.has_priors() ? kNoiseRounds : 1); ++round) {
      problem.set_noise(noise);
      summary = solve_least_squares(with_journal(problem.least_squares(), context_.journal),
                                    summary.parameters, kStageSearch, context_.stop);
      if (!std::isfinite(summary.cost)) {
        throw SolverError("the equilibrium of every frame of " + names(stage.tests), 0, 0);
      }
      rms = problem.rms(summary);
      const double before = std::exchange(noise, std::max(rms, accuracy_of(stage)));
      if (std::abs(noise - before) < kNoiseSettled * before) break;
    }
    keep_shapes(problem);
    Numbers found(summary.parameters.begin(), summary.parameters.end());
    found.push_back(rms);
    found.push_back(summary.converged ? 1 : 0);
    return found;
  }

  /// Half the squared residuals where a search would begin; infinite without equilibria. The next
  /// search begins at their shapes where that is less than others had.
  double cost_at_start(const SheetStage& stage, const SheetProblem& problem, double least) {
    const auto cost = [&] {
      const LeastSquaresProblem squares = problem.least_squares();
      Eigen::VectorXd residual(squares.residuals);
      const bool found = squares.evaluate(problem.start(), residual, nullptr);
      const double own = found ? residual.squaredNorm() / 2 : INFINITY;
      if (own < least) keep_shapes(problem);
      return Numbers{own};
    };
    return ask(problem, "cost", stage, cost).front();
  }

  void keep_shapes(const SheetProblem& problem) {
    problem.keep(shapes_);
    pliant::keep_shapes(context_.journal, shapes_);
  }

  /// What work with a problem finds, or has found before this fit was stopped.
  Numbers ask(const SheetProblem& problem, const char* what, const SheetStage& stage,
              const std::function<Numbers()>& work) {
    std::vector<std::string> components;
    for (const ComponentGroup& group : stage.groups) components.push_back(group.front());
    const std::string question =
        fmt::format("{} of {} in {}", what, fmt::join(components, ", "), names(stage.tests));
    Numbers answer = context_.journal.answer(question, [&] {
      Numbers found = work();
      const EquilibriumWork cost = problem.work();
      fit_.work.seconds += cost.seconds;
      append_counts(cost.counts, found);
      return found;
    });
    fit_.work.counts += take_counts(answer);
    return answer;
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

  double measure_strain(const SheetStage& stage, const ComponentGroup& group) {
    const SheetProblem problem = problem_of(stage);
    return ask(problem, "strain", stage, [&] { return Numbers{strain_in(problem, stage, group)}; })
        .front();
  }

  /// What all but the outliers of the sheets' strains stay below.
  double strain_in(const SheetProblem& problem, const SheetStage& stage,
                   const ComponentGroup& group) const {
    std::vector<double> strains;
    for (std::size_t t = 0; t < stage.tests.size(); ++t) {
      const SheetTest& test = *stage.tests[t];
      const auto shapes = problem.predict(t, problem.start(), false, context_.threads);
      if (!shapes) continue;
      const SheetSystem sheet(test.session(), fit_.material, {.friction = false}, {});
      for (const SheetShape& shape : *shapes) {
        for (const std::string& component : group) {
          if (!usually_strains(test, component)) continue;
          const std::vector<double> own = sheet.strains(component, shape.positions);
          strains.insert(strains.end(), own.begin(), own.end());
        }
      }
    }
    if (is_even(group.front())) {
      for (double& strain : strains) strain = std::abs(strain);
    }
    const auto at =
        strains.begin() +
        static_cast<std::ptrdiff_t>((1 - kOutlierShare) * static_cast<double>(strains.size()));
    std::ranges::nth_element(strains, at);
    return std::max(*at, 1e-9);
  }

  /// A test of weft says nothing about the strains that warp has.
  static bool usually_strains(const SheetTest& test, const std::string& component) {
    const std::vector<std::string> usual = usual_components(test.session().test);
    const bool directed = component.ends_with(".weft") || component.ends_with(".warp");
    if (usual.empty() || !directed) return true;
    const auto family = [](const std::string& name) { return name.substr(0, name.find('.')); };
    return usual.front() == component || family(usual.front()) != family(component);
  }

  void record(const SheetStage& stage, double rms, bool accepted) {
    const bool positions = is_about_positions(stage);
    std::vector<std::string> components;
    for (const ComponentGroup& group : stage.groups) components.push_back(group.front());
    const int points = stiffness_of(stage.groups.front()).size();
    std::string what = fmt::format("{} control point{}", points, points == 1 ? "" : "s");
    if (stage.groups.size() > 1) what = "together";
    if (stage.kind == StageKind::friction) what += " and friction";
    fit_.stages.push_back({fmt::format("{}", fmt::join(components, ", ")), what,
                           positions ? "mm" : "N", positions ? 1e3 * rms : rms, accepted});
  }

  static std::string names(const std::vector<const SheetTest*>& tests) {
    std::vector<std::string> list;
    for (const SheetTest* test : tests) list.push_back(test->name());
    return fmt::format("{}", fmt::join(list, ", "));
  }

  const Study& study_;
  const RunContext& context_;
  SheetFit fit_;
  std::vector<ComponentGroup> fitted_;
  std::vector<const SheetTest*> with_friction_;  // tests that have a stage of it
  SheetGuesses shapes_;
};

}  // namespace

double largest_strain(const SheetFit& fit, const ComponentGroup& group) {
  constexpr double kUsual = 0.01;
  const auto known = fit.strains.find(group.front());
  return known == fit.strains.end() ? kUsual : known->second;
}

Material first_sheet_material(const Study& study) {
  Material material;
  material.name = study.name;
  material.density = study.density;
  material.membrane = study.model.membrane;
  material.bending = study.model.bending;
  material.bending_of = "hinges";
  const bool springs = material.bending == "spring";
  const auto give = [&](const char* component, double stiffness) {
    material.components[component].stiffness = ScalarCurve::hermite(
        {0.0}, {fixed_stiffness(study.fit, {component}).value_or(stiffness)}, is_even(component));
  };
  for (const char* component : {"stretch.weft", "stretch.warp"}) give(component, 100);
  give("shear", 20);
  for (const char* component : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    give(component, springs ? 0.1 : 3e-6);
  }
  return material;
}

SheetFit fit_sheets(const Study& study, const std::vector<SheetStage>& plan,
                    const RunContext& context, const Material* start) {
  return Fitter(study, context).run(plan, start);
}

}  // namespace pliant
