#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/experiment/press/press_type.h"
#include "pliant/geometry/fingertip.h"
#include "pliant/geometry/irregular_mesh.h"
#include "pliant/material/addend/rubber_addends.h"
#include "pliant/material/solid/standard_solids.h"
#include "pliant/study/study_evaluation.h"

#include "solids/solid_labs.h"
#include "support/asked_for.h"

namespace pliant {
namespace {

using test::LabFolder;
using test::solid_study;

/// A fingertip on its nail that a plane is pressed against from below, as in [T] Fig. 4.7.
VirtualPress pressed_fingertip() {
  VirtualPress press;
  press.name = "pad";
  press.kind = &press_type();
  press.setup.mesh =
      make_fingertip({.length = 22e-3, .width = 16e-3, .height = 13e-3, .edge = 3e-3});
  press.setup.held = press.setup.mesh.groups.at("nail");
  press.setup.direction = {0, 0, 1};
  press.fixed = "nail";
  press.depths = {2e-3};
  press.samples = 7;
  return press;
}

/// Tissue whose shear stiffness grows with the exponential of its strain: forces of 0.02 to 0.38 N.
Material stiffening_tissue() {
  Material material = neo_hookean_solid(1, 200e3);
  material.components["I1-bar"].addends = {Addend(exponential_addend(), Eigen::Vector2d(2000, 8))};
  return material;
}

/// A law that is fitted, with its numbers where that was done.
struct FittedLaw {
  std::string model, more;
  Material found;
};

const std::string kKnownVolume = "fit: {fix: {J.k: 200000}}\n";

FittedLaw neo_hookean() {
  return {"law: neo-hookean", kKnownVolume, neo_hookean_solid(3400, 200e3)};
}

FittedLaw with_limit() {
  FittedLaw law{"law: neo-hookean, limits: [{of: [I1-bar]}]", kKnownVolume,
                neo_hookean_solid(2699, 200e3)};
  law.found.limits = {{{"I1-bar"}, 301}};
  return law;
}

/// @return RMS error in % of the largest force: of the fit where tables are asked for, else of the
///         numbers that it found
double error_of(const FittedLaw& law) {
  static const test::MeasuredFiles measured =
      test::measurements_of(test::lab_of(stiffening_tissue(), {pressed_fingertip()}), 1);
  const LabFolder folder(measured);
  const Study study = solid_study(folder, law.model, law.more);
  const StudyResult result =
      test::makes_figures() ? fit_study(study, {}, {}) : evaluate_study(study, law.found, {});
  const double error = result.experiments.front().rms_percent;
  fmt::print("{:<50} {:6.2f} %\n", law.model, error);
  return error;
}

TEST(SlowPressedFingertip, IsFollowedByALimitThatItsLawNeeds) {
  if (!has_irregular_meshes()) GTEST_SKIP() << "built without CGAL";
  EXPECT_GT(error_of(neo_hookean()), 9);
  EXPECT_LT(error_of(with_limit()), 3);
  if (test::makes_figures()) {
    EXPECT_GT(error_of({"law: stvk", "", {}}), 9);
  }
}

}  // namespace
}  // namespace pliant
