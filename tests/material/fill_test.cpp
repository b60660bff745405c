// What a simulation asks of a material, and filling what was not measured.

#include "pliant/material/fill.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/input_error_of.h"

namespace pliant {
namespace {

using test::input_error_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

MaterialComponent with_stiffness(double stiffness) {
  MaterialComponent component;
  component.stiffness = ScalarCurve::constant(stiffness);
  return component;
}

MaterialComponent unmeasured() {
  MaterialComponent component;
  component.status = ComponentStatus::unmeasured;
  return component;
}

/// Stretch was measured, shear was not, and nobody ever looked at bending.
Material strip() {
  Material material;
  material.name = "strip";
  material.components["stretch.weft"] = with_stiffness(10);
  material.components["stretch.warp"] = with_stiffness(20);
  material.components["shear"] = unmeasured();
  return material;
}

Material whole() {
  Material material;
  material.name = "whole";
  for (const std::string& name : sheet_component_names()) {
    material.components[name] = with_stiffness(3);
  }
  return material;
}

double stiffness_of(const Material& material, const std::string& component) {
  return material.components.at(component).stiffness->value(0);
}

TEST(Fill, ReplacesComponentsThatAreAbsentOrUnmeasured) {
  const Material material = filled(strip(), whole());
  EXPECT_EQ(stiffness_of(material, "shear"), 3);
  EXPECT_EQ(stiffness_of(material, "bend.diagonal"), 3);
  EXPECT_EQ(material.components.at("shear").status, ComponentStatus::assumed);
  EXPECT_EQ(material.components.at("bend.warp").status, ComponentStatus::assumed);
}

TEST(Fill, KeepsWhatWasMeasured) {
  const Material material = filled(strip(), whole());
  EXPECT_EQ(stiffness_of(material, "stretch.weft"), 10);
  EXPECT_EQ(material.components.at("stretch.warp").status, ComponentStatus::measured);
  EXPECT_EQ(material.name, "strip");
}

TEST(Fill, KeepsAnAssumptionOfTheMaterialItself) {
  Material own = strip();
  own.components["shear"] = with_stiffness(7);
  own.components["shear"].status = ComponentStatus::assumed;
  EXPECT_EQ(stiffness_of(filled(own, whole()), "shear"), 7);
}

TEST(Fill, TakesNumbersThatStandUnderTheStatusUnmeasuredForUnknown) {
  Material own = strip();
  own.components["shear"] = with_stiffness(7);
  own.components["shear"].status = ComponentStatus::unmeasured;
  EXPECT_EQ(stiffness_of(filled(own, whole()), "shear"), 3);
}

TEST(Fill, LeavesUnknownWhatTheFillerDoesNotKnow) {
  Material filler = whole();
  filler.components["bend.warp"] = unmeasured();
  EXPECT_THAT(fillable_components(strip(), filler),
              ElementsAre("shear", "bend.weft", "bend.diagonal"));
  EXPECT_FALSE(is_known(filled(strip(), filler), "bend.warp"));
}

TEST(Fill, SaysInTheProvenanceWhatWasFilled) {
  const Material material = filled(strip(), whole());
  EXPECT_EQ(material.provenance.at("filled"),
            "shear, bend.weft, bend.warp, bend.diagonal from whole");
}

TEST(Fill, ChangesNothingOfACompleteMaterial) {
  EXPECT_TRUE(filled(whole(), strip()).provenance.empty());
}

TEST(Fill, RefusesMembraneNumbersOfAnotherStrain) {
  Material filler = whole();
  filler.membrane = MembraneMeasure::soft_constraint;
  const InputError error = input_error_of([&] { filled(strip(), filler, {"whole.json", 0, {}}); });
  EXPECT_EQ(error.where().file, "whole.json");
  EXPECT_THAT(error.problem(), HasSubstr("`soft-constraint`"));
  EXPECT_THAT(error.expected(), HasSubstr("`stvk`"));
}

TEST(Fill, RefusesHingeStiffnessBesideSheetStiffness) {
  Material own = strip();
  own.components["bend.weft"] = with_stiffness(1e-6);
  Material filler = whole();
  filler.bending_of = "hinges";
  const InputError error = input_error_of([&] { filled(own, filler); });
  EXPECT_THAT(error.problem(), HasSubstr("hinges"));
}

TEST(Fill, TakesOverWhatBendingBelongsToWithAllOfIt) {
  Material filler = whole();
  filler.bending_of = "hinges";
  filler.bending_mesh = "25x25";
  const Material material = filled(strip(), filler);
  EXPECT_EQ(material.bending_of, "hinges");
  EXPECT_EQ(material.bending_mesh, "25x25");
}

TEST(CompleteMaterial, HasEveryComponentOfASheet) {
  EXPECT_NO_THROW(require_complete(whole(), sheet_component_names()));
  EXPECT_NO_THROW(require_complete(filled(strip(), whole()), sheet_component_names()));
}

TEST(CompleteMaterial, IsAskedForByNameOfWhatIsMissing) {
  const InputError error = input_error_of([] {
    require_complete(strip(), sheet_component_names(), {"scene.yaml", 4, "cloth[0].material"});
  });
  EXPECT_EQ(error.where().line, 4);
  EXPECT_EQ(error.problem(),
            "shear, bend.weft, bend.warp, bend.diagonal of the material \"strip\" were not "
            "measured");
  EXPECT_THAT(error.expected(), HasSubstr("--fill FILE"));
}

TEST(CompleteMaterial, NamesTheFitThatTellsShearWhereBiasStripsWereMeasured) {
  Material material = strip();
  material.components["stretch.bias"] = material.components.at("stretch.warp");
  const InputError error =
      input_error_of([&] { require_complete(material, sheet_component_names()); });
  EXPECT_THAT(error.expected(), HasSubstr("shear in a fit with model: {strips: sheet}"));
}

TEST(CompleteMaterial, LacksAComponentWhoseStatusIsUnmeasured) {
  Material material = whole();
  material.components["shear"].status = ComponentStatus::unmeasured;
  const InputError error =
      input_error_of([&] { require_complete(material, sheet_component_names()); });
  EXPECT_EQ(error.problem(), "shear of the material \"whole\" was not measured");
}

}  // namespace
}  // namespace pliant
