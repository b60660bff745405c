#include "pliant/estimation/uncertainty.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using test::estimate_named;
using test::hung_weights;
using test::lab_of;
using test::published_fabric;
using test::strip_cycles;
using test::VirtualStudy;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

VirtualTensileCycles noisy_strip(double force_noise, double length_noise) {
  auto experiment = strip_cycles({0.05, 0.1, 0.2});
  experiment.instrument.force_noise = force_noise;
  experiment.instrument.length_noise = length_noise;
  return experiment;
}

StudyResult fit_affine(const VirtualLab& lab, const std::string& stated = "") {
  VirtualStudy study(lab);
  study.set_model("stiffness: affine");
  if (!stated.empty()) study.add_to_experiment("noise: {" + stated + "}");
  return study.fit();
}

TEST(StandardErrors, GrowWithTheNoise) {
  const Material fabric = published_fabric("polyester");
  const StudyResult small = fit_affine(lab_of(fabric, noisy_strip(2e-3, 0)));
  const StudyResult large = fit_affine(lab_of(fabric, noisy_strip(8e-3, 0)));
  for (size_t i = 0; i < small.parameters.size(); ++i) {
    // The same draws of noise, four times as large; the problem is nearly linear in them.
    EXPECT_NEAR(*large.parameters[i].std_error / *small.parameters[i].std_error, 4, 0.5)
        << small.parameters[i].name;
  }
}

TEST(StandardErrors, NeverFallBelowTheStatedNoise) {
  const Material fabric = published_fabric("polyester");
  const StudyResult estimated = fit_affine(lab_of(fabric, noisy_strip(2e-3, 0)));
  const StudyResult stated = fit_affine(lab_of(fabric, noisy_strip(2e-3, 0)), "force: 8 mN");
  // Four times the noise; the jackknife of six half cycles may find some of them to disagree.
  EXPECT_GT(*stated.parameters[0].std_error / *estimated.parameters[0].std_error, 3);
}

TEST(StandardErrors, StatedNoiseThatTheResidualsExceedDoesNotHideThem) {
  const Material fabric = published_fabric("polyester");
  const StudyResult estimated = fit_affine(lab_of(fabric, noisy_strip(8e-3, 0)));
  const StudyResult stated = fit_affine(lab_of(fabric, noisy_strip(8e-3, 0)), "force: 1 mN");
  EXPECT_NEAR(*stated.parameters[0].std_error / *estimated.parameters[0].std_error, 1, 0.1);
  EXPECT_THAT(stated.warnings, Contains(HasSubstr("times its stated noise")));
  const StudyResult right = fit_affine(lab_of(fabric, noisy_strip(8e-3, 0)), "force: 8 mN");
  EXPECT_THAT(right.warnings, Not(Contains(HasSubstr("stated noise"))));
}

// What is pushed to its bound by noise might be elsewhere, and the others with it.
TEST(StandardErrors, OfTheOthersCountAParameterAtItsBound) {
  const VirtualLab lab = lab_of(published_fabric("polyester"), noisy_strip(8e-3, 0));
  const auto with = [&](const std::string& fit) {
    VirtualStudy study(lab);
    study.set_model("stiffness: affine");
    study.add(fit);
    return study.fit();
  };
  // Held where the data would have it, then kept there by a bound that is next to it.
  const ParameterEstimate a = estimate_named(fit_affine(lab), "stretch.warp.friction.a");
  const std::string least = fmt::format("{}", a.value + 0.01 * *a.std_error);
  const StudyResult fixed = with("fit: {fix: {stretch.warp.friction.a: " + least + "}}");
  const StudyResult bounded =
      with("fit: {bounds: {stretch.warp.friction.a: [" + least + ", 1000]}}");
  const ParameterEstimate at_bound = estimate_named(bounded, "stretch.warp.friction.a");
  EXPECT_TRUE(at_bound.at_bound);
  EXPECT_FALSE(at_bound.std_error);
  const std::string b = "stretch.warp.friction.b";
  // As in the free fit, from which it is hardly apart.
  const double free = *estimate_named(fit_affine(lab), b).std_error;
  EXPECT_NEAR(*estimate_named(bounded, b).std_error, free, 0.02 * free);
  EXPECT_LT(*estimate_named(fixed, b).std_error, 0.8 * free);
}

