// Several specimens of one fabric: a pooled fit, and the spread between them.

#include <cmath>

#include <gtest/gtest.h>

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using test::estimate_named;
using test::hung_weights;
using test::lab_of;
using test::published_fabric;
using test::strip_cycles;
using test::truth_of;
using test::VirtualStudy;

template <class Test>
VirtualLab varied(const Test& experiment, int specimens) {
  VirtualLab lab = lab_of(published_fabric("polyester"), experiment);
  lab.specimens = specimens;
  lab.specimen_variation = 0.05;
  return lab;
}

constexpr int kSpecimens = 12;
// A standard deviation from n specimens scatters by 1 / sqrt(2 (n - 1)): 21 % here. Three times
// that.
constexpr double kSamplingError = 3 * 0.21;

TEST(SpreadBetweenSpecimens, OfHungWeightsIsThatOfTheSpecimens) {
  const VirtualLab lab = varied(hung_weights(), kSpecimens);
  const StudyResult result = VirtualStudy(lab).fit();
  EXPECT_EQ(result.experiments.front().specimens.size(), static_cast<size_t>(kSpecimens));
  for (const std::string& name : test::names_of(lab.material, "stretch.warp")) {
    const ParameterEstimate p = estimate_named(result, name);
    ASSERT_TRUE(p.between_specimen_sd.has_value()) << name;
    const double expected = 0.05 * truth_of(lab.material, name);
    EXPECT_NEAR(*p.between_specimen_sd, expected, kSamplingError * expected) << name;
    // The pooled fit is near the mean of the specimens: 5 % / sqrt(12), three times, and a little
    // for curvature.
    EXPECT_NEAR(p.value / truth_of(lab.material, name), 1, 0.05) << name;
  }
}

TEST(SlowSpreadBetweenSpecimens, OfStripCyclesIsThatOfTheSpecimens) {
  const VirtualLab lab = varied(strip_cycles({0.05, 0.1, 0.2}), kSpecimens);
  VirtualStudy study(lab);
  study.set_model("stiffness: affine");
  const StudyResult result = study.fit();
  // Each specimen has a force offset of its own.
  EXPECT_EQ(result.nuisance.size(), static_cast<size_t>(kSpecimens));
  for (const std::string& name : test::names_of(lab.material, "stretch.warp")) {
    const ParameterEstimate p = estimate_named(result, name);
    ASSERT_TRUE(p.between_specimen_sd.has_value()) << name;
    const double expected = 0.05 * truth_of(lab.material, name);
    EXPECT_NEAR(*p.between_specimen_sd, expected, kSamplingError * expected) << name;
  }
}

TEST(SpreadBetweenSpecimens, IsUnknownForOne) {
  const StudyResult result = VirtualStudy(lab_of(published_fabric("cotton"), hung_weights())).fit();
  for (const ParameterEstimate& p : result.parameters) {
    EXPECT_FALSE(p.between_specimen_sd.has_value()) << p.name;
  }
}

TEST(SpreadBetweenSpecimens, IsNearlyNothingForEqualSpecimens) {
  VirtualLab lab = lab_of(published_fabric("cotton"), hung_weights());
  lab.specimens = 3;
  const StudyResult result = VirtualStudy(lab).fit();
  for (const ParameterEstimate& p : result.parameters) {
    EXPECT_LT(p.between_specimen_sd.value_or(1), 1e-6 * p.value) << p.name;  // as exact as the fit
  }
}

}  // namespace
}  // namespace pliant
