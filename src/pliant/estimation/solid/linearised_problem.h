#pragma once

#include <vector>

#include "pliant/estimation/solid/solid_problem.h"

namespace pliant {

/// Of searches whose unknowns are linear, or nearly.
inline constexpr LeastSquaresOptions kLinearSearch{
    .max_iterations = 60, .function_tolerance = 1e-9, .parameter_tolerance = 1e-9};

/// The problem of a solid of many unknowns, linearised about their values: it tells without further
/// equilibria how well solids would do whose unknowns are fewer.
class LinearisedProblem {
 public:
  LinearisedProblem(SolidProblem& problem, const Material& material);

  /// Whether there is a prediction to be linearised.
  bool is_valid() const { return valid_; }
  const std::vector<Unknown>& unknowns() const { return unknowns_; }

  /// Least cost of fewer unknowns.
  /// @param combinations  the many of the few: unknowns x few
  /// @param alike         for each of the few one of the many, whose bounds and scale it has
  /// @param begin         where the search begins, of the few
  LeastSquaresSummary solve(const Eigen::MatrixXd& combinations,
                            const std::vector<std::size_t>& alike, const Eigen::VectorXd& begin,
                            const StopToken& stop) const;

 private:
  std::vector<Unknown> unknowns_;
  Eigen::VectorXd offset_;  // of the residuals, where all unknowns are 0
  Eigen::MatrixXd slope_;
  bool valid_ = false;
};

}  // namespace pliant
