#include "pliant/estimation/control_points.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "pliant/estimation/linear_start.h"
#include "pliant/estimation/statistics/correlation_length.h"
#include "pliant/estimation/statistics/model_growth.h"
#include "pliant/experiment/loop_metrics.h"
#include "pliant/material/material.h"

namespace pliant {
namespace {

constexpr double kExact = 1e-6;          // of the noise first assumed: as good as none
constexpr double kOutlierShare = 0.001;  // of the strains, before the range is taken
constexpr double kFromZero = 0.05;       // of the range: data that begins below it begins at zero
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
  if (strains.low >= strains.high) {  // of a few rows none is an outlier
    strains.low = strains.sorted.front();
    strains.high = strains.sorted.back();
  }
  const bool from_zero = even || strains.low < kFromZero * strains.high;
  if (from_zero || strains.low >= strains.high) strains.low = 0;
  return strains;
}

// A law with a stiffness on some knots, for the rest of the form of another.
ComponentLaw on_knots(ComponentLaw form, const std::vector<double>& knots, bool even) {
  form.stiffness = ScalarCurve::hermite(knots, std::vector<double>(knots.size(), 0.0), even);
  return form;
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
      const double cost = linear_start(problem, on_knots(fit.law, candidate, even), tau).cost;
      if (cost < best_cost) {
        best_cost = cost;
        best = candidate;
      }
    }
  }
  return best;
}

// The same law with its curve on more knots: where the next fit may start.
ComponentLaw refined(const ComponentLaw& law, const ScalarCurve& finer) {
  ComponentLaw result = law;
  std::vector<double> values;
  for (const double knot : finer.knots()) values.push_back(law.stiffness.value(knot));
  result.stiffness = finer.with_values(values.data());
  return result;
}

// Of the weighted residuals of the rows that count, priors left out.
double mean_square(const ComponentProblem& problem, const LawFit& fit) {
  return 2 * fit.solution.cost / problem.used_rows();
}

bool has_loops(const ComponentProblem& problem) {
  return std::ranges::any_of(problem.experiments(),
                             [](const auto* experiment) { return unloads(experiment->path()); });
}

// A law with as many points as there may be, found without iteration.
ComponentLaw rich_law(const ComponentProblem& problem, const DataStrains& strains,
                      const ComponentLaw& form, const FitOptions& options, bool even) {
  std::vector<double> knots;
  for (int i = 0; i < options.control_points; ++i) {
    const double share = i / std::max(options.control_points - 1.0, 1.0);
    knots.push_back(strains.low + share * (strains.high - strains.low));
  }
  return linear_starts(problem, on_knots(form, knots, even), 1).front().law;
}

// How many of an experiment's rows are independent as far as noise goes. What a law misses smoothly
// along a half cycle is no noise and must not hide what a richer law would tell: a cubic takes it
// out of each half cycle that has rows for that.
double independent_rows(const Experiment& experiment, Eigen::VectorXd residual,
                        const std::vector<char>& used) {
  constexpr int kTerms = 4, kRowsPerTerm = 4;
  double leverage = 0;
  for (const Frame& frame : experiment.frames()) {
    if (frame.count < kTerms * kRowsPerTerm) continue;
    const Eigen::ArrayXd x = Eigen::ArrayXd::LinSpaced(frame.count, -1, 1);
    Eigen::MatrixXd powers(frame.count, kTerms);
    for (int k = 0; k < kTerms; ++k) powers.col(k) = x.pow(k);
    const auto rows = residual.segment(frame.first, frame.count);
    residual.segment(frame.first, frame.count) =
        rows - powers * powers.householderQr().solve(Eigen::VectorXd(rows));
    leverage += kTerms;
  }
  std::vector<ResidualSeries> series;
  double rows = 0;
  for (const std::vector<int>& channel : experiment.series()) {
    ResidualSeries& own = series.emplace_back();
    for (const int row : channel) {
      if (used[static_cast<size_t>(row)]) own.push_back(residual(row));
    }
    rows += static_cast<double>(own.size());
  }
  return rows / correlation_length(series, leverage);
}

