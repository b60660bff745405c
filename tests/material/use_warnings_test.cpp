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

TEST(UseWarnings, NameWhatNoDataDetermined) {
  Material material = measured(sheet_component_names());
  material.components["shear"].errors = {{"k", {7.0, {}, Determination::none, "stretch 100 %"}}};
  material.components["stretch.weft"].errors = {{"k", {0.1, {}, Determination::weak, ""}}};
  EXPECT_THAT(use_warnings(material, sheet_component_names()),
              ElementsAre("the stiffness of shear in \"jersey\" is not determined by the data that "
                          "it was fitted to (k 3.0 +- 7.0): what hangs on it is a guess"));
  const std::vector<std::string> stretch{"stretch.weft"};
  EXPECT_THAT(undetermined_warnings(material, stretch), IsEmpty());
}

TEST(UseWarnings, TellFrictionFromStiffness) {
  Material material = measured({"shear"});
  MaterialComponent& shear = material.components["shear"];
  shear.friction = ComponentFriction{{0.4, 0, 0.02}, {}};
  const NumberError known{0.01, {}, Determination::within_10_percent, ""};
  const NumberError unknown{{}, {}, Determination::none, ""};
  shear.errors = {{"k", known}, {"friction.a", unknown}, {"friction.tau", unknown}};
  const std::vector<std::string> used{"shear"};
  EXPECT_THAT(undetermined_warnings(material, used),
              ElementsAre(HasSubstr("friction of shear in \"jersey\" is not determined")));
  // That it is small is something that the data told.
  shear.errors["friction.a"].limit = 0.1;
  EXPECT_THAT(undetermined_warnings(material, used), IsEmpty());
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
