// Energies that are interpolated ([T] 4.2.2, 4.2.3, 4.3.3): cubic Hermite ones of one strain, and
// bilinear and Gaussian terms of two, kept convex.

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/estimation/solid/convexity.h"
#include "pliant/material/solid/pair_metric.h"
#include "pliant/material/solid/standard_solids.h"
#include "pliant/math/hermite_energy.h"

#include "io/input_error_of.h"
#include "solids/solid_labs.h"

namespace pliant {
namespace {

using test::component_of;
using test::LabFolder;
using test::linear;
using test::ogden;
using test::solid_of;
using test::solid_study;
using test::value_of;
using ::testing::HasSubstr;

constexpr const char* kPair = "green.xx*green.yy";

/// The fit of a model to virtual measurements of a material.
StudyResult fit(const Material& truth, const std::vector<test::AnyTest>& tests,
                const std::string& model, const std::string& more = "") {
  const LabFolder folder(test::measurements_of(test::lab_of(truth, tests), 1));
  return fit_study(solid_study(folder, model, more), {}, {});
}

/// Pulls along both axes, in five ratios.
std::vector<test::AnyTest> biaxial_pulls(double noise = 0) {
  std::vector<test::AnyTest> tests;
  for (const auto& [x, y] :
       {std::pair{1.5, 1.0}, {1.5, 1.25}, {1.5, 1.5}, {1.25, 1.5}, {1.1, 1.5}}) {
    VirtualHomogeneous test = test::homogeneous(HomogeneousMode::biaxial, {x});
    test.name = fmt::format("pull-{}-{}", static_cast<int>(100 * x), static_cast<int>(100 * y));
    test.peaks_2 = {y};
    test.noise = noise;
    tests.emplace_back(test);
  }
  return tests;
}

/// Alike along x and y, whose stresses along y no test measures.
/// @param term   a pair of strains
/// @param cross  of the bilinear or Gaussian term
Material crossed(const std::string& term, double cross) {
  return solid_of({{"I1-bar", component_of({linear(1e5)})},
                   {"trace-of-square", component_of({linear(1.5e5)})},
                   {term, component_of({linear(cross)})}});
}

std::string model_with(const std::string& pair_model) {
  return fmt::format(
      "components: {{I1-bar: {{addends: [linear]}}, trace-of-square: {{addends: [linear]}}, "
      "{}: {}}}",
      kPair, pair_model);
}

TEST(InterpolatedEnergies, AHermiteEnergyMeetsStVKExactly) {
  const StudyResult result =
      fit(stvk_solid(2e6, 0.6e6), test::three_modes(),
          "components: {trace: {stiffness: energy}, trace-of-square: {addends: [linear]}}");
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(value_of(result, "trace-of-square.linear.c"), 0.6e6, 1e-8 * 0.6e6);
  EXPECT_NE(result.stages.back().ended, "");
  const ScalarCurve& trace = *result.material.components.at("trace").stiffness;
  for (const double strain : {0.2, 1.0, 4.0}) {
    EXPECT_NEAR(trace.first_moment(strain), 1e6 * strain * strain, 1e-8 * 1e6 * strain * strain);
  }
}

TEST(SlowInterpolatedEnergies, AConvexHermiteEnergyFollowsOgdensMaterial) {
  const StudyResult result =
      fit(solid_of({{"stretch-bar", component_of({ogden(0.5e6, 1.4), ogden(3e3, 5)})}}),
          test::three_modes(1000),
          "components: {stretch-bar: {stiffness: energy, addends: [linear]}, I2-bar: {addends: "
          "[linear]}}");
  for (const ExperimentResult& e : result.experiments) EXPECT_GT(e.r_squared.value(), 0.999);
  const ScalarCurve& energy = *result.material.components.at("stretch-bar").stiffness;
  EXPECT_EQ(energy.kind(), CurveKind::energy);
  EXPECT_GT(energy.size(), 2);
  const Eigen::Map<const Eigen::VectorXd> values(energy.values().data(), energy.size());
  const Eigen::VectorXd curvatures = hermite_energy_curvatures(energy.knots()) * values;
  EXPECT_GT(curvatures.minCoeff(), -1e-6 * curvatures.maxCoeff());
}

TEST(InterpolatedEnergies, FindsABilinearTerm) {
  const StudyResult result =
      fit(crossed(kPair, 1e5), biaxial_pulls(), model_with("{addends: [linear]}"));
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(value_of(result, "trace-of-square.linear.c"), 1.5e5, 1e-6 * 1.5e5);
  EXPECT_NEAR(value_of(result, "green.xx*green.yy.linear.c"), 1e5, 1e-6 * 1e5);
  EXPECT_THAT(result.warnings, ::testing::Not(::testing::Contains(HasSubstr("convex"))));
}

TEST(InterpolatedEnergies, FindsAGaussianTerm) {
  const std::string term = "green.xx*green.yy@0.625/0.625~0.625/0.625";
  const StudyResult result = fit(crossed(term, 1e5), biaxial_pulls(), model_with("{gaussians: 1}"));
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(value_of(result, term + ".linear.c"), 1e5, 1e-6 * 1e5);
}

/// As the fit counts: in shares of the largest stress of each experiment.
double rms_of(const StudyResult& result) {
  double sum = 0;
  for (const ExperimentResult& e : result.experiments) sum += std::pow(e.rms / e.peak_force, 2);
  return std::sqrt(sum / static_cast<double>(result.experiments.size()));
}

// [T] 4.3.3, as published and by conditions within the search: materials whose terms of two strains
// are too strong to be convex.
TEST(SlowInterpolatedEnergies, StayConvexAndBestBySearchesWithin) {
  const PairDomain domain{{0, 1}, {{{0.0, 0.625}, {0.0, 0.625}}}};
  const std::vector<std::pair<Material, const char*>> cases{
      {crossed(kPair, 5e5), "{addends: [linear]}"},
      {crossed("green.xx*green.yy@0.625/0.625~0.3125/0.3125", 1e5), "{gaussians: 2}"}};
  for (const auto& [truth, model] : cases) {
    ASSERT_LT(least_convexity(truth, domain), -0.1);
    const auto fit_with = [&, &truth = truth, &model = model](const char* convexity) {
      return fit(truth, biaxial_pulls(2000), model_with(model),
                 fmt::format("fit: {{convexity: {}}}\n", convexity));
    };
    const StudyResult free = fit_with("free"), within = fit_with("within"),
                      projected = fit_with("projected");
    fmt::print("{:<20} rms, % of the peaks: free {:5.2f}, within {:5.2f}, projected {:5.2f}\n",
               model, 100 * rms_of(free), 100 * rms_of(within), 100 * rms_of(projected));
    EXPECT_LT(least_convexity(free.material, domain), -0.01) << model;
    EXPECT_GT(least_convexity(within.material, domain), -2e-6) << model;
    EXPECT_GT(least_convexity(projected.material, domain), -2e-6) << model;
    EXPECT_THAT(free.warnings, ::testing::Contains(HasSubstr("is not convex in green.xx")))
        << model;
    EXPECT_THAT(within.warnings, ::testing::Contains(HasSubstr("convexity in green.xx"))) << model;
    EXPECT_LT(rms_of(free), rms_of(within)) << model;
    EXPECT_LT(rms_of(within), rms_of(projected)) << model;
  }
}

TEST(InterpolatedEnergies, RefuseWhatCannotBeKeptConvexOrToldApart) {
  const auto refusal = [](const std::string& model) {
    const InputError error =
        test::input_error_of([&] { fit(crossed(kPair, 1e5), biaxial_pulls(), model); });
    return std::string(error.what());
  };
  EXPECT_THAT(
      refusal("components: {green.xx: {addends: [exponential]}, green.xx*green.yy: {addends: "
              "[linear]}}"),
      HasSubstr("cannot be kept convex"));
  EXPECT_THAT(refusal("components: {I1-bar: {addends: [linear]}, green.xx*green.yy: {}}"),
              HasSubstr("gaussians"));
  EXPECT_THAT(refusal("components: {I1-bar: {addends: [linear]}, green.xx*green.yz: {gaussians: "
                      "2}}"),
              HasSubstr("changes in no experiment"));
}

TEST(PairMetric, IsZeroWithItsSlopeWhereEitherStrainIs) {
  for (const char* name : {kPair, "green.xx*green.yz@0.3/-0.1~0.2/0.4"}) {
    const auto metric = find_pair_metric(name);
    ASSERT_TRUE(metric.has_value());
    EXPECT_EQ(metric->name(), name);
    Eigen::Array<double, kLanes, kSolidStrains> strain;
    strain.setConstant(0.3);
    strain.col(0) = 0;
    const MetricJet jet = metric->jet(LaneView(strain.data(), kLanes, kSolidStrains));
    EXPECT_EQ(jet.value.abs().maxCoeff(), 0);
    EXPECT_EQ(jet.gradient.col(metric->strains[1]).abs().maxCoeff(), 0);
  }
  for (const char* name : {"green.yy*green.xx", "green.xx*green.xx", "green.xx*I1", "green.xx*",
                           "green.xx*green.yy@0.1", "green.xx*green.yy@0.1/0.2~0/0.1"}) {
    EXPECT_FALSE(find_pair_metric(name).has_value()) << name;
  }
}

}  // namespace
}  // namespace pliant
