// Materials fitted to full-field sessions that were made with known ones.

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/experiment/session/virtual_session.h"
#include "pliant/geometry/irregular_mesh.h"
#include "pliant/material/material.h"
#include "pliant/study/study.h"
#include "pliant/study/study_fit.h"

#include "io/temporary_folder.h"
#include "support/five_sheet_tests.h"

namespace pliant {
namespace {

using FiveTests = test::FiveSheetTests;

double value_of(const StudyResult& result, const std::string& component, double strain) {
  return result.material.components.at(component).stiffness->value(strain);
}

RunContext two_threads() {
  RunContext context;
  context.threads = 2;
  return context;
}

TEST(SlowSheetRecovery, FindsTheStiffnessesOfNoiseFreeSessionsOnTheirOwnMesh) {
  const Material truth = test::sheet_cloth(false);
  const FiveTests tests(truth, ", variant: linear-orthotropic", 9, 5);
  const StudyResult result = fit_study(tests.study(), {}, two_threads());
  EXPECT_TRUE(result.converged);
  ASSERT_EQ(result.parameters.size(), 6u);
  for (const ParameterEstimate& p : result.parameters) {
    const double expected = truth.components.at(p.owner).stiffness->value(0);
    EXPECT_NEAR(p.value, expected, 1e-3 * expected) << p.name;
    EXPECT_TRUE(p.identified) << p.name;
    EXPECT_EQ(result.material.components.at(p.owner).status, ComponentStatus::measured);
  }
  for (const ExperimentResult& e : result.experiments) {
    EXPECT_LT(e.rms, e.quantity.kind == "force" ? 1e-3 : 1e-5) << e.name;
  }
}

TEST(SlowSheetRecovery, FindsCurvesThatRiseWithStrain) {
  const Material truth = test::sheet_cloth(true);
  const FiveTests tests(truth);
  const StudyResult result = fit_study(tests.study(), {}, two_threads());
  for (const auto& [name, component] : truth.components) {
    const auto range = result.material.components.at(name).range;
    ASSERT_TRUE(range.has_value()) << name;
    // Few elements strain as far as the last control points, where the curves of stretch, shear and
    // bending lean on each other.
    for (const double share : {0.25, 0.5, 0.75}) {
      const double strain = share * range->second;
      const double expected = component.stiffness->value(strain);
      EXPECT_NEAR(value_of(result, name, strain), expected, 0.05 * expected) << name << strain;
    }
  }
}

// What one thread resists where the other is stretched shows in the forces of all that is pulled.
TEST(SlowSheetRecovery, FindsWhatCouplesWeftAndWarp) {
  Material truth = test::sheet_cloth(false);
  truth.components[kCoupling].stiffness = ScalarCurve::constant(60);
  const FiveTests tests(truth, ", variant: linear-orthotropic, components: {coupling: {}}", 9, 5);
  const StudyResult result = fit_study(tests.study(), {}, two_threads());
  EXPECT_TRUE(result.converged);
  for (const auto& [name, component] : truth.components) {
    const double expected = component.stiffness->value(0);
    EXPECT_NEAR(value_of(result, name, 0), expected, 5e-3 * expected) << name;
  }
}

// What stiffens a sheet whichever way it is strained shows in stretch and shear together.
TEST(SlowSheetRecovery, FindsWhatStiffensAcrossModes) {
  Material truth = test::sheet_cloth(false);
  truth.components[kCrossModal].stiffness = ScalarCurve::constant(300);
  const FiveTests tests(truth, ", variant: linear-orthotropic, components: {cross-modal: {}}", 9,
                        4);
  const StudyResult result = fit_study(tests.study(), {}, two_threads());
  EXPECT_TRUE(result.converged);
  for (const auto& [name, component] : truth.components) {
    const double expected = component.stiffness->value(0);
    EXPECT_NEAR(value_of(result, name, 0), expected, 2e-2 * expected) << name;
  }
}

// Clips are 5 mm deep, cells about 6 mm wide and measured edges 3 mm long: only a grid with lines
// on the edges of clips holds the cloth that they hold. Without, shear is 10 % too soft.
TEST(SlowSheetRecovery, FindsTheStiffnessesOfSheetsThatWereMeasuredOnAnIrregularMesh) {
  if (!has_irregular_meshes()) GTEST_SKIP() << "built without CGAL";
  const Material truth = test::sheet_cloth(false);
  test::TemporaryFolder folder;
  std::string text = "pliant: study/1\nname: three\nexperiments:\n";
  RandomStream unused(1);
  for (const char* test : {"stretch-weft", "stretch-warp", "shear"}) {
    VirtualSession options = usual_session(test);
    options.frames = 5;
    options.edge = 0.003;
    write_session(folder.path() / test, make_virtual_session(truth, options, unused));
    text += fmt::format("  - {{name: {0}, type: session, data: {0}}}\n", test);
  }
  text += "model: {mesh: {edge: 6 mm}, variant: linear-orthotropic, friction: none}\n";
  folder.write("study.yaml", text);
  const StudyResult result = fit_study(read_study(folder.path() / "study.yaml"), {}, two_threads());
  for (const char* name : {"stretch.weft", "stretch.warp", "shear"}) {
    const double expected = truth.components.at(name).stiffness->value(0);
    // Two meshes of a sheet differ by the squares of their edges.
    EXPECT_NEAR(value_of(result, name, 0), expected, 0.03 * expected) << name;
  }
}

TEST(SheetRecovery, TakesWarpToBendLikeWeftWhereWeftAloneIsMeasured) {
  const FiveTests tests(test::sheet_cloth(true), "", 9, 4);
  Study study = tests.study();
  std::erase_if(study.experiments, [](const ExperimentSpec& e) { return e.name != "bend-weft"; });
  const StudyResult result = fit_study(study, {}, two_threads());
  const auto& components = result.material.components;
  EXPECT_EQ(components.at("bend.warp").status, ComponentStatus::assumed);
  // It goes along while weft is fitted alone; weft and diagonal together follow.
  const double weft = value_of(result, "bend.weft", 0), warp = value_of(result, "bend.warp", 0);
  EXPECT_NEAR(warp, weft, 0.05 * weft);
  EXPECT_LT(result.experiments.front().rms, 1e-4);
}

}  // namespace
}  // namespace pliant
