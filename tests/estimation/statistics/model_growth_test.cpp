#include "pliant/estimation/statistics/model_growth.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/estimation/statistics/correlation_length.h"
#include "pliant/math/scalar_curve.h"

#include "estimation/statistics/synthetic_fit.h"
#include "support/asked_for.h"

namespace pliant {
namespace {

using ::testing::ElementsAre;

constexpr double kLargestStrain = 0.2;
constexpr int kMostPoints = 6;
constexpr int kOthers = 4;  // friction's three and an offset

FittedModel fit_of(double rms, int parameters, int placed = 0, double rows = 100) {
  return {rms, parameters, placed, rows};
}

TEST(IsWorth, NeedsAFallOfOnePerCent) {
  // With so many rows the Bayesian criterion alone would take a tenth of that.
  EXPECT_FALSE(is_worth(fit_of(1, 4, 0, 1e6), fit_of(0.991, 5, 0, 1e6)));
  EXPECT_TRUE(is_worth(fit_of(1, 4, 0, 1e6), fit_of(0.989, 5, 0, 1e6)));
}

TEST(IsWorth, NeedsWhatTheParametersCost) {
  // 95 log(1 / rms^2) against log(100) = 4.6: a fall of 2.4 %.
  EXPECT_FALSE(is_worth(fit_of(1, 4), fit_of(0.977, 5)));
  EXPECT_TRUE(is_worth(fit_of(1, 4), fit_of(0.975, 5)));
  // Half as much again for a place: 3.6 %.
  EXPECT_FALSE(is_worth(fit_of(1, 4), fit_of(0.965, 5, 1)));
  EXPECT_TRUE(is_worth(fit_of(1, 4), fit_of(0.963, 5, 1)));
}

TEST(IsWorth, NeedsMoreOfFewRows) {
  EXPECT_TRUE(is_worth(fit_of(1, 4), fit_of(0.9, 5)));
  EXPECT_FALSE(is_worth(fit_of(1, 4, 0, 12), fit_of(0.9, 5, 0, 12)));
  EXPECT_FALSE(is_worth(fit_of(1, 4, 0, 5), fit_of(0.001, 5, 0, 5)));  // no row to spare
}

TEST(IsWorth, IsNothingBelowTheAccuracy) {
  EXPECT_TRUE(is_worth(fit_of(1e-9, 4), fit_of(1e-12, 5)));
  EXPECT_FALSE(is_worth(fit_of(1e-9, 4), fit_of(1e-12, 5), 1e-8));
}

/// Grows with given rms of 1, 2, ... points.
Growth grow_by(const std::vector<double>& rms) {
  return grow_model(1, static_cast<int>(rms.size()), [&](int points) -> std::optional<FittedModel> {
    const double value = rms[static_cast<size_t>(points - 1)];
    if (std::isnan(value)) return std::nullopt;
    return fit_of(value, points);
  });
}

std::vector<int> tried(const Growth& growth) {
  std::vector<int> points;
  for (const GrowthStep& step : growth.steps) points.push_back(step.points);
  return points;
}

TEST(GrowModel, EndsWhereNeitherOneNorTwoMorePointsAreWorthIt) {
  const Growth growth = grow_by({10, 5, 4.99, 4.98, 1});
  EXPECT_EQ(growth.points, 2);
  EXPECT_THAT(tried(growth), ElementsAre(1, 2, 3, 4));
}

TEST(GrowModel, GoesOnWhereTwoMorePointsAreWorthIt) {
  const Growth growth = grow_by({10, 5, 4.99, 1, 0.999, 0.998});
  EXPECT_EQ(growth.points, 4);
  EXPECT_TRUE(growth.steps[3].accepted);
  EXPECT_FALSE(growth.steps[2].accepted);
}

TEST(GrowModel, EndsAtTheMostPointsAndWhereNoFitIs) {
  EXPECT_EQ(grow_by({10, 5, 1}).points, 3);
  EXPECT_EQ(grow_by({10, 5, NAN, 1}).points, 2);
  EXPECT_EQ(grow_by({NAN}).points, 0);
}

TEST(GrowModel, SaysWhyItEnded) {
  EXPECT_EQ(grow_by({10, 5, 4.99, 4.98, 1}).end, GrowthEnd::not_worth_it);
  EXPECT_EQ(grow_by({10, 5, 4.99}).end, GrowthEnd::not_worth_it);  // the most, but worth nothing
  EXPECT_EQ(grow_by({10, 5, 1}).end, GrowthEnd::most);
  EXPECT_EQ(grow_by({10, 5, NAN, 1}).end, GrowthEnd::no_fit);
  EXPECT_EQ(grow_by({NAN}).end, GrowthEnd::no_fit);
  EXPECT_EQ(grow_by({10, 5, 0, 0}).end, GrowthEnd::accurate);
}

/// A strip's cycles with friction, fitted with Hermite curves whose points are placed where they
/// help most. All is linear: friction's strain is known.
class StripGrowth {
 public:
  StripGrowth(int rows, double memory, double bump, RandomStream& random)
      : path_(test::strain_cycles(rows, 3)), sorted_(path_.strain.begin(), path_.strain.end()) {
    std::sort(sorted_.begin(), sorted_.end());
    const Eigen::ArrayXd x = path_.strain.array();
    const Eigen::ArrayXd stress = x * (2 + 15 * x) + 0.05 * path_.friction.array() +
                                  bump * (-((x - 0.08) / 0.03).square()).exp();
    measured_ = stress.matrix() + 0.02 * test::autoregressive_noise(rows, memory, random);
    std::vector<double> even;
    for (int i = 0; i < kMostPoints; ++i) even.push_back(kLargestStrain * i / (kMostPoints - 1));
    const Eigen::VectorXd residual = residual_of(even);
    const double length =
        correlation_length({{residual.begin(), residual.end()}}, kMostPoints + kOthers - 1);
    effective_rows_ = rows / length;
  }

