#include "pliant/estimation/number_errors.h"

#include <gtest/gtest.h>

namespace pliant {
namespace {

ParameterEstimate estimate(const char* owner, const char* number, bool fixed = false) {
  ParameterEstimate p;
  p.owner = owner;
  p.name = std::string(owner) + "." + number;
  p.std_error = 2;
  p.determination = Determination::weak;
  p.fixed = fixed;
  return p;
}

Material of(std::initializer_list<const char*> components) {
  Material material;
  for (const char* name : components) {
    material.components[name].stiffness = ScalarCurve::constant(1);
  }
  return material;
}

TEST(NumberErrors, AreThoseOfEachComponentsOwnNumbers) {
  Material material = of({"stretch.weft", "stretch.warp", "shear"});
  material.components["shear"].status = ComponentStatus::assumed;
  state_errors({estimate("stretch.weft", "k"), estimate("stretch.warp", "k", /*fixed=*/true),
                estimate("shear", "k")},
               /*isotropic=*/false, material);
  ASSERT_EQ(material.components["stretch.weft"].errors.size(), 1U);
  EXPECT_EQ(material.components["stretch.weft"].errors["k"].determined, Determination::weak);
  EXPECT_TRUE(material.components["stretch.warp"].errors.empty());
  EXPECT_TRUE(material.components["shear"].errors.empty());
}

TEST(NumberErrors, AreSharedByWeftAndWarpThatShareALaw) {
  Material material = of({"stretch.weft", "stretch.warp"});
  state_errors({estimate("stretch.weft", "k")}, /*isotropic=*/true, material);
  EXPECT_EQ(material.components["stretch.warp"].errors.size(), 1U);
}

}  // namespace
}  // namespace pliant
