#include "pliant/estimation/solid/solid_problem.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/estimation/measured_noise.h"
#include "pliant/estimation/sampled_numbers.h"
#include "pliant/experiment/row_times.h"
#include "pliant/material/addend/rubber_addends.h"
#include "pliant/material/solid/metric.h"
#include "pliant/material/solid/pair_metric.h"
#include "pliant/material/solid/standard_solids.h"

namespace pliant {
namespace {

constexpr double kShare = 0.01;  // of the largest stress: the unit of differences

/// A solid whose stretches across are near those of any solid.
Material probe(double stress) { return neo_hookean_solid(stress, 100 * stress); }

/// An energy that is a line alone, on a metric that is never negative, must not fall: it would have
/// no lower bound.
void keep_positive(const std::string& component, const ComponentLaw& law,
                   std::vector<Unknown>& unknowns) {
  const StrainMetric* metric = find_strain_metric(component);
  if (!metric || !metric->never_negative) return;
  const bool is_line = law.parameter_count() == 1 && law.addends.size() == 1 &&
                       &law.addends.front().kind() == &linear_addend();
  if (is_line) unknowns.front().lower = 0;
}

/// A volume that nothing resists has no equilibrium, in which searches would lose themselves.
void keep_volume_stiff(const ComponentLaw& law, const DataScale& pulled,
                       std::vector<Unknown>& unknowns) {
  constexpr double kLeast = 1e-3;  // of the stiffness of what is pulled
  for (int i = 0; i < law.stiffness.size(); ++i) {
    unknowns[static_cast<std::size_t>(i)].lower = kLeast * pulled.stress / pulled.strain;
  }
}

double unit_of(const Experiment& experiment) {
  return experiment.info().stated_noise().value_or(kShare * experiment.reference());
}

}  // namespace

bool MetricData::is_seen() const {
  constexpr double kNothing = 1e-9;  // what rounding leaves of a volume that stays
  return !strains.empty() && std::max(std::abs(low()), std::abs(high())) > kNothing;
}

SolidProblem::SolidProblem(const FitSettings& settings, std::vector<const Experiment*> experiments,
                           const RunContext& context)
    : settings_(settings), experiments_(std::move(experiments)), context_(context) {
  double reach = 0, peak = 0, seconds = 0;
  for (const Experiment* experiment : experiments_) {
    peak = std::max(peak, experiment->stress());
    seconds = std::max(seconds, duration_of(experiment->info()));
    probes_.push_back(experiment->predictor(probe(experiment->stress())));
  }
  for (const double strain : strains_of("fibre.x")) reach = std::max(reach, std::abs(strain));
  energy_ = peak * reach;
  if (seconds > 0) seconds_ = seconds;
}

int SolidProblem::rows() const {
  double rows = 0;
  for (const Experiment* experiment : experiments_) rows += experiment->weights().sum();
  return static_cast<int>(rows);
}

std::vector<double> SolidProblem::strains_of(const std::string& metric) {
  std::vector<double> all;
  for (const auto& predictor : probes_) {
    const std::vector<double> own = predictor->strains(metric, predictor->values(), {});
    all.insert(all.end(), own.begin(), own.end());
  }
  std::ranges::sort(all);
  return all;
}

const MetricData& SolidProblem::data_of(const std::string& metric) {
  const auto known = data_.find(metric);
  if (known != data_.end()) return known->second;
  MetricData& data = data_[metric];
  data.strains = strains_of(metric);
  if (!data.is_seen()) return data;
  data.scale.strain = std::max(std::abs(data.low()), std::abs(data.high()));
  data.scale.stress = energy_ / data.scale.strain;
  data.scale.seconds = seconds_;
  return data;
}

Problem SolidProblem::problem(const Material& material) {
  std::vector<ProblemPart> parts;
  for (const Experiment* experiment : experiments_) {
    ProblemPart part{experiment, experiment->predictor(material)};
    part.unit = unit_of(*experiment);
    parts.push_back(std::move(part));
  }
  std::vector<Unknown> unknowns;
  for (const std::string& name : ordered_components(material.components, material.kind)) {
    const auto law = law_of(material, name);
    if (!law) continue;
    std::vector<Unknown> own = unknowns_of(*law, {name}, data_of(name).scale);
    keep_positive(name, *law, own);
    if (is_of_volume(name)) keep_volume_stiff(*law, data_of("fibre.x").scale, own);
    append_unknowns(material, {name}, own, unknowns);
  }
  for (const EnergyLimit& limit : material.limits) {
    unknowns.push_back(unknown_of(limit, material.kind));
  }
  apply_options(settings_.fit, unknowns);
  Problem problem(std::move(parts), std::move(unknowns), {context_.threads, context_.stop});
  problem.set_loss(settings_.fit.loss);
  for (std::size_t p = 0; p < experiments_.size(); ++p) {
    const double each = problem.emphasis(p) / *problem.parts()[p].unit;
    problem.set_weight(p, by_loss_.empty() ? experiments_[p]->weights() * each : by_loss_[p]);
  }
  return problem;
}

double SolidProblem::count_by_loss(const Material& material) {
  const Problem own = problem(material);
  const MeasuredNoise noise = measure_noise(own, starts_of(own.unknowns()));
  double change = 0;
  for (std::size_t p = 0; p < experiments_.size(); ++p) {
    const Eigen::VectorXd& before = own.parts()[p].weight;
    change = std::max(change, (noise.weight[p] - before).norm() / before.norm());
  }
  by_loss_ = noise.weight;
  return change;
}

LeastSquaresSummary SolidProblem::solve_convex(const Material& material,
                                               const LeastSquaresProblem& search,
                                               const Eigen::VectorXd& start,
                                               const LeastSquaresOptions& options) {
  const StopToken& stop = context_.stop;
  if (settings_.fit.convexity == Convexity::free) {
    return solve_least_squares(search, start, options, stop);
  }
  std::vector<PairDomain> domains;
  for (const auto& [pair, domain] : pair_domains(material)) domains.push_back(domain);
  const ConvexSet set = convex_numbers(material, domains);
  const bool published = settings_.fit.convexity == Convexity::projected;
  const bool is_bounded = set.rows.rows() == 0 && !set.violated;
  if (published && !is_bounded) return solve_projected(set, search, start, options, stop);
  return solve_within(set, search, start, options, stop);
}

std::map<std::string, PairDomain> SolidProblem::pair_domains(const Material& material) {
  std::map<std::string, PairDomain> domains;
  for (const auto& [name, component] : material.components) {
    const auto pair = find_pair_metric(name);
    if (!pair) continue;
    PairDomain& domain = domains[fmt::format("{}", fmt::join(pair->of(), " and "))];
    domain.strains = pair->strains;
    for (std::size_t side = 0; side < 2; ++side) {
      const MetricData& data = data_of(pair->of()[side]);
      domain.range[side] = {std::min(data.low(), 0.0), std::max(data.high(), 0.0)};
    }
  }
  return domains;
}

// Bodies have equilibria side by side, and a search goes on from those that it stands at: what
// counts is where a body comes to from rest.
LeastSquaresSummary SolidProblem::solve(Material& material, const LeastSquaresOptions& options) {
  constexpr double kAlike = 1e-12;  // of a row: a millionth of its weight
  const Problem own = problem(material);
  const LeastSquaresProblem search = own.least_squares();
  const Eigen::VectorXd start = starts_of(own.unknowns());
  LeastSquaresSummary end = solve_convex(material, search, start, options);
  if (!std::isfinite(end.cost)) return end;
  Material found = material;
  set_numbers(end.parameters, found);
  const double walked = cost_at(problem(found).least_squares(), end.parameters);
  if (walked > end.cost + kAlike * rows()) {
    const double before = cost_at(problem(material).least_squares(), start);
    if (walked > before) {
      return {
          .parameters = start, .cost = before, .converged = false, .iterations = end.iterations};
    }
  }
  end.cost = walked;
  material = std::move(found);
  return end;
}

void set_numbers(const Eigen::VectorXd& numbers, Material& material) {
  Eigen::Index next = 0;
  for (const std::string& name : ordered_components(material.components, material.kind)) {
    if (law_of(material, name)) next = set_numbers(numbers, next, {name}, material);
  }
  for (EnergyLimit& limit : material.limits) limit.energy = numbers(next++);
}

double rms_of(const LeastSquaresSummary& solution, int rows) {
  return std::sqrt(2 * solution.cost / std::max(rows, 1));
}

}  // namespace pliant