// Errors in variables: noise of the length moves the force by the slope of the loop.
TEST(StandardErrors, CountStatedLengthNoise) {
  // Cotton pulls 5 mN more for 0.05 mm.
  const VirtualLab lab = lab_of(published_fabric("cotton"), noisy_strip(2e-3, 0));
  const StudyResult without = fit_affine(lab, "force: 2 mN");
  const StudyResult with = fit_affine(lab, "force: 2 mN, length: 0.05 mm");
  for (size_t i = 0; i < with.parameters.size(); ++i) {
    EXPECT_GT(*with.parameters[i].std_error, 1.5 * *without.parameters[i].std_error)
        << with.parameters[i].name;
  }
}

/// Adds noise that remembers the row before it (AR(1)).
void add_correlated_noise(VirtualStudy::Rows& rows, double sd, double memory, std::uint64_t seed) {
  RandomStream random(seed);
  double noise = sd * random.normal();
  for (std::vector<double>& row : rows) {
    row[0] += noise;
    noise = memory * noise + sd * std::sqrt(1 - memory * memory) * random.normal();
  }
}

StudyResult fit_correlated(double memory, std::uint64_t seed) {
  VirtualStudy study(lab_of(published_fabric("polyester"), noisy_strip(0, 0)));
  study.set_model("stiffness: affine");
  study.edit_rows("cycles.csv", [&](VirtualStudy::Rows& rows) {
    add_correlated_noise(rows, 5e-3, memory, seed);
  });
  return study.fit();
}

TEST(StandardErrors, GrowWhereNeighbouringResidualsGoTogether) {
  const StudyResult white = fit_correlated(0, 1);
  const StudyResult correlated = fit_correlated(0.8, 1);
  for (size_t i = 0; i < white.parameters.size(); ++i) {
    EXPECT_GT(*correlated.parameters[i].std_error, 1.5 * *white.parameters[i].std_error)
        << white.parameters[i].name;
  }
}

TEST(SlowStandardErrors, OfCorrelatedNoiseStillCoverTheTruthMostly) {
  const Material fabric = published_fabric("polyester");
  constexpr int kSeeds = 60;
  int covered = 0, identified = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const StudyResult result = fit_correlated(0.8, static_cast<std::uint64_t>(seed));
    for (const std::string& name : test::names_of(fabric, "stretch.warp")) {
      const ParameterEstimate p = estimate_named(result, name);
      const double truth = test::truth_of(fabric, name);
      if (!p.identified) continue;
      ++identified;
      if (*p.lower <= truth && truth <= *p.upper) ++covered;
    }
  }
  // One factor for all parameters is a rough correction: rough rates, but not those of errors a
  // third as large.
  const double rate = static_cast<double>(covered) / identified;
  EXPECT_GT(rate, 0.8);
}

TEST(Covariance, AgreesWithTheStandardErrors) {
  auto experiment = hung_weights();
  experiment.instrument.length_noise = 0.2e-3;
  const StudyResult result = VirtualStudy(lab_of(published_fabric("cotton"), experiment)).fit();
  ASSERT_EQ(result.covariance.rows(), 5);
  EXPECT_TRUE(result.covariance.isApprox(result.covariance.transpose()));
  for (Eigen::Index i = 0; i < 5; ++i) {
    EXPECT_DOUBLE_EQ(std::sqrt(result.covariance(i, i)),
                     *result.parameters[static_cast<size_t>(i)].std_error);
  }
  ASSERT_EQ(result.singular_values.at("stretch.warp").size(), 5);
  EXPECT_GT(result.singular_values.at("stretch.warp").minCoeff(), 0);
}

}  // namespace
}  // namespace pliant
