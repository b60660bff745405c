#pragma once

#include <functional>

#include <Eigen/Core>

#include "pliant/estimation/least_squares.h"

namespace pliant {

/// A convex set of the unknowns of a least-squares problem: linear conditions, and further ones
/// that are told where they do not hold.
struct ConvexSet {
  Eigen::MatrixXd rows;  ///< A with A p >= 0
  /// Further rows of the kind, which hold in the whole set and not at p; none where p is in it.
  std::function<Eigen::MatrixXd(const Eigen::VectorXd& p)> violated;
};

/// Least squares within a set: Gauss and Newton's method. The linearised problem is solved under
/// conditions, to which each solution that is outside adds those that it violates ([Kelley1960]);
/// the way there, which lies in the set, is shortened until it gains.
/// @return as `solve_least_squares`
LeastSquaresSummary solve_within(const ConvexSet& set, LeastSquaresProblem problem,
                                 const Eigen::VectorXd& start, const LeastSquaresOptions& options,
                                 const StopToken& stop);

/// The point of a set nearest to another one, lengths being in units of the problem's scale.
/// @param problem  its bounds hold, too
Eigen::VectorXd nearest_within(const ConvexSet& set, const LeastSquaresProblem& problem,
                               const Eigen::VectorXd& point, const StopToken& stop);

/// The published search ([T] 4.3): an update of the unknowns without conditions, and the nearest
/// point of the set, in turn, until that gains nothing. It ends at no best point where the set is
/// in the way of the update: the nearest point is not the one of least cost.
/// @return as `solve_least_squares`
LeastSquaresSummary solve_projected(const ConvexSet& set, const LeastSquaresProblem& problem,
                                    const Eigen::VectorXd& start,
                                    const LeastSquaresOptions& options, const StopToken& stop);

}  // namespace pliant
