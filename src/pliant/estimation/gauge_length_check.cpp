#include "pliant/estimation/gauge_length_check.h"

#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/estimation/law_fit.h"

namespace pliant {
namespace {

/// A fit whose solution is that of another, with numbers of one experiment beside it that begin at
/// zero.
/// @param before  how many unknowns stand before the new ones
LawFit with_more_unknowns(const LawFit& fit, Eigen::Index before,
                          const std::vector<Unknown>& more) {
  LawFit freed = fit;
  freed.unknowns.insert(freed.unknowns.begin() + before, more.begin(), more.end());
  Eigen::VectorXd& values = freed.solution.parameters;
  const Eigen::Index after = values.size() - before;
  values.resize(values.size() + static_cast<Eigen::Index>(more.size()));
  values << fit.solution.parameters.head(before),
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(more.size())),
      fit.solution.parameters.tail(after);
  return freed;
}

/// Weighted sum of the squares that a law misses of an experiment.
double missed(const ComponentExperiment& experiment, const Eigen::VectorXd& weight,
              const LawFit& fit, Eigen::Index first) {
  const auto count = static_cast<Eigen::Index>(experiment.nuisance().size());
  const auto prediction =
      experiment.predict(fit.law, fit.nuisance.segment(first, count), /*with_jacobian=*/false);
  if (!prediction) return INFINITY;
  return weight.cwiseProduct(prediction->value - experiment.measured()).squaredNorm();
}

/// How much longer the specimens of an experiment are than stated, where that explains much.
std::optional<double> better_length(const ComponentProblem& problem, const ComponentFit& fit,
                                    std::size_t e) {
  constexpr double kLeft = 2.0 / 3;  // of what is missed
  std::vector<const ComponentExperiment*> experiments = problem.experiments();
  const ComponentExperiment& stated = *experiments[e];
  const std::unique_ptr<ComponentExperiment> free = stated.with_free_length();
  if (!free) return std::nullopt;
  experiments[e] = free.get();
  ComponentProblem freed(experiments, problem.stop(), problem.loss(), problem.journal());
  freed.take_noise(fit.uncertainty.noise);

  const auto count = static_cast<Eigen::Index>(stated.nuisance().size());
  const Eigen::Index first = problem.first_nuisance(e);
  const std::vector<Unknown> own = unknowns_of(*free);
  const std::vector<Unknown> lengths(own.begin() + count, own.end());
  const LawFit again = refit(
      freed, with_more_unknowns(fit.fit, fit.fit.law.parameter_count() + first + count, lengths));
  const Eigen::VectorXd& weight = fit.uncertainty.noise.weight[e];
  if (missed(*free, weight, again, first) > kLeft * missed(stated, weight, fit.fit, first)) {
    return std::nullopt;
  }
  return again.nuisance.segment(first + count, static_cast<Eigen::Index>(lengths.size())).mean();
}

}  // namespace

std::vector<std::string> gauge_length_warnings(const ComponentProblem& problem,
                                               const ComponentFit& fit) {
  constexpr double kMatters = 1e-4;  // m
  std::vector<std::string> warnings;
  for (std::size_t e = 0; e < problem.experiments().size(); ++e) {
    const auto longer = better_length(problem, fit, e);
    if (!longer || std::abs(*longer) < kMatters) continue;
    warnings.push_back(fmt::format(
        "{}: the data contradict the stated gauge length: a third of the misfit or more goes with "
        "a specimen that is {} {}; measure it again, or look for it (`rest_length: unknown`)",
        problem.experiments()[e]->info().name,
        format_quantity(std::abs(*longer), Dimension::length, 2),
        *longer > 0 ? "longer" : "shorter"));
  }
  return warnings;
}

}  // namespace pliant
