#include "pliant/estimation/solid/limit_starts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <span>

#include "pliant/base/errors.h"
#include "pliant/estimation/limit_energies.h"

namespace pliant {
namespace {

constexpr std::array kQuantilesOfLimits{0.2, 0.5, 0.8};
constexpr std::array kSharesOfLimits{0.9, 0.6, 0.4};
constexpr double kBeyond = 1.1;  // of the largest energy: the data tell of no limit
constexpr LeastSquaresOptions kTrial{
    .max_iterations = 25, .function_tolerance = 1e-4, .parameter_tolerance = 1e-4};

/// The largest energy of some components together at each row of an experiment. Volumes of nodes
/// are no points of elements: of both the largest energies are added.
std::vector<double> energies_of_rows(const Experiment& experiment, const Material& material,
                                     const std::vector<std::string>& components, bool& of_body) {
  const auto predictor = experiment.predictor(material);
  const auto rows = static_cast<std::size_t>(experiment.rows());
  std::vector<std::map<std::size_t, std::vector<double>>> by_points(rows);
  for (const std::string& name : components) {
    const ComponentLaw law = *law_of(material, name);
    const std::vector<double> strains = predictor->strains(name, predictor->values(), {});
    const std::size_t each = strains.size() / rows;
    for (std::size_t row = 0; row < rows && each > 0; ++row) {
      const auto own = energies_of_points(name, law, std::span(strains).subspan(row * each, each));
      std::vector<double>& sums = by_points[row][own.size()];
      sums.resize(own.size(), 0.0);
      of_body |= own.size() > 1;
      std::ranges::transform(sums, own, sums.begin(), std::plus());
    }
  }
  std::vector<double> energies;
  for (const auto& row : by_points) {
    double most = 0;
    for (const auto& [count, sums] : row) most += std::ranges::max(sums);
    energies.push_back(most);
  }
  return energies;
}

/// What energies of some components experiments reach.
struct ReachedEnergies {
  std::vector<double> of_rows;  ///< rising
  bool of_bodies = false;       ///< whether a row has many points
};

ReachedEnergies energies_of(const SolidProblem& problem, const Material& material,
                            const std::vector<std::string>& components) {
  ReachedEnergies reached;
  for (const Experiment* experiment : problem.experiments()) {
    const std::vector<double> own =
        energies_of_rows(*experiment, material, components, reached.of_bodies);
    reached.of_rows.insert(reached.of_rows.end(), own.begin(), own.end());
  }
  std::ranges::sort(reached.of_rows);
  return reached;
}

/// A homogeneous row is at its limit or not; of a body ever more points are, of which each holds
/// back what is around it: its limit comes down from the largest energies.
std::vector<double> first_limits(const ReachedEnergies& reached) {
  const std::vector<double>& energies = reached.of_rows;
  const double most = energies.back();
  std::vector<double> limits{kBeyond * most};
  if (reached.of_bodies) {
    for (const double share : kSharesOfLimits) limits.push_back(share * most);
    return limits;
  }
  for (const double quantile : kQuantilesOfLimits) {
    const double rank = quantile * static_cast<double>(energies.size() - 1);
    const double limit = energies[static_cast<std::size_t>(rank)];
    if (limit > 1e-6 * most) limits.push_back(limit);
  }
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
    ReachedEnergies reached = energies_of(problem, base, components);
    if (reached.of_rows.back() <= 0) {
      base = first;
      base.limits = material.limits;
      reached = energies_of(problem, base, components);
    }
    double least = INFINITY;
    for (const double limit : first_limits(reached)) {
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
