#include "pliant/estimation/control_points.h"

#include <algorithm>
#include <cmath>

#include "pliant/estimation/linear_start.h"
#include "pliant/material/material.h"

namespace pliant {
namespace {

constexpr double kWorthwhileFall = 0.01;  // [T] 3.4.2
constexpr double kOutlierShare = 0.001;   // of the strains, before the range is taken
constexpr double kFromZero = 0.05;        // of the range: data that begins below it begins at zero
constexpr double kSmallestInterval = 0.02;  // of the range

struct DataStrains {
  std::vector<double> sorted;  // of used rows, negative ones (slack) left out
  double low = 0;
  double high = 0;
};

DataStrains data_strains(const ComponentProblem& problem, bool even) {
  DataStrains strains;
  for (size_t e = 0; e < problem.experiments().size(); ++e) {
    const MeasuredPath& path = problem.experiments()[e]->path();
    for (size_t i = 0; i < path.strain.size(); ++i) {
      if (!problem.used(e)[i]) continue;
      const double strain = even ? std::abs(path.strain[i]) : path.strain[i];
      if (strain >= 0) strains.sorted.push_back(strain);
    }
  }
  std::sort(strains.sorted.begin(), strains.sorted.end());
  if (strains.sorted.empty()) strains.sorted.push_back(problem.largest_strain());
  const auto last = static_cast<double>(strains.sorted.size() - 1);
  strains.high = strains.sorted[static_cast<size_t>(std::floor(last * (1 - kOutlierShare)))];
  strains.low = strains.sorted[static_cast<size_t>(std::ceil(last * kOutlierShare))];
  if (even || strains.low < kFromZero * strains.high) strains.low = 0;
  return strains;
}

ComponentLaw shape_of(const std::vector<double>& knots, FrictionLaw friction, bool even) {
  return {ScalarCurve::hermite(knots, std::vector<double>(knots.size(), 0.0), even), friction, {}};
}

double median_between(const std::vector<double>& sorted, double low, double high) {
  const auto first = std::lower_bound(sorted.begin(), sorted.end(), low);
  const auto last = std::upper_bound(sorted.begin(), sorted.end(), high);
  return first == last ? (low + high) / 2 : *(first + (last - first) / 2);
}

// Strain at which the elastic stress has done half of its rise over an interval.
double half_rise(const ComponentLaw& law, double low, double high) {
  const double target = (law.elastic_stress(low) + law.elastic_stress(high)) / 2;
  for (int i = 1; i < 64; ++i) {
    const double strain = low + (high - low) * i / 64;
    if (law.elastic_stress(strain) >= target) return strain;
  }
  return (low + high) / 2;
}

// The knots with one more, where it explains most.
std::vector<double> split(const ComponentProblem& problem, const LawFit& fit,
                          const DataStrains& strains, bool even) {
  const std::vector<double>& knots = fit.law.stiffness.knots();
  if (knots.size() == 1) return {strains.low, strains.high};
  const bool friction = fit.law.friction_law != FrictionLaw::none;
  const double tau = friction ? fit.law.friction[2] : 1;
  const double smallest = kSmallestInterval * (strains.high - strains.low);
  std::vector<double> best = knots;
  double best_cost = 1e300;
  for (size_t i = 0; i + 1 < knots.size(); ++i) {
    for (const double at :
         {(knots[i] + knots[i + 1]) / 2, median_between(strains.sorted, knots[i], knots[i + 1]),
          half_rise(fit.law, knots[i], knots[i + 1])}) {
      if (at - knots[i] < smallest || knots[i + 1] - at < smallest) continue;
      std::vector<double> candidate = knots;
      candidate.insert(candidate.begin() + static_cast<std::ptrdiff_t>(i) + 1, at);
      const double cost =
          linear_start(problem, shape_of(candidate, fit.law.friction_law, even), tau).cost;
      if (cost < best_cost) {
        best_cost = cost;
        best = candidate;
      }
    }
  }
  return best;
}

// The same curve and friction on more knots: where the next fit may start.
ComponentLaw on_knots(const LawFit& fit, const ComponentLaw& shape) {
  ComponentLaw law = shape;
  std::vector<double> values;
  for (const double knot : shape.stiffness.knots()) values.push_back(fit.law.stiffness.value(knot));
  law.stiffness = shape.stiffness.with_values(values.data());
  law.friction = fit.law.friction;
  return law;
}

}  // namespace

GrownFit grow_stiffness(const ComponentProblem& problem, FrictionLaw friction,
                        const FitOptions& options, const StopToken& stop) {
  const bool even = is_even(component_of(problem));
  const DataStrains strains = data_strains(problem, even);
  const std::vector<double> first{even ? 0.0 : strains.high};
  GrownFit grown;
  grown.fit = fit_law(problem, shape_of(first, friction, even), options, stop);
  grown.stages.push_back({1, grown.fit.rms, true});
  // One point more may do nothing where two do: a curve that falls and rises again. So growth goes
  // on from a useless point once, and ends at the second in a row.
  LawFit latest = grown.fit;
  int useless = 0;
  for (int points = 2; points <= options.control_points && useless < 2; ++points) {
    const std::vector<double> knots = split(problem, latest, strains, even);
    if (static_cast<int>(knots.size()) != points) break;
    const ComponentLaw shape = shape_of(knots, friction, even);
    latest = fit_law(problem, shape, options, stop, {on_knots(latest, shape)});
    const bool worthwhile = latest.rms < (1 - kWorthwhileFall) * grown.fit.rms;
    grown.stages.push_back({points, latest.rms, worthwhile});
    useless = worthwhile ? 0 : useless + 1;
    if (worthwhile) grown.fit = latest;
  }
  return grown;
}

}  // namespace pliant
