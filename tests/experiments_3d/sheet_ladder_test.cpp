// [T] Table 4.1: a material grows by one addend after the other. Here the cloth is known, and so is
// which of them its data have.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/material/material.h"
#include "pliant/study/study_fit.h"

#include "support/asked_for.h"
#include "support/five_sheet_tests.h"

namespace pliant {
namespace {

struct Rung {
  const char *adds, *components;
  bool in_data;
};

/// Each rung has what those before it have.
const std::vector<Rung>& ladder() {
  static const std::vector<Rung> rungs{
      {"isotropic StVK", "", false},
      {"anisotropic stretch", "", true},
      {"nonlinear stretch",
       "stretch.weft: {stiffness: hermite}, stretch.warp: {stiffness: hermite}", false},
      {"nonlinear shear", "shear: {stiffness: hermite}", true},
      {"anisotropic shear",
       "stretch.weft*shear: {addends: [linear]}, stretch.warp*shear: {addends: [linear]}", false},
      {"area preservation", "area: {stiffness: constant}", true},
      {"cross-modal stiffening", "cross-modal: {stiffness: constant}", true}};
  return rungs;
}

/// What the model of a study says up to a rung.
std::string model_of(std::size_t last) {
  std::string components;
  for (std::size_t i = 0; i <= last; ++i) {
    const char* own = ladder()[i].components;
    if (*own == 0) continue;
    if (!components.empty()) components += ", ";
    components += own;
  }
  return fmt::format(", variant: linear-{}, components: {{{}}}",
                     last == 0 ? "isotropic" : "orthotropic", components);
}

/// Warp more than twice as stiff as weft, shear that stiffens, Poisson's effect by the area that
/// the cloth would keep, and cross-modal stiffening.
Material known_cloth() {
  Material cloth = test::sheet_cloth(false);
  cloth.components["shear"].stiffness = ScalarCurve::hermite({0, 0.5}, {8, 40}, true);
  cloth.components["area"].stiffness = ScalarCurve::constant(200);
  cloth.components[kCrossModal].stiffness = ScalarCurve::constant(300);
  return cloth;
}

/// Root mean squares of what is left of the positions (mm) and of the forces (N) of the sheets
/// between clips: the columns of Table 4.1.
struct Misfit {
  double position = 0, force = 0;
};

Misfit misfit_of(const StudyResult& result) {
  Misfit misfit;
  int shapes = 0, pulls = 0;
  for (const ExperimentResult& e : result.experiments) {
    if (e.name.ends_with("-shape")) {
      misfit.position += e.rms * e.rms;
      ++shapes;
    } else if (e.quantity.kind == "force") {
      misfit.force += e.rms * e.rms;
      ++pulls;
    }
  }
  return {1e3 * std::sqrt(misfit.position / shapes), std::sqrt(misfit.force / pulls)};
}

TEST(SlowSheetLadder, TheErrorFallsWhereWhatTheDataHasIsAdded) {
  fmt::print("{:<24} {:>8} {:>14} {:>9}\n", "with", "numbers", "positions, mm", "forces, N");
  Misfit before{INFINITY, INFINITY};
  for (std::size_t i = 0; i < ladder().size(); ++i) {
    const Rung& rung = ladder()[i];
    const test::FiveSheetTests tests(known_cloth(), model_of(i), 9, 4, /*positions=*/true,
                                     /*bends=*/test::makes_figures());
    RunContext context;
    context.threads = 2;
    const StudyResult result = fit_study(tests.study(), {}, context);
    const Misfit misfit = misfit_of(result);
    fmt::print("{:<24} {:>8} {:14.5f} {:9.5f}\n", rung.adds, result.parameters.size(),
               misfit.position, misfit.force);
    if (std::isfinite(before.force)) {
      // What one of both tells best falls; what the data lacks moves neither.
      const double fall = std::min(misfit.position / before.position, misfit.force / before.force);
      if (rung.in_data) {
        EXPECT_LE(fall, 0.7) << rung.adds;
      } else {
        EXPECT_GE(fall, 0.8) << rung.adds;
      }
    }
    before = misfit;
  }
}

}  // namespace
}  // namespace pliant
