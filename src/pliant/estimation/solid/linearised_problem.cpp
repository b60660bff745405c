#include "pliant/estimation/solid/linearised_problem.h"

namespace pliant {

LinearisedProblem::LinearisedProblem(SolidProblem& problem, const Material& material) {
  const Problem own = problem.problem(material);
  unknowns_ = own.unknowns();
  const Eigen::VectorXd at = starts_of(unknowns_);
  const LeastSquaresProblem squares = own.least_squares();
  Eigen::VectorXd residual = Eigen::VectorXd::Zero(squares.residuals);
  slope_.setZero(squares.residuals, at.size());
  valid_ = squares.evaluate(at, residual, &slope_);
  offset_ = residual - slope_ * at;
}

LeastSquaresSummary LinearisedProblem::solve(const Eigen::MatrixXd& combinations,
                                             const std::vector<std::size_t>& alike,
                                             const Eigen::VectorXd& begin,
                                             const StopToken& stop) const {
  LeastSquaresProblem problem;
  problem.lower = problem.upper = problem.scale = begin;
  for (Eigen::Index i = 0; i < begin.size(); ++i) {
    const Unknown& unknown = unknowns_[alike[static_cast<std::size_t>(i)]];
    problem.lower(i) = unknown.lower;
    problem.upper(i) = unknown.upper;
    problem.scale(i) = unknown.scale;
  }
  const Eigen::MatrixXd slope = slope_ * combinations;
  problem.residuals = static_cast<int>(offset_.size());
  problem.evaluate = [&](const Eigen::VectorXd& p, Eigen::VectorXd& residual,
                         Eigen::MatrixXd* jacobian) {
    residual = offset_ + slope * p;
    if (jacobian) *jacobian = slope;
    return true;
  };
  return solve_least_squares(problem, begin, kLinearSearch, stop);
}

}  // namespace pliant
