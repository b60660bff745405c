#include "pliant/estimation/solid/limit_starts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

constexpr std::array kQuantilesOfLimits{0.2, 0.5, 0.8};
constexpr double kBeyond = 1.1;  // of the largest energy: the data tell of no limit
constexpr LeastSquaresOptions kTrial{
    .max_iterations = 25, .function_tolerance = 1e-4, .parameter_tolerance = 1e-4};

/// Energies of some components together at all rows of all experiments, rising.
std::vector<double> energies_of(const SolidProblem& problem, const Material& material,
                                const std::vector<std::string>& components) {
  std::vector<double> all;
  for (const Experiment* experiment : problem.experiments()) {
    const auto predictor = experiment->predictor(material);
    std::vector<double> energies(static_cast<std::size_t>(experiment->rows()), 0.0);
    for (const std::string& name : components) {
      const ComponentLaw law = *law_of(material, name);
      const std::vector<double> strains = predictor->strains(name, predictor->values(), {});
      const std::size_t each = strains.size() / std::max<std::size_t>(energies.size(), 1);
      for (std::size_t i = 0; i < each * energies.size(); ++i) {
        energies[i / each] += law.elastic_energy(strains[i]);
      }
    }
    all.insert(all.end(), energies.begin(), energies.end());
  }
  std::ranges::sort(all);
  return all;
}

std::vector<double> first_limits(const std::vector<double>& energies) {
  const double most = energies.back();
  std::vector<double> limits;
  for (const double quantile : kQuantilesOfLimits) {
    const double rank = quantile * static_cast<double>(energies.size() - 1);
    const double limit = energies[static_cast<std::size_t>(rank)];
    if (limit > 1e-6 * most) limits.push_back(limit);
  }
  limits.push_back(kBeyond * most);
  return limits;
}

}  // namespace

LeastSquaresSummary add_limits(SolidProblem& problem,
                               const std::vector<std::vector<std::string>>& limits,
                               const Material& first, Material& material,
                               const LeastSquaresSummary& fitted) {
  if (limits.empty()) return fitted;
  for (const std::vector<std::string>& components : limits) {
    Material base = material;
    std::vector<double> energies = energies_of(problem, base, components);
    if (energies.empty() || energies.back() <= 0) {
      base = first;
      base.limits = material.limits;
      energies = energies_of(problem, base, components);
    }
    double least = INFINITY;
    for (const double limit : energies.empty() ? energies : first_limits(energies)) {
      Material trial = base;
      trial.limits.push_back({components, limit});
      const double cost = problem.solve(trial, kTrial).cost;
      if (!(cost < least)) continue;
      least = cost;
      material = trial;
    }
    if (!std::isfinite(least)) throw SolverError("the limit " + limit_name(components), 0, 0);
  }
  return problem.solve(material);
}

}  // namespace pliant
