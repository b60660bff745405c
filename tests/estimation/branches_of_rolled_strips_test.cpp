// Strips that were rolled up and let go, of cloth with two branches of friction in its bending.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/material/addend/addend_registry.h"

#include "estimation/virtual_study.h"
#include "support/virtual_strips.h"

namespace pliant {
namespace {

using test::lab_of;
using test::made_up_material;
using test::relative_error;
using test::VirtualStudy;

Material with_two_branches() {
  ComponentLaw law{ScalarCurve::constant(8e-6), FrictionLaw::dahl, {3e-4, 2e-6, 8}};
  law.addends = {{*find_addend_kind("dahl"), Eigen::Vector3d(1.5e-4, 1e-6, 60)}};
  return made_up_material("bend.warp", law);
}

// A release is followed to a hundredth of a millimetre, by other steps in the measurement than in
// the fit: noise of that size moves the numbers of the branches by some per cent.
TEST(SlowRolledBranches, AreBothFoundAndMissedByOne) {
  const Material truth = with_two_branches();
  VirtualStudy study(lab_of(truth, test::rolled_strips({0.004, 0.006, 0.009, 0.013, 0.02, 0.03})));
  study.set_model("components: {bend.warp: {stiffness: constant, addends: [dahl]}}");
  const StudyResult two = study.fit();
  EXPECT_TRUE(two.converged);
  for (const ParameterEstimate& p : two.parameters) {
    fmt::print("{} = {:.4g}, {:.2f} % off\n", p.name, p.value,
               100 * relative_error(two, truth, p.name));
    EXPECT_LT(relative_error(two, truth, p.name), 0.08) << p.name;
  }
  study.set_model("components: {bend.warp: {stiffness: constant}}");
  const double rms = two.experiments.front().rms, of_one = study.fit().experiments.front().rms;
  fmt::print("RMS {:.4f} mm, of one branch {:.3f} mm\n", 1e3 * rms, 1e3 * of_one);
  EXPECT_LT(rms, 2e-5);
  EXPECT_GT(of_one, 20 * rms);
}

}  // namespace
}  // namespace pliant
