#include "pliant/report/labels.h"

#include <gtest/gtest.h>

namespace pliant::report {
namespace {

TEST(QuantityLabel, SplitsNameAndUnit) {
  EXPECT_EQ(quantity_label("force_N").with_unit(), "Force (N)");
  EXPECT_EQ(quantity_label("length_mm").with_unit(), "Length (mm)");
  EXPECT_EQ(quantity_label("force_N_per_m").with_unit(), "Shear force (N/m)");
  EXPECT_EQ(quantity_label("moment_N").with_unit(), "Moment per width (N)");
  EXPECT_EQ(quantity_label("curvature_1_per_m").with_unit(), "Curvature (1/m)");
  EXPECT_EQ(quantity_label("nominal_stress_Pa").with_unit(), "Nominal stress (Pa)");
}

TEST(QuantityLabel, LeavesAnUnknownColumnAsItIs) {
  EXPECT_EQ(quantity_label("intensity").with_unit(), "intensity");
}

TEST(ShownStrain, IsEngineeringExtensionOfStretchAndCurvatureOfBending) {
  const ShownStrain green("stretch.warp", MembraneMeasure::stvk);
  EXPECT_EQ(green.label().with_unit(), "Extension (%)");
  EXPECT_NEAR(green(0.22), 20, 1e-9) << "sqrt(1 + 2 0.22) = 1.2";
  EXPECT_TRUE(green.is_of_green_strain());
  const ShownStrain linear("stretch.warp", MembraneMeasure::soft_constraint);
  EXPECT_EQ(linear.label().name, "Extension");
  EXPECT_DOUBLE_EQ(linear(0.22), 22);
  const ShownStrain bent("bend.weft", MembraneMeasure::stvk);
  EXPECT_DOUBLE_EQ(bent(30), 10);
  EXPECT_EQ(bent.label().with_unit(), "Curvature (1/m)");
}

TEST(ShownStrain, OfOlderResultsIsTheStrainItself) {
  EXPECT_EQ(ShownStrain("stretch.warp", {}).label().name, "Strain");
  EXPECT_DOUBLE_EQ(ShownStrain("stretch.warp", {})(0.22), 22);
}

TEST(StrainRangeText, HasTheUnitOfTheComponent) {
  const auto green = MembraneMeasure::stvk;
  EXPECT_EQ(strain_range_text("stretch.warp", green, 0.0, 0.22),
            "extension 0 to 20 % (Green strain 0 to 22 %)");
  EXPECT_EQ(strain_range_text("stretch.warp", MembraneMeasure::spring, 0.0, 0.22),
            "extension 0 to 22 %");
  EXPECT_EQ(strain_range_text("bend.weft", green, -36.0, 180.0), "curvature -12 to 60 1/m");
}

TEST(Parameters, OfAddendsAreToldByTheirKind) {
  EXPECT_TRUE(is_of_friction("stretch.warp.friction.a"));
  EXPECT_TRUE(is_of_friction("stretch.warp.dahl2.tau"));
  EXPECT_FALSE(is_of_friction("stretch.warp.k[1]"));
  EXPECT_FALSE(is_of_friction("stretch.warp.k1"));
  EXPECT_EQ(parameter_meaning("stretch.warp.dahl.tau"), "strain over which its friction builds up");
}

TEST(ComponentTitle, ReadsAsWords) {
  EXPECT_EQ(component_title("stretch.warp"), "Warp stretch");
  EXPECT_EQ(component_title("bend.weft"), "Weft bending");
  EXPECT_EQ(component_title("shear"), "Shear");
  EXPECT_EQ(component_title("area"), "Area");
  EXPECT_EQ(component_title("stretch.weft*stretch.warp"), "stretch.weft*stretch.warp");
  EXPECT_EQ(component_title("new.thing"), "new.thing");
}

TEST(ParameterMeaning, KnowsEveryParameterOfACloth) {
  EXPECT_EQ(parameter_meaning("stretch.warp.friction.tau"), "strain over which friction builds up");
  EXPECT_EQ(parameter_meaning("stretch.warp.k[3]"), "stiffness at a control point");
  EXPECT_EQ(parameter_meaning("shear.k"), "stiffness");
  EXPECT_EQ(parameter_meaning("warp-weights.force_offset"), "");
}

TEST(ParameterInWords, NamesControlValuesAndFriction) {
  EXPECT_EQ(parameter_in_words("stretch.weft.k[0] (why)"),
            "stiffness of stretch.weft at zero strain (why)");
  EXPECT_EQ(parameter_in_words("shear.k[2]"), "stiffness of shear at control point [2]");
  EXPECT_EQ(parameter_in_words("shear.friction.tau"),
            "strain over which friction of shear builds up");
  EXPECT_EQ(parameter_in_words("friction of shear: why"), "friction of shear: why");
}

}  // namespace
}  // namespace pliant::report
