// Stiffness that a simulation can be built of, and how a falling one goes on beyond its range.

#include "pliant/material/positive_stiffness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/material/addend/addend_registry.h"
#include "pliant/material/fill.h"

#include "io/input_error_of.h"

namespace pliant {
namespace {

using test::input_error_of;
using ::testing::HasSubstr;

Material with_shear(const ScalarCurve& stiffness, std::optional<std::pair<double, double>> range) {
  Material material;
  material.name = "net";
  for (const std::string& name : sheet_component_names()) {
    material.components[name].stiffness = ScalarCurve::constant(3);
  }
  material.components["shear"].stiffness = stiffness;
  material.components["shear"].range = range;
  return material;
}

void require(const Material& material) {
  require_positive_stiffness(material, sheet_component_names(), {"scene.yaml", 4, "material"});
}

InputError refusal(const ScalarCurve& stiffness,
                   std::optional<std::pair<double, double>> range = {}) {
  return input_error_of([&] { require(with_shear(stiffness, range)); });
}

TEST(PositiveStiffness, IsAskedForAtEveryControlPoint) {
  EXPECT_NO_THROW(require(with_shear(ScalarCurve::constant(3), {})));
  const InputError error = refusal(ScalarCurve::hermite({0, 0.1, 0.2}, {3, 0, 3}, true));
  EXPECT_EQ(error.problem(), "the stiffness shear of the material \"net\" is 0 at strain 0.1");
  EXPECT_EQ(error.where().line, 4);
}

TEST(PositiveStiffness, IsAskedForBetweenControlPoints) {
  // The tangent at 0.1 is (30 - 3) / 0.2 = 135 N/m: the first span dips below zero before it.
  const ScalarCurve dipping = ScalarCurve::hermite({0, 0.1, 0.2}, {3, 0.1, 30}, true);
  ASSERT_LT(dipping.value(0.08), 0);
  EXPECT_THAT(refusal(dipping).problem(), HasSubstr("is -"));
}

TEST(PositiveStiffness, OfAnAffineCurveIsAskedForUpToTheEndOfItsRange) {
  const ScalarCurve falling = ScalarCurve::affine(10, -100);
  const InputError error = refusal(falling, std::pair(0.0, 0.5));
  EXPECT_EQ(error.problem(),
            "the stiffness shear of the material \"net\" turns negative at strain 0.1, within its "
            "range");
  EXPECT_THAT(error.expected(), HasSubstr("a `range` of the component that ends before"));
  refusal(falling, std::pair(-0.2, 0.05));
  refusal(falling, std::pair(0.0, 0.1));
  EXPECT_NO_THROW(require(with_shear(falling, std::pair(-0.09, 0.05))));
}

TEST(PositiveStiffness, OfAFallingCurveNeedsARange) {
  EXPECT_THAT(refusal(ScalarCurve::affine(10, -100)).problem(), HasSubstr("has no range"));
  EXPECT_NO_THROW(require(with_shear(ScalarCurve::affine(10, 100), {})));
}

TEST(PositiveStiffness, IsAskedForWithoutStrain) {
  EXPECT_THAT(refusal(ScalarCurve::affine(-10, 100)).problem(), HasSubstr("is -10 at strain 0"));
}

TEST(PositiveStiffness, LooksOnlyAtTheComponentsNamed) {
  Material material = with_shear(ScalarCurve::constant(3), {});
  material.components["stretch.bias"].stiffness = ScalarCurve::constant(0);
  EXPECT_NO_THROW(require(material));
}

TEST(PositiveStiffness, MayBeThatOfAnElasticRangeAlone) {
  Material material = with_shear(ScalarCurve::none(), {});
  MaterialComponent& shear = material.components["shear"];
  shear.addends = {{*find_addend_kind("dahl"), Eigen::Vector3d(1, 0, 0.1)}};
  EXPECT_THAT(input_error_of([&] { require(material); }).problem(), HasSubstr("is 0 at strain 0"));
  shear.addends = {{*find_addend_kind("plastic"), Eigen::Vector2d(5, 0.1)}};
  EXPECT_NO_THROW(require(material));
  shear.stiffness = ScalarCurve::constant(-1);
  EXPECT_THAT(input_error_of([&] { require(material); }).problem(), HasSubstr("is -1 at strain 0"));
}

TEST(FallingStiffness, IsTheSameWithinItsRangeAndConstantBeyond) {
  const ScalarCurve falling = ScalarCurve::affine(10, -100);
  const Material material = held_beyond_range(with_shear(falling, std::pair(-0.02, 0.05)));
  const ScalarCurve& held = *material.components.at("shear").stiffness;
  for (const double strain : {-0.05, -0.03, 0.0, 0.01, 0.05}) {
    EXPECT_NEAR(held.value(strain), falling.value(strain), 1e-14) << strain;  // rounding
    EXPECT_NEAR(held.first_moment(strain), falling.first_moment(strain), 1e-16) << strain;
  }
  for (const double strain : {-1.0, 0.06, 0.2, 10.0}) EXPECT_NEAR(held.value(strain), 5, 1e-14);
}

TEST(RisingStiffness, GoesOnBeyondItsRange) {
  const Material material =
      held_beyond_range(with_shear(ScalarCurve::affine(10, 100), std::pair(0.0, 0.05)));
  EXPECT_EQ(material.components.at("shear").stiffness->kind(), CurveKind::affine);
}

}  // namespace
}  // namespace pliant
