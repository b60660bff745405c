// Clamps that slip and an apparatus that gives way: strips of several lengths tell them from cloth.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "estimation/virtual_study.h"
#include "io/input_error_of.h"

namespace pliant {
namespace {

using test::estimate_named;
using test::lab_of;
using test::made_up_material;
using test::relative_error;
using test::VirtualStudy;
using ::testing::HasSubstr;

constexpr double kSlip = 6e-5, kCompliance = 3e-5;  // m/N

Material knit() {
  return made_up_material("stretch.warp",
                          {ScalarCurve::affine(250, 150), FrictionLaw::dahl, {4, 8, 0.02}});
}

VirtualTensileCycles strip_of(double length, const char* name) {
  VirtualTensileCycles test;
  test.name = name;
  test.direction = "warp";
  test.length = length;
  test.width = 0.04;
  test.peaks = {0.1, 0.2, 0.4};
  test.clamps = {.slip = kSlip, .compliance = kCompliance};
  return test;
}

VirtualLab two_lengths(double force_noise = 0) {
  VirtualTensileCycles long_strip = strip_of(0.08, "long"), short_strip = strip_of(0.02, "short");
  long_strip.instrument.force_noise = short_strip.instrument.force_noise = force_noise;
  return lab_of(knit(), {long_strip, short_strip});
}

StudyResult fitted(const VirtualLab& lab, const std::string& fields) {
  VirtualStudy study(lab);
  study.set_model("stiffness: affine");
  study.add(fields);
  return study.fit();
}

TEST(Apparatus, IsFoundFromStripsOfTwoLengths) {
  const StudyResult result =
      fitted(two_lengths(), "defaults: {slip: unknown, compliance: unknown}");
  const Material truth = knit();
  for (const ParameterEstimate& p : result.parameters) {
    EXPECT_LT(relative_error(result, truth, p.name), 2e-3) << p.name;
  }
  for (const std::string strip : {"long", "short"}) {
    EXPECT_NEAR(estimate_named(result, strip + ".slip").value, kSlip, 0.02 * kSlip) << strip;
    EXPECT_NEAR(estimate_named(result, strip + ".compliance").value, kCompliance,
                0.05 * kCompliance)
        << strip;
  }
}

TEST(Apparatus, OfCoarseReadingsIsFoundWithinItsErrors) {
  const StudyResult result =
      fitted(two_lengths(0.02), "defaults: {slip: unknown, compliance: unknown}");
  const Material truth = knit();
  for (const ParameterEstimate& p : result.parameters) {
    EXPECT_LT(std::abs(p.value - test::truth_of(truth, p.name)), 3 * p.std_error.value()) << p.name;
  }
}

// Known numbers are taken off, in predictions too; left out they bend the material.
TEST(Apparatus, OfKnownNumbersIsTakenOff) {
  const StudyResult result = fitted(
      two_lengths(), "defaults: {slip: 0.06 mm/N, compliance: 0.03 mm/N}\nvalidate: [short]");
  EXPECT_LT(relative_error(result, knit(), "stretch.warp.k1"), 1e-6);
  for (const ExperimentResult& experiment : result.experiments) {
    EXPECT_LT(experiment.rms_percent, 1e-3) << experiment.name;
  }
  EXPECT_GT(fitted(two_lengths(), "validate: [short]").experiments.back().rms_percent, 3);
}

TEST(Apparatus, IsRefusedByThePublishedEstimator) {
  const auto fit = [] {
    fitted(two_lengths(), "defaults: {slip: unknown}\nfit: {estimator: anchor}");
  };
  EXPECT_THAT(test::input_error_of(fit).what(), HasSubstr("slip"));
}

}  // namespace
}  // namespace pliant
