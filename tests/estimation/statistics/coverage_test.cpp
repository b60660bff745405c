// How often 95 % intervals hold the truth, on small models whose noise is known. The tables of
// docs/estimation.md are printed by the suites named Slow.

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "estimation/statistics/synthetic_fit.h"
#include "support/asked_for.h"

namespace pliant {
namespace {

using test::autoregressive_noise;
using test::fit_synthetic;
using test::linear_experiment;
using test::measure;
using test::rate_of;
using test::StrainPath;
using test::SyntheticExperiment;
using test::SyntheticFit;

// 95 % of 400 trials vary by a standard deviation of 1.1 %: four of them downwards. Intervals that
// are the wider of two are too wide now and then, so that there is more room above.
constexpr int kSeeds = 400;
constexpr double kLowest = 0.905, kHighest = 0.985;

/// One experiment of 50 rows in ten half cycles tells the first unknown; few rows of another tell
/// the second.
SyntheticFit fit_few_beside_many(int few, double noise_of_few, RandomStream& random) {
  Eigen::MatrixXd many = Eigen::MatrixXd::Zero(50, 2), other(few, 2);
  std::vector<int> group;
  for (int i = 0; i < 50; ++i) {
    many(i, 0) = (i + 1) / 50.0;
    group.push_back(i / 5);
  }
  for (int i = 0; i < few; ++i) other.row(i) << 0.2, (i + 1.0) / few;
  const Eigen::Vector2d truth(1, 1);
  std::vector<SyntheticExperiment> experiments{linear_experiment(many, group),
                                               linear_experiment(other)};
  measure(experiments[0], truth, 0.05, autoregressive_noise(50, 0, random));
  measure(experiments[1], truth, noise_of_few, autoregressive_noise(few, 0, random));
  return fit_synthetic(experiments, truth);
}

double rate_of_few(int few, double noise_of_few, int seeds) {
  return rate_of(seeds, [&](RandomStream& random) {
    return fit_few_beside_many(few, noise_of_few, random).holds(1, 1);
  });
}

class FewRows : public ::testing::TestWithParam<int> {};

TEST_P(FewRows, BesideManyHaveIntervalsThatHoldTheTruth) {
  const double rate = rate_of_few(GetParam(), 0.05, kSeeds);
  EXPECT_GE(rate, kLowest);
  EXPECT_LE(rate, kHighest);
}

INSTANTIATE_TEST_SUITE_P(Rows, FewRows, ::testing::Values(1, 2, 3, 4, 8));

TEST(FewRowsWithNoiseOfTheirOwn, HaveIntervalsThatHoldTheTruthFromSevenOn) {
  // Three times the noise of the others: seven rows less two unknowns tell that.
  const double rate = rate_of_few(7, 0.15, kSeeds);
  EXPECT_GE(rate, kLowest);
  EXPECT_LE(rate, kHighest);
}

/// Load-unload cycles of a strip to three amplitudes, a row every 1 / 500 of strain.
StrainPath three_amplitudes() {
  StrainPath path;
  std::vector<double> strain, friction;
  int half = 0;
  for (const int rows : {25, 50, 100}) {
    const StrainPath cycle = test::strain_cycles(2 * rows, 1);
    for (int i = 0; i < 2 * rows; ++i) {
      strain.push_back(cycle.strain(i) * rows / 100);
      const double gone = 0.2 * (i % rows) / 100;
      friction.push_back((i < rows ? 1 : -1) * (1 - 2 * std::exp(-gone / 0.02)));
      path.half_cycle.push_back(half + i / rows);
    }
    half += 2;
  }
  path.strain = Eigen::Map<Eigen::VectorXd>(strain.data(), 350);
  path.friction = Eigen::Map<Eigen::VectorXd>(friction.data(), 350);
  return path;
}

/// Share of intervals that hold the truth, of each unknown of a strip's law.
Eigen::VectorXd strip_rates(const StrainPath& path, int unknowns, double memory, int seeds,
                            double half_cycles_differ = 0) {
  const Eigen::MatrixXd jacobian = test::strip_jacobian(path, unknowns);
  const Eigen::VectorXd truth = Eigen::VectorXd::Ones(unknowns);
  Eigen::VectorXd held = Eigen::VectorXd::Zero(unknowns);
  for (int seed = 0; seed < seeds; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed));
    SyntheticExperiment strip = linear_experiment(jacobian, path.half_cycle);
    Eigen::VectorXd noise = autoregressive_noise(jacobian.rows(), memory, random);
    std::vector<double> factor;
    for (int g = 0; g <= path.half_cycle.back(); ++g) factor.push_back(random.normal());
    for (Eigen::Index i = 0; i < noise.size(); ++i) {
      const int half = path.half_cycle[static_cast<size_t>(i)];
      noise(i) += half_cycles_differ * factor[static_cast<size_t>(half)] * jacobian(i, 0);
    }
    measure(strip, truth, 0.05, noise);
    const SyntheticFit fit = fit_synthetic({strip}, truth);
    for (int u = 0; u < unknowns; ++u) held(u) += fit.holds(u, 1);
  }
  return held / seeds;
}

