// The standards' own recipes, applied to loops that virtual instruments draw, give the figures that
// the law has by itself.

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "pliant/estimation/lab_figures.h"
#include "pliant/experiment/bending/pure_bending_type.h"
#include "pliant/experiment/loop_figures.h"
#include "pliant/experiment/pulled_figures.h"
#include "pliant/experiment/shear/shear_cycles_type.h"
#include "pliant/experiment/tensile/tensile_cycles_type.h"
#include "pliant/study/study.h"

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using test::lab_of;
using test::made_up_material;
using test::VirtualStudy;

double figure_of(const std::vector<LabFigure>& figures, const std::string& name) {
  const auto found = std::ranges::find(figures, name, &LabFigure::name);
  EXPECT_NE(found, figures.end()) << name;
  return found == figures.end() ? 0 : found->value;
}

/// What the recipes read off the record of a virtual instrument.
std::vector<LoopFigure> read_off(const VirtualLab& lab) {
  const VirtualStudy files(lab);
  const Study study = files.study();
  const auto experiment = read_experiment(study.experiments.front(), study);
  return loop_figures(*experiment, experiment->measured());
}

void expect_within_a_hundredth(const Material& truth, const std::string& component,
                               const std::vector<LoopFigure>& read,
                               const std::vector<std::string>& names) {
  const std::vector<LabFigure> of_law = lab_figures(truth, component, {});
  for (const std::string& name : names) {
    const auto found = std::ranges::find(read, name, &LoopFigure::name);
    ASSERT_NE(found, read.end()) << name;
    const double expected = figure_of(of_law, name);
    EXPECT_NEAR(found->value, expected, 0.01 * expected) << name;
  }
}

TEST(StandardFigures, OfShearAreThoseOfTheLaw) {
  const Material truth =
      made_up_material("shear", {ScalarCurve::affine(30, 60), FrictionLaw::dahl, {0.8, 6, 0.01}});
  VirtualShearCycles test;
  test.name = "shear";
  test.peaks = {8 * std::numbers::pi / 180};
  test.repeats = 4;
  expect_within_a_hundredth(truth, "shear", read_off(lab_of(truth, test)),
                            {"kes_G", "kes_2HG", "kes_2HG5"});
}

TEST(StandardFigures, OfBendingAreThoseOfTheLaw) {
  const Material truth = made_up_material(
      "bend.warp", {ScalarCurve::affine(3e-6, 4e-9), FrictionLaw::dahl, {2e-4, 1e-7, 30}});
  VirtualPureBending test;
  test.name = "bending";
  test.direction = "warp";
  test.peaks = {250};
  test.repeats = 4;
  expect_within_a_hundredth(truth, "bend.warp", read_off(lab_of(truth, test)),
                            {"kes_B", "kes_2HB"});
}

TEST(StandardFigures, OfAPullAreThoseOfTheLaw) {
  const ComponentLaw law{ScalarCurve::affine(4000, 9000), FrictionLaw::dahl, {20, 30, 0.01}};
  const Material truth = made_up_material("stretch.warp", law);
  const auto cycle = pulled_to(law, truth.membrane, kKesTensileLoad);
  ASSERT_TRUE(cycle);
  VirtualTensileCycles test;
  test.name = "pull";
  test.direction = "warp";
  test.peaks = {1.01 * cycle->out.extension.back()};
  test.samples = 400;
  const std::vector<LoopFigure> read = read_off(lab_of(truth, test));
  expect_within_a_hundredth(
      truth, "stretch.warp", read,
      {"kes_EMT", "kes_LT", "kes_WT", "kes_RT", "fast_E5", "fast_E20", "fast_E100"});
  EXPECT_TRUE(std::ranges::any_of(read, [](const LoopFigure& figure) {
    return figure.name == "iso_permanent" && figure.value > 0;
  }));
}

// A fit carries the errors of its numbers to the figures, and compares them with what was measured.
TEST(StandardFigures, OfAFitHaveErrorsAndWhatWasMeasured) {
  const Material truth =
      made_up_material("shear", {ScalarCurve::affine(30, 60), FrictionLaw::dahl, {0.8, 6, 0.01}});
  VirtualShearCycles test;
  test.name = "shear";
  test.peaks = {0.05, 8 * std::numbers::pi / 180};
  test.instrument.force_noise = 0.05;
  VirtualStudy study(lab_of(truth, test));
  study.set_model("stiffness: affine");
  const StudyResult result = study.fit();
  const std::vector<LabFigure> of_law = lab_figures(truth, "shear", {});
  for (const char* name : {"kes_G", "kes_2HG", "kes_2HG5"}) {
    const auto found = std::ranges::find(result.figures, name, &LabFigure::name);
    ASSERT_NE(found, result.figures.end()) << name;
    ASSERT_TRUE(found->error) << name;
    EXPECT_LT(std::abs(found->value - figure_of(of_law, name)), 3 * found->error->std_error)
        << name;
  }
  EXPECT_EQ(result.experiments.front().measured_figures.size(),
            result.experiments.front().predicted_figures.size());
}

}  // namespace
}  // namespace pliant
