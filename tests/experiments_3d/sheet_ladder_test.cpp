// [T] Table 4.1: a material grows by one addend after the other. Here the cloth is known, and so is
// which of them its data have.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/material/density/cross_modal_strain.h"
#include "pliant/study/study_fit.h"

#include "support/five_sheet_tests.h"

namespace pliant {
namespace {

struct Rung {
  const char *adds, *model;
  bool in_data;
};

const std::vector<Rung>& ladder() {
  static const std::vector<Rung> rungs{
      {"isotropic StVK",
       ", variant: linear-isotropic, components: {coupling: {stiffness: constant}}", false},
      {"anisotropic stretch",
       ", variant: linear-orthotropic, components: {coupling: {stiffness: constant}}", true},
      {"nonlinear stretch",
       ", variant: linear-orthotropic, components: {coupling: {stiffness: constant}, stretch.weft: "
       "{stiffness: hermite}, stretch.warp: {stiffness: hermite}}",
       false},
      {"nonlinear shear",
       ", variant: linear-orthotropic, components: {coupling: {stiffness: constant}, stretch.weft: "
       "{stiffness: hermite}, stretch.warp: {stiffness: hermite}, shear: {stiffness: hermite}}",
       true},
      {"nonlinear coupling",
       ", variant: linear-orthotropic, components: {coupling: {stiffness: hermite}, stretch.weft: "
       "{stiffness: hermite}, stretch.warp: {stiffness: hermite}, shear: {stiffness: hermite}}",
       false},
      {"cross-modal stiffening",
       ", variant: linear-orthotropic, components: {coupling: {stiffness: hermite}, stretch.weft: "
       "{stiffness: hermite}, stretch.warp: {stiffness: hermite}, shear: {stiffness: hermite}, "
       "cross-modal: {stiffness: constant}}",
       true}};
  return rungs;
}

/// Warp more than twice as stiff as weft, shear that stiffens, a coupling of both stretches, and
/// cross-modal stiffening.
Material known_cloth() {
  Material cloth = test::sheet_cloth(false);
  cloth.components["shear"].stiffness = ScalarCurve::hermite({0, 0.5}, {8, 40}, true);
  cloth.components[kCoupling].stiffness = ScalarCurve::constant(60);
  cloth.components[kCrossModal].stiffness = ScalarCurve::constant(300);
  return cloth;
}

/// Root mean square of the forces' errors over their peaks.
double misfit(const StudyResult& result) {
  double sum = 0;
  int count = 0;
  for (const ExperimentResult& e : result.experiments) {
    if (e.quantity.kind != "force") continue;
    sum += e.rms_percent * e.rms_percent;
    ++count;
  }
  return std::sqrt(sum / count);
}

TEST(SlowSheetLadder, TheErrorFallsWhereWhatTheDataHasIsAdded) {
  fmt::print("{:<30} {:>8} {:>8}\n", "with", "numbers", "error, %");
  double before = INFINITY;
  for (const Rung& rung : ladder()) {
    const test::FiveSheetTests tests(known_cloth(), rung.model, 9, 4);
    RunContext context;
    context.threads = 2;
    const StudyResult result = fit_study(tests.study(), {}, context);
    const double error = misfit(result);
    fmt::print("{:<30} {:>8} {:8.3f}\n", rung.adds, result.parameters.size(), error);
    const double least = rung.in_data ? 0 : 0.8, most = rung.in_data ? 0.7 : INFINITY;
    if (std::isfinite(before)) {
      EXPECT_GE(error, least * before) << rung.adds;
      EXPECT_LE(error, most * before) << rung.adds;
    }
    before = error;
  }
}

}  // namespace
}  // namespace pliant