  int grown_points() {
    return grow_model(1, kMostPoints, [&](int points) { return fit(points); }).points;
  }

 private:
  std::optional<FittedModel> fit(int points) {
    knots_ = points == 1   ? std::vector<double>{kLargestStrain}
             : points == 2 ? std::vector<double>{0, kLargestStrain}
                           : split();
    const double rms =
        residual_of(knots_).norm() / std::sqrt(static_cast<double>(measured_.size()));
    return FittedModel{rms, points + kOthers, std::max(points - 2, 0), effective_rows_};
  }

  std::vector<double> split() const {
    std::vector<double> best;
    double least = INFINITY;
    for (size_t i = 0; i + 1 < knots_.size(); ++i) {
      const auto low = std::lower_bound(sorted_.begin(), sorted_.end(), knots_[i]);
      const auto high = std::upper_bound(sorted_.begin(), sorted_.end(), knots_[i + 1]);
      const double width = knots_[i + 1] - knots_[i];
      for (const double at :
           {knots_[i] + width / 2, knots_[i] + 0.7 * width, *(low + (high - low) / 2)}) {
        if (std::min(at - knots_[i], knots_[i + 1] - at) < 0.02 * kLargestStrain) continue;
        std::vector<double> candidate = knots_;
        candidate.insert(candidate.begin() + static_cast<std::ptrdiff_t>(i) + 1, at);
        const double cost = residual_of(candidate).squaredNorm();
        if (cost >= least) continue;
        least = cost;
        best = candidate;
      }
    }
    return best;
  }

  Eigen::VectorXd residual_of(const std::vector<double>& knots) const {
    const auto curve = ScalarCurve::hermite(knots, std::vector<double>(knots.size(), 0.0));
    const auto points = static_cast<Eigen::Index>(knots.size());
    Eigen::MatrixXd jacobian(measured_.size(), points + 3);
    for (Eigen::Index i = 0; i < measured_.size(); ++i) {
      const double x = path_.strain(i), friction = path_.friction(i);
      jacobian.row(i).head(points) = x * curve.weights(x).transpose();
      jacobian.row(i).tail(3) << friction, friction * x, 1;
    }
    return jacobian * jacobian.colPivHouseholderQr().solve(measured_) - measured_;
  }

  test::StrainPath path_;
  std::vector<double> sorted_, knots_;
  Eigen::VectorXd measured_;
  double effective_rows_ = 0;
};

/// Share of the seeds in which growth goes past two points.
double rate_past_two(int rows, double memory, double bump, int seeds) {
  return test::rate_of(seeds, [&](RandomStream& random) {
    return StripGrowth(rows, memory, bump, random).grown_points() > 2;
  });
}

TEST(Growth, GoesPastATrueTwoPointCurveSeldom) {
  // 5 % of 300 fits would vary by 1.3 %.
  for (const int rows : {24, 144}) EXPECT_LE(rate_past_two(rows, 0, 0, 300), 0.08) << rows;
  EXPECT_LE(rate_past_two(600, 0, 0, 100), 0.08);
}

TEST(Growth, GoesPastATrueTwoPointCurveSeldomWithNoiseThatRemembers) {
  for (const int rows : {24, 144}) EXPECT_LE(rate_past_two(rows, 0.8, 0, 200), 0.08) << rows;
}

TEST(Growth, FindsABump) {
  // Two and a half times the noise of a row.
  EXPECT_GE(rate_past_two(144, 0, 0.05, 100), 0.9);
  EXPECT_GE(rate_past_two(600, 0, 0.05, 30), 0.99);
}

TEST(SlowStatisticsTables, Growth) {
  if (!test::makes_figures()) GTEST_SKIP() << "a table of docs/figures";

  fmt::print(
      "share of fits that go past two points: rows, memory of the noise, height of a bump "
      "in the noise of a row\n");
  for (const int rows : {24, 48, 144, 600}) {
    for (const double memory : {0.0, 0.5, 0.8}) {
      fmt::print("{:>4} {:.1f}", rows, memory);
      for (const double bump : {0.0, 1.0, 2.5, 5.0}) {
        fmt::print(" {:>6.1f}", 100 * rate_past_two(rows, memory, 0.02 * bump, 400));
      }
      fmt::print("\n");
    }
  }
}

}  // namespace
}  // namespace pliant
