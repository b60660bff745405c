// Laws with addends in fits: of what virtual instruments measure they give their numbers back.

#include <gtest/gtest.h>

#include "pliant/estimation/law_fit.h"
#include "pliant/material/addend/addend_registry.h"

#include "estimation/virtual_study.h"
#include "support/added_stiffness.h"

namespace pliant {
namespace {

using test::estimate_named;
using test::lab_of;
using test::made_up_material;
using test::relative_error;
using test::strip_cycles;
using test::truth_of;
using test::VirtualStudy;

Material two_branches() { return test::knit_of_two_branches(ScalarCurve::affine(50, 30)); }

TEST(AddendRecovery, TwoBranchesOfFrictionAreToldApart) {
  const Material knit = two_branches();
  VirtualStudy study(lab_of(knit, strip_cycles({0.05, 0.1, 0.2, 0.35})));
  study.set_model("components: {stretch.warp: {stiffness: affine, addends: [dahl]}}");
  const StudyResult result = study.fit();
  ASSERT_EQ(result.parameters.size(), 8u);
  // Which branch is which is not the data's to say: the first may be either.
  const bool swapped = estimate_named(result, "stretch.warp.friction.tau").value > 0.1;
  for (const std::string number : {"a", "b", "tau"}) {
    const double own = truth_of(knit, "stretch.warp.friction." + number);
    const double added = truth_of(knit, "stretch.warp.dahl." + number);
    EXPECT_NEAR(estimate_named(result, "stretch.warp.friction." + number).value,
                swapped ? added : own, 1e-5 * (swapped ? added : own));
    EXPECT_NEAR(estimate_named(result, "stretch.warp.dahl." + number).value, swapped ? own : added,
                1e-5 * (swapped ? own : added));
  }
  EXPECT_LT(relative_error(result, knit, "stretch.warp.k1"), 1e-5);
  EXPECT_LT(relative_error(result, knit, "stretch.warp.k2"), 1e-5);
}

// A component may have no stiffness curve at all; and the fit knows the law by its kind alone.
TEST(AddendRecovery, OfALawThatCarriesAComponentAlone) {
  ComponentLaw law{ScalarCurve::none(), FrictionLaw::dahl, {0.8, 3, 0.02}};
  law.addends = {{test::added_stiffness(), Eigen::Vector2d(40, 90)}};
  const Material material = made_up_material("stretch.warp", law);
  const VirtualStudy files(lab_of(material, strip_cycles({0.05, 0.2})));
  const Study study = files.study();
  const auto experiment = read_experiment(study.experiments.front(), study);
  const LawFit fit = fit_law(ComponentProblem({experiment.get()}), law, {});
  const Eigen::VectorXd expected = law.parameters();
  for (Eigen::Index i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(fit.law.parameters()(i), expected(i), 1e-6 * expected(i))
        << fit.unknowns[static_cast<std::size_t>(i)].name;
  }
}

TEST(AddendRecovery, OfYieldFindsItsElasticRange) {
  ComponentLaw law{ScalarCurve::affine(50, 30)};
  law.addends = {{*find_addend_kind("plastic"), Eigen::Vector2d(80, 0.03)}};
  const Material foil = made_up_material("stretch.warp", law);
  VirtualStudy study(lab_of(foil, strip_cycles({0.05, 0.1, 0.2, 0.35})));
  study.set_model(
      "components: {stretch.warp: {stiffness: affine, friction: none, addends: [plastic]}}");
  const StudyResult result = study.fit();
  for (const char* number : {"k1", "k2", "plastic.k", "plastic.yield"}) {
    EXPECT_LT(relative_error(result, foil, std::string("stretch.warp.") + number), 1e-5) << number;
  }
}

TEST(AddendRecovery, GrowthOfACurveGoesWithItsAddends) {
  const Material knit = two_branches();
  VirtualStudy study(lab_of(knit, strip_cycles({0.05, 0.1, 0.2, 0.35})));
  study.set_model("components: {stretch.warp: {stiffness: hermite, addends: [dahl]}}");
  const StudyResult result = study.fit();
  EXPECT_LT(result.experiments.front().rms_percent, 0.05);
  EXPECT_EQ(result.material.components.at("stretch.warp").addends.size(), 1u);
  EXPECT_GT(*result.experiments.front().elastic_percent, 1);  // the best law that forgets
}

TEST(AddendRecovery, WhatNoFitCanFollowIsRefusedByName) {
  VirtualStudy anchors(lab_of(two_branches(), strip_cycles({0.1})));
  anchors.set_model("components: {stretch.warp: {addends: [dahl]}}");
  anchors.add("fit: {estimator: anchor}");
  EXPECT_THROW(
      {
        try {
          anchors.fit();
        } catch (const InputError& error) {
          EXPECT_EQ(error.where().field, "model.components.stretch.warp.addends");
          throw;
        }
      },
      InputError);
}

}  // namespace
}  // namespace pliant