// What a law leaves of the rows.
struct Leftover {
  double mean_square = 0;  // of the weighted residuals
  double rows = 0;         // that are independent
};

// Nothing where the law cannot carry the loads.
std::optional<Leftover> leftover(const ComponentProblem& problem, const ComponentLaw& law,
                                 const FitOptions& options) {
  const std::vector<Unknown> unknowns = problem.unknowns(law, options);
  const Problem rows = problem.problem(law, unknowns);
  Leftover sum;
  for (size_t e = 0; e < problem.experiments().size(); ++e) {
    const ComponentExperiment& experiment = *problem.experiments()[e];
    const auto predicted = rows.predict(e, starts_of(unknowns), /*derivatives=*/false);
    if (!predicted) return std::nullopt;
    const Eigen::VectorXd residual = predicted->value - experiment.measured();
    sum.rows += independent_rows(experiment, residual, problem.used(e));
    sum.mean_square += rows.parts()[e].weight.cwiseProduct(residual).squaredNorm();
  }
  sum.mean_square /= problem.used_rows();
  return sum;
}

// What growth judges by.
struct Measure {
  double rows = 0;  // that are independent
  double unexplained =
      0;             // mean square that no curve explains: the loops of a law without friction
  double least = 0;  // mean square that the richest law leaves
};

Measure measure_of_growth(const ComponentProblem& problem, const DataStrains& strains,
                          const ComponentLaw& form, const FitOptions& options, bool even) {
  const bool loops = has_loops(problem);
  ComponentLaw richest = form;
  richest.friction_law = loops ? FrictionLaw::dahl : FrictionLaw::none;
  const auto rich = leftover(problem, rich_law(problem, strains, richest, options, even), options);
  Measure measure{static_cast<double>(problem.used_rows())};
  if (!rich) return measure;
  measure.rows = rich->rows;
  if (!loops || form.remembers()) return measure;
  const auto elastic = leftover(problem, rich_law(problem, strains, form, options, even), options);
  if (!elastic) return measure;
  measure.unexplained = std::max(elastic->mean_square - rich->mean_square, 0.0);
  measure.least = rich->mean_square;
  return measure;
}

}  // namespace

GrownFit grow_stiffness(const ComponentProblem& problem, const ComponentLaw& form,
                        const FitOptions& options) {
  const bool even = is_even(component_of(problem));
  const DataStrains strains = data_strains(problem, even);
  const Measure measure = measure_of_growth(problem, strains, form, options, even);
  std::vector<LawFit> fits;  // of one point, of two, ...
  const auto fit_of = [&](int points) -> std::optional<FittedModel> {
    if (points == 1) {
      const std::vector<double> first{even ? 0.0 : strains.high};
      fits.push_back(fit_law(problem, on_knots(form, first, even), options));
    } else {
      const std::vector<double> knots = split(problem, fits.back(), strains, even);
      if (static_cast<int>(knots.size()) != points) return std::nullopt;
      const ComponentLaw shape = on_knots(form, knots, even);
      fits.push_back(fit_law(problem, shape, options, {refined(fits.back().law, shape.stiffness)}));
    }
    const LawFit& fit = fits.back();
    const double explicable =
        std::max(mean_square(problem, fit) - measure.unexplained, measure.least);
    return FittedModel{std::sqrt(explicable), free_count(fit.unknowns), std::max(points - 2, 0),
                       measure.rows};
  };
  const Growth growth = grow_model(1, options.control_points, fit_of, kExact);
  GrownFit grown;
  for (const GrowthStep& step : growth.steps) {
    const LawFit& fit = fits[static_cast<std::size_t>(step.points) - 1];
    grown.stages.push_back({step.points, fit.rms, step.accepted});
  }
  grown.fit = fits[static_cast<std::size_t>(growth.points) - 1];
  return grown;
}

}  // namespace pliant
