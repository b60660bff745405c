#include "pliant/estimation/control_points.h"

#include <algorithm>
#include <cmath>

#include "pliant/estimation/linear_start.h"

namespace pliant {
namespace {

constexpr double kOutlierShare = 0.001;  // of the strains, before the range is taken
constexpr double kFromZero = 0.05;       // of the range: data that begins below it begins at zero
constexpr double kSmallestInterval = 0.02;  // of the range

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

}  // namespace

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
  if (strains.low >= strains.high) {  // of a few rows none is an outlier
    strains.low = strains.sorted.front();
    strains.high = strains.sorted.back();
  }
  const bool from_zero = even || strains.low < kFromZero * strains.high;
  if (from_zero || strains.low >= strains.high) strains.low = 0;
  return strains;
}

ComponentLaw on_knots(ComponentLaw form, const std::vector<double>& knots, bool even) {
  form.stiffness = ScalarCurve::hermite(knots, std::vector<double>(knots.size(), 0.0), even);
  return form;
}

std::vector<double> split_knots(const ComponentProblem& problem, const ComponentLaw& law,
                                const DataStrains& strains) {
  const bool even = law.stiffness.even();
  const std::vector<double>& knots = law.stiffness.knots();
  if (knots.size() == 1) return {strains.low, strains.high};
  const bool friction = law.friction_law != FrictionLaw::none;
  const double tau = friction ? law.friction[2] : 1;
  const double smallest = kSmallestInterval * (strains.high - strains.low);
  std::vector<double> best = knots;
  double best_cost = 1e300;
  for (size_t i = 0; i + 1 < knots.size(); ++i) {
    for (const double at :
         {(knots[i] + knots[i + 1]) / 2, median_between(strains.sorted, knots[i], knots[i + 1]),
          half_rise(law, knots[i], knots[i + 1])}) {
      if (at - knots[i] < smallest || knots[i + 1] - at < smallest) continue;
      std::vector<double> candidate = knots;
      candidate.insert(candidate.begin() + static_cast<std::ptrdiff_t>(i) + 1, at);
      const double cost = linear_start(problem, on_knots(law, candidate, even), tau).cost;
      if (cost < best_cost) {
        best_cost = cost;
        best = candidate;
      }
    }
  }
  return best;
}

ComponentLaw refined(const ComponentLaw& law, const std::vector<double>& knots) {
  ComponentLaw result = on_knots(law, knots, law.stiffness.even());
  std::vector<double> values;
  for (const double knot : knots) values.push_back(law.stiffness.value(knot));
  result.stiffness = result.stiffness.with_values(values.data());
  return result;
}

}  // namespace pliant