void expect_rates(const Eigen::VectorXd& rates, double lowest, double highest) {
  EXPECT_GE(rates.minCoeff(), lowest) << rates.transpose();
  EXPECT_LE(rates.maxCoeff(), highest) << rates.transpose();
}

TEST(StripIntervals, HoldTheTruthWithIndependentNoise) {
  expect_rates(strip_rates(three_amplitudes(), 5, 0, 200), kLowest, 1);
}

TEST(StripIntervals, HoldTheTruthWithNoiseThatRemembers) {
  const Eigen::VectorXd rates = strip_rates(three_amplitudes(), 5, 0.8, 200);
  expect_rates(rates, kLowest, 1);
  // Single unknowns of 200 seeds vary by 1.5 %; their mean shows intervals that are too wide.
  EXPECT_LE(rates.mean(), kHighest);
}

// Half cycles that differ: the formula counts rows, which are many; groups are few.
TEST(StripIntervals, HoldTheTruthWhereHalfCyclesDiffer) {
  // Eight half cycles know their scatter to a quarter, in steps that Student's t only roughly
  // counts: 3 % below the others.
  expect_rates(strip_rates(test::strain_cycles(240, 4), 5, 0, 200, 1), 0.88, 1);
}

/// y = p0 (1 - exp(-x / p1)), which bends within the data.
SyntheticExperiment saturating(int rows) {
  SyntheticExperiment experiment = linear_experiment(Eigen::MatrixXd::Zero(rows, 2));
  for (int i = 0; i < rows; ++i) experiment.group[static_cast<size_t>(i)] = i * 6 / rows;
  experiment.predict = [rows](const Eigen::VectorXd& p) {
    const Eigen::ArrayXd x = Eigen::ArrayXd::LinSpaced(rows, 0.1, 3);
    const Eigen::ArrayXd decay = (-x / p(1)).exp();
    test::Prediction prediction{p(0) * (1 - decay), Eigen::MatrixXd(rows, 2)};
    prediction.jacobian.col(0) = 1 - decay;
    prediction.jacobian.col(1) = -p(0) * decay * x / (p(1) * p(1));
    return prediction;
  };
  return experiment;
}

TEST(NonlinearIntervals, HoldTheTruth) {
  const Eigen::Vector2d truth(1, 1);
  for (const Eigen::Index unknown : {0, 1}) {
    const double rate = rate_of(kSeeds, [&](RandomStream& random) {
      SyntheticExperiment experiment = saturating(40);
      measure(experiment, truth, 0.02, autoregressive_noise(40, 0, random));
      return fit_synthetic({experiment}, truth).holds(unknown, 1);
    });
    EXPECT_GE(rate, kLowest) << unknown;
    EXPECT_LE(rate, kHighest) << unknown;
  }
}

TEST(Prior, OfWhatTheDataDoesNotSeeHoldsAtItsRateWithCorrelatedNoise) {
  const StrainPath path = test::strain_cycles(200, 4);
  Eigen::MatrixXd jacobian = test::strip_jacobian(path, 2);
  jacobian.conservativeResize(Eigen::NoChange, 3);
  jacobian.col(2).setZero();
  const Eigen::Vector3d truth(1, 1, 1);
  RandomStream random(0);
  SyntheticExperiment strip = linear_experiment(jacobian, path.half_cycle);
  measure(strip, truth, 0.05, autoregressive_noise(200, 0.8, random));
  const SyntheticFit fit = fit_synthetic({strip}, truth, {{2, 1.2, 0.1}});
  EXPECT_NEAR(fit.estimate(2), 1.2, 1e-9);
  EXPECT_NEAR(fit.errors.sd(2), 0.1, 1e-9);
}

// Stiffness from the first test alone, then friction from the second with the stiffness held, as
// the stages of sheets are fitted.
struct StagedFit {
  double stiffness, friction;
  ParameterErrors errors;
};

