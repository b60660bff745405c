// Limits of energy ([T] 4.2.5) of homogeneous solids: found together with the law below them, or in
// turns with it, as published.

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/material/solid/standard_solids.h"

#include "solids/solid_labs.h"

namespace pliant {
namespace {

using test::LabFolder;
using test::solid_study;
using test::value_of;

StudyResult fit_of_limit(const LabFolder& folder, const std::string& model,
                         const std::string& more = "") {
  return fit_study(solid_study(folder, model, more), {}, {});
}

/// A rubber that swells by 8 % and no further, pulled and squeezed between free sides.
test::MeasuredFiles limited_rubber(double noise, std::uint64_t seed) {
  Material material = neo_hookean_solid(0.3e6, 1.5e6);
  material.limits.push_back({{"J"}, 5e3});
  std::vector<test::AnyTest> tests = test::three_modes(noise);
  for (test::AnyTest& any : tests) {
    auto& own = dynamic_cast<VirtualHomogeneous&>(*any.test);
    own.incompressible = false;
    for (double& peak : own.peaks) peak = 1 + 0.25 * (peak - 1);
  }
  return test::measurements_of(test::lab_of(material, tests), seed);
}

TEST(SlowSolidLimits, FindsALimitOfEnergyWithTheNumbersBelowIt) {
  const StudyResult result =
      fit_of_limit(LabFolder(limited_rubber(0, 1)), "law: neo-hookean, limits: [{of: [J]}]");
  EXPECT_NEAR(value_of(result, "J.limit"), 5e3, 1e-5 * 5e3);
  EXPECT_NEAR(value_of(result, "J.k"), 1.5e6, 1e-5 * 1.5e6);
  EXPECT_NEAR(value_of(result, "I1-bar.linear.c"), 0.3e6, 1e-6 * 0.3e6);
  ASSERT_EQ(result.material.limits.size(), 1u);
  EXPECT_EQ(result.material.limits.front().energy, value_of(result, "J.limit"));
  for (const ExperimentResult& e : result.experiments) EXPECT_GT(e.r_squared.value(), 1 - 1e-9);
}

TEST(SlowSolidLimits, KnowsTheErrorOfALimitOfEnergy) {
  constexpr int kSeeds = 3;
  int covered = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const LabFolder folder(limited_rubber(2000, static_cast<std::uint64_t>(seed)));
    const StudyResult result = fit_of_limit(folder, "law: neo-hookean, limits: [{of: [J]}]");
    const NumberError& error = result.material.limits.front().errors.at("energy");
    ASSERT_TRUE(error.std_error.has_value());
    EXPECT_LT(*error.std_error, 0.05 * 5e3);
    covered += std::abs(value_of(result, "J.limit") - 5e3) < 2 * *error.std_error;
  }
  // 95 % of 3; fewer than 2 would come by chance in one of 140.
  EXPECT_GE(covered, 2);
}

TEST(SolidLimits, ALimitThatNothingReachesIsNotDetermined) {
  const LabFolder folder(
      test::measurements_of(test::lab_of(stvk_solid(2e6, 0.6e6), test::three_modes()), 1));
  const StudyResult result = fit_of_limit(folder, "law: stvk, limits: [{of: [trace]}]");
  EXPECT_EQ(result.material.limits.front().errors.at("energy").determined, Determination::none);
  EXPECT_NEAR(value_of(result, "trace.k"), 2e6, 1e-4 * 2e6);
}

/// Of all residuals, in % of the largest stress.
double misfit_of(const StudyResult& result) {
  double squares = 0;
  for (const ExperimentResult& e : result.experiments) squares += e.rms_percent * e.rms_percent;
  return std::sqrt(squares / static_cast<double>(result.experiments.size()));
}

/// A fit in turns as it stands ([T] 4.4): the law with the limit as it is, then the limit with the
/// law as it is.
struct Turn {
  double limit = 0, stiffness = 0, misfit = 0;
};

Turn turn_from(double limit, const auto& fitted) {
  const StudyResult law = fitted(fmt::format("fit: {{fix: {{J.limit: {}}}}}\n", limit));
  const double c = value_of(law, "I1-bar.linear.c"), k = value_of(law, "J.k");
  const StudyResult next =
      fitted(fmt::format("fit: {{fix: {{I1-bar.linear.c: {}, J.k: {}}}}}\n", c, k));
  return {value_of(next, "J.limit"), k, misfit_of(next)};
}

TEST(SlowSolidLimits, FoundInTurnsWithTheLawGoTheSameWaySlowly) {
  const test::MeasuredFiles measured = limited_rubber(2000, 3);
  const auto fitted = [&](const std::string& more) {
    return fit_of_limit(LabFolder(measured), "law: neo-hookean, limits: [{of: [J]}]", more);
  };
  const StudyResult together = fitted("");
  const double limit = value_of(together, "J.limit");
  const Turn there = turn_from(limit, fitted);
  EXPECT_NEAR(there.limit, limit, 2e-3 * limit);
  EXPECT_NEAR(there.stiffness, value_of(together, "J.k"), 2e-3 * there.stiffness);
  Turn before{8e3, 0, INFINITY};
  for (int turn = 0; turn < 3; ++turn) {
    const Turn now = turn_from(before.limit, fitted);
    EXPECT_LT(now.misfit, before.misfit);
    EXPECT_LT(now.limit, before.limit);
    before = now;
  }
  // Together at once what three turns are not half the way to.
  EXPECT_GT(before.limit - limit, (8e3 - limit) / 2);
  EXPECT_GT(before.misfit, 1.5 * misfit_of(together));
}

}  // namespace
}  // namespace pliant
