#include "pliant/estimation/growth_measure.h"

#include <algorithm>
#include <optional>

#include <Eigen/QR>

#include "pliant/estimation/linear_start.h"
#include "pliant/estimation/statistics/correlation_length.h"
#include "pliant/experiment/loop_metrics.h"

namespace pliant {
namespace {

// A law with many points, found without iteration.
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

}  // namespace

GrowthMeasure measure_of_growth(const ComponentProblem& problem, const DataStrains& strains,
                                const ComponentLaw& form, const FitOptions& options, bool even) {
  const bool loops = any_unloads(problem.experiments());
  ComponentLaw richest = form;
  richest.friction_law = loops ? FrictionLaw::dahl : FrictionLaw::none;
  const auto rich = leftover(problem, rich_law(problem, strains, richest, options, even), options);
  GrowthMeasure measure{static_cast<double>(problem.used_rows())};
  if (!rich) return measure;
  measure.rows = rich->rows;
  if (!loops || form.remembers()) return measure;
  const auto elastic = leftover(problem, rich_law(problem, strains, form, options, even), options);
  if (!elastic) return measure;
  measure.unexplained = std::max(elastic->mean_square - rich->mean_square, 0.0);
  measure.least = rich->mean_square;
  return measure;
}

}  // namespace pliant