StagedFit fit_in_stages(RandomStream& random) {
  constexpr int kGroups = 12, kRows = 5;
  const auto noise = [&]() -> Eigen::VectorXd {
    return 0.05 * autoregressive_noise(kGroups * kRows, 0, random);
  };
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(kGroups * kRows, 0.1, 1);
  const Eigen::VectorXd first = x + noise(), second = x + Eigen::VectorXd::Ones(60) + noise();
  StagedFit fit;
  fit.stiffness = x.dot(first) / x.squaredNorm();
  fit.friction = (second - fit.stiffness * x).mean();
  EstimatingSums sums;
  for (int g = 0; g < kGroups; ++g) {
    const Eigen::VectorXd part = x.segment(g * kRows, kRows);
    Eigen::MatrixXd of_first = Eigen::MatrixXd::Zero(kRows, 2), of_second(kRows, 2);
    of_first.col(0) = part;
    of_second << part, Eigen::VectorXd::Ones(kRows);
    const Eigen::VectorXd r_first = fit.stiffness * part - first.segment(g * kRows, kRows);
    const Eigen::VectorXd r_second = fit.stiffness * part +
                                     Eigen::VectorXd::Constant(kRows, fit.friction) -
                                     second.segment(g * kRows, kRows);
    sums.groups.push_back(group_sum(0, of_first / 0.05, r_first / 0.05, {1, 0}));
    sums.groups.push_back(group_sum(1, of_second / 0.05, r_second / 0.05, {0, 1}));
  }
  fit.errors = parameter_errors(sums, Eigen::Vector2d(1, 1), {59, 59});
  return fit;
}

TEST(StagedFits, CarryTheErrorOfAnEarlierStageIntoLaterOnes) {
  double squares = 0, formula = 0, jackknife = 0;
  int held = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed));
    const StagedFit fit = fit_in_stages(random);
    squares += (fit.friction - 1) * (fit.friction - 1) / kSeeds;
    formula += fit.errors.formula_sd(1) * fit.errors.formula_sd(1) / kSeeds;
    jackknife += fit.errors.jackknife_sd(1) * fit.errors.jackknife_sd(1) / kSeeds;
    held += std::abs(fit.friction - 1) <= fit.errors.half_width(1);
  }
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(60, 0.1, 1);
  const double expected = 0.05 * 0.05 * (1 / 60.0 + x.mean() * x.mean() / x.squaredNorm());
  EXPECT_NEAR(formula, expected, 1e-9 * expected);  // rounding
  // A variance over 400 seeds is known to 7 %: three of them. Nearly half of this one comes from
  // the stage before.
  EXPECT_NEAR(formula / squares, 1, 0.2);
  EXPECT_NEAR(jackknife / squares, 1, 0.2);
  EXPECT_GE(held, kLowest * kSeeds);
  EXPECT_LE(held, kHighest * kSeeds);
}

TEST(SlowStatisticsTables, FewRowsBesideFifty) {
  if (!test::makes_figures()) GTEST_SKIP() << "a table of docs/figures";

  fmt::print("rows   same noise   three times the noise (assumed to be the others' below 7)\n");
  for (const int rows : {1, 2, 3, 4, 5, 6, 7, 8, 12}) {
    fmt::print("{:>4} {:>10.1f} % {:>10.1f} %\n", rows, 100 * rate_of_few(rows, 0.05, 2000),
               100 * rate_of_few(rows, 0.15, 2000));
  }
}

TEST(SlowStatisticsTables, Strips) {
  fmt::print("strip of 350 rows, memory of the noise and coverage of five unknowns\n");
  for (const double memory : {0.0, 0.5, 0.8, 0.9}) {
    const Eigen::VectorXd rates = 100 * strip_rates(three_amplitudes(), 5, memory, 1000);
    fmt::print("{:.1f} {:>6.1f} {:>6.1f} {:>6.1f} {:>6.1f} {:>6.1f}\n", memory, rates(0), rates(1),
               rates(2), rates(3), rates(4));
    EXPECT_GE(rates.minCoeff(), 100 * kLowest);
    EXPECT_LE(rates.maxCoeff(), 100 * kHighest);
  }
  if (!test::makes_figures()) return;
  fmt::print("240 rows, cycles, how much half cycles differ (in the noise of a row)\n");
  for (const int cycles : {2, 3, 4, 6}) {
    for (const double differ : {0.0, 0.5, 1.0, 2.0}) {
      const Eigen::VectorXd rates =
          100 * strip_rates(test::strain_cycles(240, cycles), 5, 0, 1000, differ);
      fmt::print("{} {:.1f} {:>6.1f} {:>6.1f} {:>6.1f} {:>6.1f} {:>6.1f}\n", cycles, differ,
                 rates(0), rates(1), rates(2), rates(3), rates(4));
    }
  }
}

}  // namespace
}  // namespace pliant
