#include "pliant/estimation/statistics/covariance.h"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "pliant/estimation/statistics/curve_error.h"
#include "pliant/math/quantiles.h"

#include "estimation/statistics/synthetic_fit.h"

namespace pliant {
namespace {

constexpr double kRounding = 1e-9;  // relative: condition numbers of a hundred, squared

/// Sums of a straight line in groups of five rows, at its least-squares solution.
struct Line {
  Eigen::MatrixXd jacobian = Eigen::MatrixXd(30, 2);
  Eigen::VectorXd residual = Eigen::VectorXd(30);
  EstimatingSums sums;

  Line() {
    RandomStream random(11);
    for (int i = 0; i < 30; ++i) {
      jacobian.row(i) << 1, 0.1 * i;
      residual(i) = random.normal();
    }
    const Eigen::MatrixXd slope = jacobian.transpose() * jacobian;
    residual -= jacobian * slope.inverse() * (jacobian.transpose() * residual).eval();
    for (int g = 0; g < 6; ++g) {
      sums.groups.push_back(
          group_sum(0, jacobian.middleRows(5 * g, 5), residual.segment(5 * g, 5)));
    }
  }
};

TEST(FormulaCovariance, IsTheInverseOfTheNormalMatrix) {
  const Line line;
  const auto formula = formula_covariance(line.sums, Eigen::Vector2d(1, 1), {28});
  const Eigen::MatrixXd expected = (line.jacobian.transpose() * line.jacobian).inverse();
  EXPECT_TRUE(formula.covariance.isApprox(expected, kRounding));
  EXPECT_NEAR(formula.degrees(0), 28, 28 * kRounding);
  EXPECT_EQ(formula.unseen.cols(), 0);
}

// The mean of rows of sd 1 and 3 that count alike.
TEST(FormulaCovariance, KnowsTheNoiseOfRowsThatCountOtherwiseThanByIt) {
  EstimatingSums sums;
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(10, 1);
  for (const int experiment : {0, 1}) {
    const Eigen::VectorXd sd = Eigen::VectorXd::Constant(10, experiment == 0 ? 1 : 3);
    sums.groups.push_back(group_sum(experiment, one, Eigen::VectorXd::Zero(10), sd, {}));
  }
  const auto formula = formula_covariance(sums, Eigen::VectorXd::Ones(1), {9, 9});
  EXPECT_NEAR(formula.covariance(0, 0), (10 * 1 + 10 * 9) / (20.0 * 20), kRounding);
}

// A prior counts with its own sd, however strongly residuals go together.
TEST(FormulaCovariance, GivesWhatOnlyAPriorTellsItsSd) {
  EstimatingSums sums;
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(10, 2);
  jacobian.col(0).setConstant(1 / std::sqrt(9.0));  // sd 1, L 9
  sums.groups.push_back(group_sum(0, jacobian, Eigen::VectorXd::Zero(10)));
  sums.priors = Eigen::MatrixXd::Zero(2, 2);
  sums.priors(1, 1) = 1 / (0.3 * 0.3);
  const auto formula = formula_covariance(sums, Eigen::Vector2d(1, 1), {9});
  EXPECT_NEAR(std::sqrt(formula.covariance(1, 1)), 0.3, kRounding);
  EXPECT_NEAR(std::sqrt(formula.covariance(0, 0)), std::sqrt(9.0 / 10), kRounding);
  EXPECT_TRUE(std::isinf(formula.degrees(1)));
}

TEST(FormulaCovariance, AddsDegreesOfExperimentsByTheirShares) {
  EstimatingSums sums;
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(8, 1);
  sums.groups = {group_sum(0, one, Eigen::VectorXd::Zero(8)),
                 group_sum(1, one, Eigen::VectorXd::Zero(8))};
  // Equal shares: 1 / (1/4 / 10 + 1/4 / 40).
  const auto formula = formula_covariance(sums, Eigen::VectorXd::Ones(1), {10, 40});
  EXPECT_NEAR(formula.degrees(0), 32, 32 * kRounding);
}

TEST(Covariance, SaysWhichDirectionTheDataDoesNotSee) {
  Eigen::MatrixXd jacobian(6, 3);
  for (int i = 0; i < 6; ++i) jacobian.row(i) << 1, 1, i;  // only the sum of the first two
  EstimatingSums sums;
  sums.groups = {group_sum(0, jacobian, Eigen::VectorXd::Zero(6))};
  const Eigen::Vector3d unit(1, 1, 1);
  const ParameterErrors errors = parameter_errors(sums, unit, {4});
  ASSERT_EQ(errors.unseen.cols(), 1);
  EXPECT_TRUE(std::isnan(errors.sd(0)));
  EXPECT_TRUE(std::isnan(errors.half_width(1)));
  EXPECT_TRUE(std::isfinite(errors.sd(2)));
  EXPECT_TRUE(curve_error(Eigen::Vector3d(1, 1, 0.5), errors, unit));
  EXPECT_FALSE(curve_error(Eigen::Vector3d(1, 0, 0.5), errors, unit));
}

// Units of the unknowns are as different as N/m and rad.
TEST(Covariance, SeesAllWhatIsOnlySmall) {
  Line line;
  const Eigen::Vector2d scale(1e-9, 1e6);
  EstimatingSums sums;
  for (int g = 0; g < 6; ++g) {
    sums.groups.push_back(group_sum(0, line.jacobian.middleRows(5 * g, 5) * scale.asDiagonal(),
                                    line.residual.segment(5 * g, 5)));
  }
  const auto here = parameter_errors(line.sums, Eigen::Vector2d(1, 1), {28});
  const auto there = parameter_errors(sums, Eigen::Vector2d(1e9, 1e-6), {28});
  for (int u = 0; u < 2; ++u) {
    EXPECT_NEAR(there.sd(u) * scale(u) / here.sd(u), 1, kRounding);
    EXPECT_NEAR(there.jackknife_sd(u) * scale(u) / here.jackknife_sd(u), 1, kRounding);
  }
}

TEST(Jackknife, ChangesAreThoseOfFitsWithoutAGroup) {
  const Line line;
  const Eigen::Vector2d unit(1, 1);
  const auto formula = formula_covariance(line.sums, unit, {28});
  const auto jackknife = jackknife_variance(line.sums, formula, unit);
  Eigen::Vector2d squares(0, 0), expected(0, 0);
  for (int g = 0; g < 6; ++g) {
    std::vector<Eigen::Index> kept;
    for (int i = 0; i < 30; ++i) {
      if (i / 5 != g) kept.push_back(i);
    }
    const Eigen::MatrixXd j = line.jacobian(kept, Eigen::all);
    const Eigen::MatrixXd without = (j.transpose() * j).inverse() * j.transpose();
    squares += Eigen::VectorXd(without * line.residual(kept)).cwiseAbs2();
    // Under independent noise: variance of without * (kept rows of I - hat).
    const Eigen::MatrixXd hat = line.jacobian * formula.covariance * line.jacobian.transpose();
    const Eigen::MatrixXd spare = Eigen::MatrixXd::Identity(30, 30) - hat;
    expected += (without * spare(kept, Eigen::all)).rowwise().squaredNorm();
  }
  for (int u = 0; u < 2; ++u) {
    const double variance = squares(u) / expected(u) * formula.covariance(u, u);
    EXPECT_NEAR(jackknife.variance(u), variance, kRounding * variance);
    EXPECT_GT(jackknife.degrees(u), 1);
    EXPECT_LT(jackknife.degrees(u), 5);  // groups - 1
  }
}

TEST(Jackknife, OfAMeanOfEqualGroupsIsThatOfTheirMeans) {
  EstimatingSums sums;
  const std::vector<double> means{1, -2, 0.5, 0.5};
  for (const double mean : means) {
    sums.groups.push_back(
        group_sum(0, Eigen::MatrixXd::Ones(3, 1), Eigen::VectorXd::Constant(3, mean)));
  }
  const auto formula = formula_covariance(sums, Eigen::VectorXd::Ones(1), {11});
  const auto jackknife = jackknife_variance(sums, formula, Eigen::VectorXd::Ones(1));
  EXPECT_NEAR(jackknife.degrees(0), 3, kRounding);             // groups - 1
  EXPECT_NEAR(jackknife.variance(0), 5.5 / 3 / 4, kRounding);  // s^2 / m
}

TEST(Jackknife, SaysNothingOfWhatOneGroupTellsAlone) {
  EstimatingSums sums;
  for (int g = 0; g < 4; ++g) {
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(5, 2);
    jacobian.col(0).setOnes();
    if (g == 2) jacobian.col(1) << -1, 0, 1, 2, 3;
    sums.groups.push_back(group_sum(0, jacobian, Eigen::VectorXd::Constant(5, g - 1.5)));
  }
  const ParameterErrors errors = parameter_errors(sums, Eigen::Vector2d(1, 1), {18});
  EXPECT_TRUE(std::isfinite(errors.jackknife_sd(0)));
  EXPECT_TRUE(std::isnan(errors.jackknife_sd(1)));
  EXPECT_EQ(errors.sd(1), errors.formula_sd(1));
  EXPECT_EQ(errors.degrees(1), 18);
}

TEST(ParameterErrors, AreTheLargerOnesInAValidCovariance) {
  // Groups that differ far more than their rows.
  EstimatingSums sums;
  RandomStream random(5);
  for (int g = 0; g < 4; ++g) {
    Eigen::MatrixXd jacobian(6, 3);
    for (int i = 0; i < 6; ++i) jacobian.row(i) << 1, 0.1 * (6 * g + i), random.normal();
    sums.groups.push_back(
        group_sum(0, jacobian, Eigen::VectorXd::Constant(6, 10 * random.normal())));
  }
  const ParameterErrors errors = parameter_errors(sums, Eigen::Vector3d(1, 1, 1), {21});
  int raised = 0;
  for (int u = 0; u < 3; ++u) {
    const bool larger = errors.jackknife_sd(u) > errors.formula_sd(u);
    raised += larger;
    EXPECT_NEAR(errors.sd(u), larger ? errors.jackknife_sd(u) : errors.formula_sd(u),
                kRounding * errors.sd(u));
    EXPECT_NEAR(errors.half_width(u), student_quantile_95(errors.degrees(u)) * errors.sd(u),
                kRounding * errors.half_width(u));
  }
  EXPECT_GT(raised, 0);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(errors.covariance);
  EXPECT_GT(solver.eigenvalues().minCoeff(), 0);
}

TEST(Clusters, AddUpTheirGroups) {
  const Line line;
  const auto clusters = clustered(line.sums.groups, {0, 0, 1, 1, 2, 2});
  ASSERT_EQ(clusters.size(), 3U);
  const GroupSum whole =
      group_sum(0, line.jacobian.middleRows(10, 10), line.residual.segment(10, 10));
  EXPECT_TRUE(clusters[1].slope.isApprox(whole.slope, kRounding));
  EXPECT_TRUE(clusters[1].part.isApprox(whole.part, kRounding));
  EXPECT_TRUE(clusters[1].scatter.isApprox(whole.scatter, kRounding));
}

TEST(CurveBand, IsStudentsIntervalOfTheCurve) {
  const Line line;
  const Eigen::Vector2d unit(1, 1), at(1, 2);
  const ParameterErrors errors = parameter_errors(line.sums, unit, {28});
  const double sd = std::sqrt(at.dot(errors.covariance * at));
  const double half_width = curve_error(at, errors, unit)->half_width;
  const auto [fewest, most] = std::minmax(errors.degrees(0), errors.degrees(1));
  EXPECT_LE(half_width, student_quantile_95(fewest) * sd * (1 + kRounding));
  EXPECT_GE(half_width, student_quantile_95(most) * sd * (1 - kRounding));
  EXPECT_EQ(curve_error(Eigen::Vector2d(0, 0), errors, unit)->half_width, 0);
}

}  // namespace
}  // namespace pliant
