#include "pliant/estimation/sheet/stage_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/limit_energies.h"
#include "pliant/estimation/sheet/independent_rows.h"
#include "pliant/estimation/sheet/sheet_journal.h"
#include "pliant/estimation/statistics/correlation_length.h"
#include "pliant/experiment/session/loop_evidence.h"

namespace pliant {
namespace {

constexpr double kOutlierShare = 0.01;  // of strains, before the range is taken
constexpr int kNoiseRounds = 3;
constexpr double kNoiseSettled = 0.1;
constexpr LeastSquaresOptions kStageSearch{
    .max_iterations = 25, .function_tolerance = 1e-4, .parameter_tolerance = 1e-6};

double strain_in(const SheetProblem& problem, const ComponentGroup& group, const Workers& workers) {
  std::vector<double> strains;
  for (const ProblemPart& part : problem.rows().parts()) {
    for (const std::string& component : group) {
      const std::vector<double> own =
          part.predictor->strains(component, part.predictor->values(), workers);
      strains.insert(strains.end(), own.begin(), own.end());
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

double energy_in(const SheetProblem& problem, const Material& material,
                 const std::vector<std::string>& components, const Workers& workers) {
  double most = 0;
  for (const ProblemPart& part : problem.rows().parts()) {
    std::vector<double> energies;  // of each triangle in each frame
    for (const std::string& component : components) {
      const ComponentLaw law = *law_of(material, component);
      const std::vector<double> strains =
          part.predictor->strains(component, part.predictor->values(), workers);
      const std::vector<double> own = energies_of_points(component, law, strains);
      energies.resize(std::max(energies.size(), own.size()), 0.0);
      std::ranges::transform(own, energies, energies.begin(), std::plus());
    }
    for (const double energy : energies) most = std::max(most, energy);
  }
  return most;
}

bool has_loop(const SheetStage& stage, const SheetProblem& problem) {
  LoopEvidence evidence;
  for (std::size_t t = 0; t < stage.tests.size(); ++t) {
    const auto rows = problem.rows().predict(t, problem.start(), /*derivatives=*/false);
    if (!rows) return true;
    evidence += loop_evidence(*stage.tests[t], rows->value);
  }
  return evidence.shows_loop();
}

double independent_rows_of(const SheetStage& stage, const SheetProblem& problem) {
  double count = 0;
  for (std::size_t t = 0; t < stage.tests.size(); ++t) {
    const auto rows = problem.rows().predict(t, problem.start(), /*derivatives=*/false);
    if (!rows) return 0;
    count += independent_rows(*stage.tests[t], rows->value - stage.tests[t]->measured());
  }
  return count;
}

/// How many rows count as one because their differences go together.
double rows_together(const SheetProblem& problem, const Eigen::VectorXd& values) {
  std::vector<ResidualSeries> series;
  const std::vector<ProblemPart>& parts = problem.rows().parts();
  for (std::size_t t = 0; t < parts.size(); ++t) {
    const auto rows = problem.rows().predict(t, values, /*derivatives=*/false);
    if (!rows) return 1;
    // Tests of several kinds share one length: their differences are told in their noise.
    const Experiment& test = *parts[t].experiment;
    const Eigen::VectorXd missed = parts[t].weight.cwiseProduct(rows->value - test.measured());
    for (const std::vector<int>& channel : test.series()) {
      ResidualSeries& own = series.emplace_back();
      for (const int row : channel) {
        if (parts[t].weight(row) > 0) own.push_back(missed(row));
      }
    }
  }
  return correlation_length(series, free_count(problem.unknowns()));
}

}  // namespace

bool is_about_positions(const SheetStage& stage) {
  return stage.tests.front()->objective() == SheetObjective::positions;
}

double accuracy_of(const SheetStage& stage) {
  constexpr double kShare = 1e-4;  // a mesh misses more
  double noise = INFINITY, size = 0;
  for (const SheetTest* test : stage.tests) {
    // The first test's kind is what differences are told in.
    const bool positions = test->objective() == SheetObjective::positions;
    if (positions != is_about_positions(stage)) continue;
    noise = std::min(noise, test->stated_noise().value_or(INFINITY));
    size = std::max(size, test->reference());
  }
  return std::isfinite(noise) ? noise : kShare * size;
}

std::string names_of(const std::vector<const SheetTest*>& tests) {
  std::vector<std::string> list;
  for (const SheetTest* test : tests) list.push_back(test->name());
  return fmt::format("{}", fmt::join(list, ", "));
}

std::string names_of(const std::vector<ComponentGroup>& groups) {
  std::vector<std::string> list;
  for (const ComponentGroup& group : groups) list.push_back(group.front());
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
  // Priors are weighed against the noise, which the residuals tell, as in the standard errors.
  const int rounds = problem.rows().priors().empty() ? 1 : kNoiseRounds;
  for (int round = 0; round < rounds; ++round) {
    problem.set_noise(noise);
    summary = solve_least_squares(with_journal(problem.least_squares(), context_.journal),
                                  summary.parameters, kStageSearch, context_.stop);
    if (!std::isfinite(summary.cost)) {
      throw SolverError(fmt::format("the equilibrium of every frame of {}, to which {} is fitted,",
                                    names_of(stage.tests), names_of(stage.groups)),
                        0, 0);
    }
    rms = problem.rms(summary);
    if (round + 1 == rounds) break;
    const double together = rows_together(problem, summary.parameters);
    const double before =
        std::exchange(noise, std::max(rms, accuracy_of(stage)) * std::sqrt(together));
    if (std::abs(noise - before) < kNoiseSettled * before) break;
  }
  keep_shapes(problem);
  Numbers found(summary.parameters.begin(), summary.parameters.end());
  found.push_back(rms);
  found.push_back(summary.converged ? 1 : 0);
  return found;
}

LeastSquaresSummary StageSearch::at_start(const SheetStage& stage, SheetProblem& problem,
                                          double others) {
  problem.set_noise(accuracy_of(stage));
  LeastSquaresSummary start{.parameters = problem.start()};
  const auto cost = [&] {
    const double own = cost_at(problem.least_squares(), start.parameters);
    if (own < others) keep_shapes(problem);
    return Numbers{own};
  };
  start.cost = ask("cost", stage, problem, cost).front();
  return start;
}

double StageSearch::largest_strain(const SheetStage& stage, SheetProblem& problem,
                                   const ComponentGroup& group) {
  const auto strain = [&] {
    return Numbers{strain_in(problem, group, {context_.threads, context_.stop})};
  };
  return ask("strain", stage, problem, strain).front();
}

double StageSearch::largest_energy(const SheetStage& stage, SheetProblem& problem,
                                   const Material& material,
                                   const std::vector<std::string>& components) {
  const auto energy = [&] {
    return Numbers{energy_in(problem, material, components, {context_.threads, context_.stop})};
  };
  return ask("energy", stage, problem, energy).front();
}

bool StageSearch::shows_loop(const SheetStage& stage, SheetProblem& problem) {
  const auto loop = [&] { return Numbers{has_loop(stage, problem) ? 1.0 : 0.0}; };
  return ask("loop", stage, problem, loop).front() > 0;
}

double StageSearch::independent_rows(const SheetStage& stage, SheetProblem& problem) {
  const auto count = [&] { return Numbers{independent_rows_of(stage, problem)}; };
  return ask("independent rows", stage, problem, count).front();
}

std::vector<std::vector<int>> StageSearch::lost_frames(const SheetStage& stage,
                                                       SheetProblem& problem) {
  // For each test their number, then the frames.
  const auto find = [&] {
    Numbers numbers;
    for (const ProblemPart& part : problem.rows().parts()) {
      const std::vector<int> lost =
          part.predictor->lost_frames(part.predictor->values(), {context_.threads, context_.stop});
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
  const std::string question =
      fmt::format("{} of {} in {}", what, names_of(stage.groups), names_of(stage.tests));
  Numbers answer = context_.journal.answer(question, [&] {
    problem.begin_at(shapes_);
    Numbers found = work();
    const EquilibriumWork cost = problem.rows().work();
    work_.seconds += cost.seconds;
    append_counts(cost.counts, found);
    return found;
  });
  work_.counts += take_counts(answer);
  return answer;
}

}  // namespace pliant
