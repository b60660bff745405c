// Additive energies of cloth ([T] 4.2) from sessions: metrics of triangles, terms of two strains,
// energies by their control points, limits of energy.

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/material/addend/rubber_addends.h"
#include "pliant/material/material.h"
#include "pliant/study/study_fit.h"

#include "support/five_sheet_tests.h"

namespace pliant {
namespace {

StudyResult fitted(const Material& truth, const std::string& components,
                   const std::string& more = "", bool positions = true, int frames = 5) {
  const test::FiveSheetTests tests(
      truth,
      fmt::format(", variant: linear-orthotropic, friction: none, components: {{{}}}{}", components,
                  more),
      9, frames, positions, /*bends=*/false);
  RunContext context;
  context.threads = 2;
  return fit_study(tests.study(), {}, context);
}

Material with_line(Material cloth, const std::string& pair, double c) {
  MaterialComponent& term = cloth.components[pair];
  term.stiffness = ScalarCurve::none();
  term.addends = {Addend(linear_addend(), Eigen::VectorXd::Constant(1, c))};
  return cloth;
}

const ParameterEstimate& parameter(const StudyResult& result, const std::string& name) {
  const auto found = std::ranges::find(result.parameters, name, &ParameterEstimate::name);
  EXPECT_NE(found, result.parameters.end()) << name;
  return *found;
}

void expect_within(const StudyResult& result, const std::string& name, double truth, double share) {
  EXPECT_NEAR(parameter(result, name).value, truth, share * truth) << name;
}

void expect_stiffness(const StudyResult& result, const std::string& component, double truth,
                      double share) {
  const double found = result.material.components.at(component).stiffness->value(0);
  EXPECT_NEAR(found, truth, share * truth) << component;
}

TEST(SlowSheetAdditive, FindsMetricsOfTriangles) {
  for (const char* metric : {"area", "log-area", "invariant.1", "principal.stretch"}) {
    Material truth = test::sheet_cloth(false);
    truth.components[metric].stiffness = ScalarCurve::constant(40);
    const StudyResult result = fitted(truth, fmt::format("{}: {{}}", metric));
    EXPECT_TRUE(result.converged) << metric;
    expect_stiffness(result, metric, 40, 0.03);
    expect_stiffness(result, "stretch.weft", 80, 0.03);
    expect_stiffness(result, "shear", 8, 0.03);
  }
}

TEST(SlowSheetAdditive, FindsTermsOfTwoStrains) {
  const Material truth = with_line(test::sheet_cloth(false), "stretch.weft*stretch.warp", 30);
  const StudyResult result = fitted(truth, "stretch.weft*stretch.warp: {addends: [linear]}");
  expect_within(result, "stretch.weft*stretch.warp.linear.c", 30, 0.03);
}

TEST(SlowSheetAdditive, PlacesGaussiansOverTheStrainsOfTheSheets) {
  const Material truth = with_line(test::sheet_cloth(false), "stretch.weft*stretch.warp", 60);
  const StudyResult without = fitted(truth, "");
  const StudyResult with = fitted(truth, "stretch.weft*stretch.warp: {gaussians: 2}");
  EXPECT_EQ(with.parameters.size(), without.parameters.size() + 4);
  for (std::size_t i = 0; i < with.experiments.size(); ++i) {
    const ExperimentResult &one = with.experiments[i], &other = without.experiments[i];
    if (one.name == "stretch-weft-shape") {
      EXPECT_LT(one.rms, other.rms / 5);
    }
  }
}

TEST(SlowSheetAdditive, GrowsEnergiesByTheirControlPoints) {
  Material truth = test::sheet_cloth(true);
  for (const char* kind : {"spline", "energy"}) {
    const StudyResult result =
        fitted(truth,
               fmt::format("stretch.weft: {{stiffness: {0}}}, stretch.warp: {{stiffness: {0}}}, "
                           "shear: {{stiffness: {0}}}",
                           kind),
               "", /*positions=*/false, /*frames=*/8);
    for (const char* name : {"stretch.weft", "stretch.warp", "shear"}) {
      const MaterialComponent& found = result.material.components.at(name);
      EXPECT_EQ(name_of(found.stiffness->kind()), kind) << name;
      const ComponentLaw law = law_of(found), known = law_of(truth.components.at(name));
      const double strain = found.range->second / 2;
      EXPECT_NEAR(law.elastic_stress(strain), known.elastic_stress(strain),
                  0.05 * known.elastic_stress(strain))
          << kind << name;
    }
  }
}

/// The root mean square of what is left of the forces of a session (N).
double force_error(const StudyResult& result, const std::string& name) {
  return std::ranges::find(result.experiments, name, &ExperimentResult::name)->rms;
}

// Yarns jam: however much stress, shear goes no further.
TEST(SlowSheetAdditive, FindsALimitOfEnergy) {
  Material truth = test::sheet_cloth(false);
  truth.limits = {{{"shear"}, 0.25}};
  const StudyResult without = fitted(truth, "");
  const StudyResult result = fitted(truth, "", ", limits: [{of: [shear]}]");
  expect_within(result, "shear.limit", 0.25, 0.03);
  expect_stiffness(result, "shear", 8, 0.05);
  EXPECT_EQ(parameter(result, "shear.limit").unit, "J/m^2");
  ASSERT_EQ(result.material.limits.size(), 1u);
  EXPECT_LT(force_error(result, "shear"), force_error(without, "shear") / 5);
}

}  // namespace
}  // namespace pliant
