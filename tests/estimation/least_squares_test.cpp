#include "pliant/estimation/least_squares.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

/// Rosenbrock's valley as two residuals, 10 (y - x^2) and 1 - x: zero at (1, 1).
LeastSquaresProblem valley() {
  LeastSquaresProblem problem;
  problem.residuals = 2;
  problem.lower = Eigen::Vector2d(-10, -10);
  problem.upper = Eigen::Vector2d(10, 10);
  problem.scale = Eigen::Vector2d(1, 1);
  problem.evaluate = [](const Eigen::VectorXd& p, Eigen::VectorXd& residual,
                        Eigen::MatrixXd* jacobian) {
    residual = Eigen::Vector2d(10 * (p(1) - p(0) * p(0)), 1 - p(0));
    if (jacobian != nullptr) {
      jacobian->resize(2, 2);
      *jacobian << -20 * p(0), 10, -1, 0;
    }
    return true;
  };
  return problem;
}

const Eigen::Vector2d kUsualStart(-1.2, 1);

TEST(LeastSquares, FindsTheBottomOfRosenbrocksValley) {
  const LeastSquaresSummary summary = solve_least_squares(valley(), kUsualStart, {}, {});
  EXPECT_TRUE(summary.converged);
  // The solver stops at relative steps of 1e-11; residuals grow ten times as fast as the
  // parameters.
  EXPECT_NEAR(summary.parameters(0), 1, 1e-10);
  EXPECT_NEAR(summary.parameters(1), 1, 1e-10);
  EXPECT_LT(summary.cost, 1e-18);
}

TEST(LeastSquares, StopsOnTheBoundWhereTheBottomLiesOutside) {
  LeastSquaresProblem problem = valley();
  problem.upper(0) = 0.5;
  const LeastSquaresSummary summary = solve_least_squares(problem, kUsualStart, {}, {});
  // On x = 1/2 the first residual vanishes at y = 1/4, the second stays 1/2.
  EXPECT_TRUE(summary.converged);
  EXPECT_NEAR(summary.parameters(0), 0.5, 1e-9);  // linear convergence along an active bound
  EXPECT_LE(summary.parameters(0), 0.5);
  EXPECT_NEAR(summary.parameters(1), 0.25, 1e-8);
  EXPECT_NEAR(summary.cost, 0.125, 1e-9);
}

// Steps that are clipped at the bound leave the valley x + y = 0, along which the bottom lies.
TEST(LeastSquares, DoesNotCrawlWhereItIsPressedToABound) {
  LeastSquaresProblem problem = valley();
  problem.lower(0) = 0;
  problem.evaluate = [](const Eigen::VectorXd& p, Eigen::VectorXd& residual,
                        Eigen::MatrixXd* jacobian) {
    residual = Eigen::Vector2d(1000 * (p(0) + p(1)), p(0) + 1);
    if (jacobian != nullptr) {
      jacobian->resize(2, 2);
      *jacobian << 1000, 1000, 1, 0;
    }
    return true;
  };
  const LeastSquaresSummary summary =
      solve_least_squares(problem, Eigen::Vector2d(0, 0.5), {.function_tolerance = 1e-10}, {});
  EXPECT_TRUE(summary.converged);
  EXPECT_EQ(summary.parameters(0), 0);
  EXPECT_NEAR(summary.parameters(1), 0, 1e-6);
  EXPECT_LT(summary.iterations, 16);
}

/// The nearest to a point of the points with x >= 2 y and 3 x >= -y.
LeastSquaresSummary nearest_in_wedge(const Eigen::Vector2d& point) {
  LeastSquaresProblem problem = valley();
  problem.evaluate = [point](const Eigen::VectorXd& p, Eigen::VectorXd& residual,
                             Eigen::MatrixXd* jacobian) {
    residual = p - point;
    if (jacobian != nullptr) *jacobian = Eigen::Matrix2d::Identity();
    return true;
  };
  problem.not_negative.resize(2, 2);
  problem.not_negative << 1, -2, 3, 1;
  return solve_least_squares(problem, point, {}, {});
}

TEST(LeastSquares, StopsAtInequalitiesWhereTheBottomViolatesThem) {
  // The margin that the solver keeps is 1e-7.
  constexpr double kTolerance = 1e-6;
  const LeastSquaresSummary inside = nearest_in_wedge({3, 1});
  EXPECT_EQ(inside.cost, 0);
  // The foot on the line x = 2 y through (1, 3): (2, 1), at the distance sqrt(5).
  const LeastSquaresSummary foot = nearest_in_wedge({1, 3});
  EXPECT_TRUE(foot.converged);
  EXPECT_NEAR(foot.parameters(0), 2, kTolerance);
  EXPECT_NEAR(foot.parameters(1), 1, kTolerance);
  EXPECT_NEAR(foot.cost, 2.5, 5 * kTolerance);
  EXPECT_GE(foot.parameters(0) - 2 * foot.parameters(1), 0);
  // The corner of both, where neither line has its foot.
  const LeastSquaresSummary corner = nearest_in_wedge({-3, 0});
  EXPECT_TRUE(corner.converged);
  EXPECT_LT(corner.parameters.norm(), kTolerance);
}

