#include "pliant/estimation/profile_likelihood.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using test::estimate_named;
using test::hung_weights;
using test::lab_of;
using test::published_fabric;
using test::VirtualStudy;

VirtualLab noisy_weights(const std::string& fabric, double noise) {
  auto experiment = hung_weights();
  experiment.instrument.length_noise = noise;
  return lab_of(published_fabric(fabric), experiment);
}

StudyResult fit_with_profiles(const VirtualLab& lab, const std::string& pattern) {
  return VirtualStudy(lab).fit({.compare_friction = false, .profiles = {pattern}});
}

TEST(ProfileLikelihood, AgreesWithTheIntervalOfAWellDeterminedParameter) {
  const StudyResult result = fit_with_profiles(noisy_weights("polyester", 0.1e-3), "*");
  ASSERT_EQ(result.profiles.size(), 5u);
  for (const Profile& profile : result.profiles) {
    const ParameterEstimate p = estimate_named(result, profile.parameter);
    ASSERT_TRUE(profile.lower && profile.upper) << profile.parameter;
    // Linearised and profiled intervals differ by the curvature of the problem: some percent at
    // this noise.
    const double width = *p.upper - *p.lower;
    EXPECT_NEAR(*profile.lower, *p.lower, 0.1 * width) << profile.parameter;
    EXPECT_NEAR(*profile.upper, *p.upper, 0.1 * width) << profile.parameter;
    EXPECT_NEAR(*profile.upper - *profile.lower, width, 0.1 * width) << profile.parameter;
  }
}

TEST(ProfileLikelihood, RisesFromTheEstimateToBothSides) {
  const StudyResult result =
      fit_with_profiles(noisy_weights("polyester", 0.2e-3), "stretch.warp.friction.a");
  ASSERT_EQ(result.profiles.size(), 1u);
  const Profile& profile = result.profiles.front();
  ASSERT_TRUE(std::is_sorted(profile.value.begin(), profile.value.end()));
  const auto lowest = std::min_element(profile.delta_chi2.begin(), profile.delta_chi2.end());
  const auto middle = static_cast<size_t>(lowest - profile.delta_chi2.begin());
  EXPECT_DOUBLE_EQ(profile.value[middle], estimate_named(result, profile.parameter).value);
  EXPECT_TRUE(std::is_sorted(profile.delta_chi2.begin(), lowest, std::greater<>()));
  EXPECT_TRUE(std::is_sorted(lowest, profile.delta_chi2.end()));
}

// Weights that step by 1 N hardly see a tau as small as cotton's: large values are excluded, small
// ones are not.
TEST(ProfileLikelihood, OfAPoorlyDeterminedParameterIsLopsided) {
  const StudyResult result =
      fit_with_profiles(noisy_weights("cotton", 1e-3), "stretch.warp.friction.tau");
  ASSERT_EQ(result.profiles.size(), 1u);
  const Profile& profile = result.profiles.front();
  const double estimate = estimate_named(result, profile.parameter).value;
  if (profile.lower && profile.upper) {
    const double left = estimate - *profile.lower, right = *profile.upper - estimate;
    EXPECT_GT(std::max(left, right), 1.2 * std::min(left, right));
  } else {
    EXPECT_TRUE(profile.upper.has_value()) << "large values of tau are excluded by the data";
  }
}

TEST(ProfileLikelihood, IsMadeForNoFixedParameter) {
  VirtualStudy study(noisy_weights("cotton", 0.2e-3));
  study.add("fit: {fix: {'*.friction.b': 3}}");
  const StudyResult result = study.fit({.compare_friction = false, .profiles = {"*.friction.*"}});
  ASSERT_EQ(result.profiles.size(), 2u);
}

}  // namespace
}  // namespace pliant
