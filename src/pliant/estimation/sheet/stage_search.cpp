#include "pliant/estimation/sheet/stage_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/sheet/sheet_journal.h"
#include "pliant/experiment/session/sheet_system.h"
#include "pliant/measurement/session/frame_measures.h"

namespace pliant {
namespace {

constexpr double kOutlierShare = 0.01;  // of strains, before the range is taken
constexpr int kNoiseRounds = 3;
constexpr double kNoiseSettled = 0.1;
constexpr LeastSquaresOptions kStageSearch{
    .max_iterations = 25, .function_tolerance = 1e-4, .parameter_tolerance = 1e-6};

/// A test of weft says nothing about the strains that warp has.
bool usually_strains(const SheetTest& test, const std::string& component) {
  const std::vector<std::string> usual = usual_components(test.session().test);
  const bool directed = component.ends_with(".weft") || component.ends_with(".warp");
  if (usual.empty() || !directed) return true;
  const auto family = [](const std::string& name) { return name.substr(0, name.find('.')); };
  return usual.front() == component || family(usual.front()) != family(component);
}

double strain_in(const SheetStage& stage, const SheetProblem& problem, const ComponentGroup& group,
                 int threads) {
  const Material material = problem.material_at(problem.start());
  std::vector<double> strains;
  for (std::size_t t = 0; t < stage.tests.size(); ++t) {
    const SheetTest& test = *stage.tests[t];
    const auto shapes = problem.predict(t, problem.start(), false, threads);
    if (!shapes) continue;
    const SheetSystem sheet(test.session(), material, {.friction = false}, {});
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
  const auto at = strains.begin() + static_cast<std::ptrdiff_t>(
                                        (1 - kOutlierShare) * static_cast<double>(strains.size()));
  std::ranges::nth_element(strains, at);
  return std::max(*at, 1e-9);
}

bool has_loop(const SheetStage& stage, const SheetProblem& problem, int threads) {
  constexpr double kChance = 4, kSmallest = 0.005;  // standard errors; of the forces
  double loop = 0, squares = 0, forces = 0;
  int rows = 0;
  for (std::size_t t = 0; t < stage.tests.size(); ++t) {
    const SheetTest& test = *stage.tests[t];
    const auto shapes = problem.predict(t, problem.start(), false, threads);
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

}  // namespace

bool is_about_positions(const SheetStage& stage) {
  return stage.tests.front()->objective() == SheetObjective::positions;
}

double accuracy_of(const SheetStage& stage) {
  constexpr double kForce = 1e-3, kPosition = 1e-5;  // N, m; a third of [T] 3.2.3 and less
  return is_about_positions(stage) ? kPosition : kForce;
}

std::string names_of(const std::vector<const SheetTest*>& tests) {
  std::vector<std::string> list;
  for (const SheetTest* test : tests) list.push_back(test->name());
  return fmt::format("{}", fmt::join(list, ", "));
}

StageSearch::Solution StageSearch::least(const SheetStage& stage, SheetProblem& problem) {
  const Numbers found = ask("search", stage, problem, [&] { return search(stage, problem); });
  const auto count = static_cast<Eigen::Index>(problem.unknowns().size());
  return {Eigen::VectorXd::Map(found.data(), count), found[found.size() - 2], found.back() > 0};
}

/// The unknowns, the root mean square of the differences (N or m), and whether it converged.
StageSearch::Numbers StageSearch::search(const SheetStage& stage, SheetProblem& problem) {
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
      throw SolverError("the equilibrium of every frame of " + names_of(stage.tests), 0, 0);
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

double StageSearch::cost_at_start(const SheetStage& stage, SheetProblem& problem, double others) {
  const auto cost = [&] {
    problem.set_noise(accuracy_of(stage));
    const LeastSquaresProblem squares = problem.least_squares();
    Eigen::VectorXd residual(squares.residuals);
    const bool found = squares.evaluate(problem.start(), residual, nullptr);
    const double own = found ? residual.squaredNorm() / 2 : INFINITY;
    if (own < others) keep_shapes(problem);
    return Numbers{own};
  };
  return ask("cost", stage, problem, cost).front();
}

double StageSearch::largest_strain(const SheetStage& stage, SheetProblem& problem,
                                   const ComponentGroup& group) {
  const auto strain = [&] { return Numbers{strain_in(stage, problem, group, context_.threads)}; };
  return ask("strain", stage, problem, strain).front();
}

bool StageSearch::shows_loop(const SheetStage& stage, SheetProblem& problem) {
  const auto loop = [&] { return Numbers{has_loop(stage, problem, context_.threads) ? 1.0 : 0.0}; };
  return ask("loop", stage, problem, loop).front() > 0;
}

std::vector<std::vector<int>> StageSearch::lost_frames(const SheetStage& stage,
                                                       SheetProblem& problem) {
  // For each test their number, then the frames.
  const auto find = [&] {
    Numbers numbers;
    for (std::size_t t = 0; t < stage.tests.size(); ++t) {
      const std::vector<int> lost = problem.lost_frames(t, context_.threads);
      numbers.push_back(static_cast<double>(lost.size()));
      numbers.insert(numbers.end(), lost.begin(), lost.end());
    }
    if (std::ranges::all_of(numbers, [](double count) { return count == 0; })) keep_shapes(problem);
    return numbers;
  };
  const Numbers found = ask("frames", stage, problem, find);
  std::vector<std::vector<int>> lost;
  for (std::size_t at = 0; at < found.size();) {
    const auto count = static_cast<std::size_t>(found[at]);
    const auto first = found.begin() + static_cast<std::ptrdiff_t>(at + 1);
    lost.emplace_back(first, first + static_cast<std::ptrdiff_t>(count));
    at += 1 + count;
  }
  return lost;
}

void StageSearch::keep_shapes(const SheetProblem& problem) {
  problem.keep(shapes_);
  pliant::keep_shapes(context_.journal, shapes_);
}

StageSearch::Numbers StageSearch::ask(const char* what, const SheetStage& stage,
                                      SheetProblem& problem, const std::function<Numbers()>& work) {
  std::vector<std::string> components;
  for (const ComponentGroup& group : stage.groups) components.push_back(group.front());
  const std::string question =
      fmt::format("{} of {} in {}", what, fmt::join(components, ", "), names_of(stage.tests));
  Numbers answer = context_.journal.answer(question, [&] {
    problem.begin_at(shapes_);
    Numbers found = work();
    const EquilibriumWork cost = problem.work();
    work_.seconds += cost.seconds;
    append_counts(cost.counts, found);
    return found;
  });
  work_.counts += take_counts(answer);
  return answer;
}

}  // namespace pliant