TEST(LeastSquares, HoldsFixedParameters) {
  LeastSquaresProblem problem = valley();
  problem.lower(0) = problem.upper(0) = -2;
  const LeastSquaresSummary summary = solve_least_squares(problem, kUsualStart, {}, {});
  EXPECT_TRUE(summary.converged);
  EXPECT_EQ(summary.parameters(0), -2);
  EXPECT_NEAR(summary.parameters(1), 4, 1e-12);  // linear in y: exact but for rounding
}

TEST(LeastSquares, ReturnsTheCostWhereNothingIsFree) {
  LeastSquaresProblem problem = valley();
  problem.lower = problem.upper = Eigen::Vector2d(2, 5);
  const LeastSquaresSummary summary = solve_least_squares(problem, kUsualStart, {}, {});
  EXPECT_TRUE(summary.converged);
  EXPECT_EQ(summary.parameters, Eigen::VectorXd(Eigen::Vector2d(2, 5)));
  EXPECT_DOUBLE_EQ(summary.cost, (10 * 10 + 1) / 2.0);
}

TEST(LeastSquares, DoesNotDependOnTheUnitsOfTheParameters) {
  // x in millionths, y in millions: the same valley through other numbers.
  const Eigen::Vector2d unit(1e-6, 1e6);
  LeastSquaresProblem problem = valley();
  const auto evaluate = problem.evaluate;
  problem.evaluate = [=](const Eigen::VectorXd& p, Eigen::VectorXd& residual,
                         Eigen::MatrixXd* jacobian) {
    const bool done = evaluate(p.cwiseQuotient(unit), residual, jacobian);
    if (jacobian != nullptr) *jacobian = *jacobian * unit.cwiseInverse().asDiagonal();
    return done;
  };
  problem.lower = problem.lower.cwiseProduct(unit);
  problem.upper = problem.upper.cwiseProduct(unit);
  problem.scale = unit;
  const LeastSquaresSummary summary =
      solve_least_squares(problem, kUsualStart.cwiseProduct(unit), {}, {});
  // The parameters' tolerance, relative.
  EXPECT_NEAR(summary.parameters(0), 1e-6, 1e-17);
  EXPECT_NEAR(summary.parameters(1), 1e6, 1e-5);
}

TEST(LeastSquares, SaysThatAStartHasNoResidual) {
  LeastSquaresProblem problem = valley();
  problem.evaluate = [](const Eigen::VectorXd&, Eigen::VectorXd&, Eigen::MatrixXd*) {
    return false;
  };
  const LeastSquaresSummary summary = solve_least_squares(problem, kUsualStart, {}, {});
  EXPECT_FALSE(summary.converged);
  EXPECT_TRUE(std::isinf(summary.cost));
}

TEST(LeastSquares, StepsBackFromWhereThereIsNoResidual) {
  // The residual sqrt(x) - 1/10 from far: the first full step would go below zero.
  LeastSquaresProblem problem;
  problem.residuals = 1;
  problem.lower = Eigen::VectorXd::Constant(1, -100);
  problem.upper = Eigen::VectorXd::Constant(1, 100);
  problem.scale = Eigen::VectorXd::Constant(1, 1);
  problem.evaluate = [](const Eigen::VectorXd& p, Eigen::VectorXd& residual,
                        Eigen::MatrixXd* jacobian) {
    if (p(0) <= 0) return false;
    residual(0) = std::sqrt(p(0)) - 0.1;
    if (jacobian != nullptr) jacobian->setConstant(1, 1, 0.5 / std::sqrt(p(0)));
    return true;
  };
  const LeastSquaresSummary summary =
      solve_least_squares(problem, Eigen::VectorXd::Constant(1, 4), {}, {});
  EXPECT_TRUE(summary.converged);
  EXPECT_NEAR(summary.parameters(0), 0.01, 1e-12);  // the residual vanishes: to rounding
}

TEST(LeastSquares, CountsIterationsWhenItRanOutOfThem) {
  const LeastSquaresSummary summary =
      solve_least_squares(valley(), kUsualStart, {.max_iterations = 2}, {});
  EXPECT_FALSE(summary.converged);
  EXPECT_GE(summary.iterations, 2);
}

TEST(LeastSquares, StopsWhenAsked) {
  StopFlag flag;
  flag.request();
  EXPECT_THROW(solve_least_squares(valley(), kUsualStart, {}, flag.token()), Interrupted);
}

TEST(LeastSquares, StopsWhenAskedOnTheWay) {
  StopFlag flag;
  LeastSquaresProblem problem = valley();
  const auto evaluate = problem.evaluate;
  problem.evaluate = [&flag, evaluate](const Eigen::VectorXd& p, Eigen::VectorXd& residual,
                                       Eigen::MatrixXd* jacobian) {
    if (jacobian != nullptr) flag.request();
    return evaluate(p, residual, jacobian);
  };
  EXPECT_THROW(solve_least_squares(problem, kUsualStart, {}, flag.token()), Interrupted);
}

}  // namespace
}  // namespace pliant
