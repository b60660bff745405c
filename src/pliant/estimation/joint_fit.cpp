#include "pliant/estimation/joint_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/base/errors.h"
#include "pliant/estimation/fit_journal.h"

namespace pliant {
namespace {

constexpr int kNoiseRounds = 60;
constexpr double kNoiseSettled = 1e-4;
constexpr LeastSquaresOptions kSearch{
    .max_iterations = 30, .function_tolerance = 1e-10, .parameter_tolerance = 1e-8};

Problem problem_of(const JointProblem& joint, const RunContext& context) {
  std::vector<ProblemPart> parts;
  for (const Experiment* experiment : joint.experiments) {
    parts.push_back({experiment, experiment->predictor(joint.material)});
  }
  Problem problem(std::move(parts), joint.unknowns, {context.threads, context.stop});
  problem.set_not_negative(joint.not_negative);
  problem.set_loss(joint.loss);
  return problem;
}

/// First each experiment counts by its range: noise that is told where one of them was fitted alone
/// would keep the others from telling anything.
void weigh_alike(Problem& problem) {
  constexpr double kShare = 0.01;
  for (std::size_t p = 0; p < problem.parts().size(); ++p) {
    const Experiment& experiment = *problem.parts()[p].experiment;
    problem.set_weight(
        p, experiment.weights() * problem.emphasis(p) / (kShare * experiment.reference()));
  }
}

/// @return the largest relative change of an experiment's weight
double weigh(const Eigen::VectorXd& values, Problem& problem) {
  const MeasuredNoise noise = measure_noise(problem, values);
  double change = 0;
  for (std::size_t p = 0; p < noise.weight.size(); ++p) {
    const double before = problem.parts()[p].weight.norm();
    change = std::max(change, std::abs(noise.weight[p].norm() / before - 1));
    problem.set_weight(p, noise.weight[p]);
  }
  return change;
}

LeastSquaresSummary search(Problem& problem, const StopToken& stop) {
  LeastSquaresSummary found;
  found.parameters = starts_of(problem.unknowns());
  weigh_alike(problem);
  for (int round = 0; round < kNoiseRounds; ++round) {
    if (round > 0 && weigh(found.parameters, problem) < kNoiseSettled) break;
    found = solve_least_squares(problem.least_squares(), found.parameters, kSearch, stop);
    if (!std::isfinite(found.cost)) {
      throw SolverError("the joint prediction of all experiments", found.iterations, 0);
    }
  }
  return found;
}

}  // namespace

JointFit fit_jointly(const JointProblem& joint, const RunContext& context) {
  ProgressTask task(context.progress, "fit together", 2);
  JointFit fit;
  const LeastSquaresSummary found = answered(context.journal, "fit of everything together", [&] {
    Problem problem = problem_of(joint, context);
    LeastSquaresSummary end = search(problem, context.stop);
    fit.work += problem.work();
    return end;
  });
  task.advance(1);
  fit.values = found.parameters;
  fit.converged = found.converged;
  // Anew, so that a fit that was stopped and one that was not find the same equilibria.
  const Problem problem = problem_of(joint, context);
  fit.uncertainty = uncertainty_of(problem, fit.values);
  fit.rms = std::sqrt(2 * found.cost / std::max(problem.rows(), 1));
  fit.work += problem.work();
  return fit;
}

}  // namespace pliant
