#include "pliant/estimation/solid/effective_rows.h"

#include <vector>

#include "pliant/estimation/solid/linearised_problem.h"
#include "pliant/estimation/statistics/correlation_length.h"

namespace pliant {
namespace {

double length_of(const Experiment& experiment, const Eigen::VectorXd& predicted) {
  const Eigen::ArrayXd weights = experiment.weights();
  std::vector<ResidualSeries> series;
  for (const std::vector<int>& rows : experiment.series()) {
    ResidualSeries& own = series.emplace_back();
    for (const int row : rows) {
      if (weights(row) > 0) own.push_back(predicted(row) - experiment.measured()(row));
    }
  }
  return correlation_length(series, /*leverage=*/0);
}

}  // namespace

double effective_rows(SolidProblem& problem, Material rich) {
  problem.solve(rich, kLinearSearch);
  const Problem own = problem.problem(rich);
  double rows = 0;
  for (std::size_t p = 0; p < own.parts().size(); ++p) {
    const Experiment& experiment = *own.parts()[p].experiment;
    const auto predicted = own.predict(p, starts_of(own.unknowns()), /*derivatives=*/false);
    const double counted = experiment.weights().sum();
    rows += predicted ? counted / length_of(experiment, predicted->value) : counted;
  }
  return rows;
}

}  // namespace pliant
