#include "pliant/material/use_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/material/fill.h"

namespace pliant {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Material measured(const std::vector<std::string>& names) {
  Material material;
  material.name = "jersey";
  material.density = 0.2;
  for (const std::string& name : names) {
    material.components[name].stiffness = ScalarCurve::constant(3);
  }
  return material;
}

TEST(UseWarnings, OfAUsualMaterialAreNone) {
  EXPECT_THAT(use_warnings(measured(sheet_component_names()), sheet_component_names()), IsEmpty());
}

TEST(UseWarnings, NameAMeasuredComponentThatIsNotUsed) {
  const Material material = measured({"stretch.bias", "stretch.warp"});
  EXPECT_THAT(use_warnings(material, sheet_component_names()),
              ElementsAre(HasSubstr("stretch.bias of \"jersey\" was measured, but")));
}

TEST(UseWarnings, SayNothingOfAComponentThatWasNotMeasured) {
  Material material = measured({"stretch.bias"});
  material.components["stretch.bias"].status = ComponentStatus::assumed;
  EXPECT_THAT(use_warnings(material, sheet_component_names()), IsEmpty());
  material.components["stretch.bias"].status = ComponentStatus::unmeasured;
  EXPECT_THAT(use_warnings(material, sheet_component_names()), IsEmpty());
}

TEST(UseWarnings, SuspectGramsInPlaceOfKilograms) {
  Material material = measured(sheet_component_names());
  material.density = 100;
  EXPECT_THAT(use_warnings(material, sheet_component_names()),
              ElementsAre(HasSubstr("is `density` in g/m^2, not kg/m^2")));
  material.density = 2;
  EXPECT_THAT(use_warnings(material, sheet_component_names()), IsEmpty());
}

}  // namespace
}  // namespace pliant
