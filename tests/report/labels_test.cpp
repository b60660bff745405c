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

TEST(StrainScale, ShowsMembraneStrainsInPercentAndThoseOfBendingAsCurvatures) {
  EXPECT_EQ(strain_scale("stretch.warp").factor, 100.0);
  EXPECT_DOUBLE_EQ(strain_scale("bend.weft").factor, 1.0 / 3);
  EXPECT_EQ(strain_scale("bend.weft").label.unit, "1/m");
}

TEST(StrainRangeText, HasTheUnitOfTheComponent) {
  EXPECT_EQ(strain_range_text("stretch.warp", 0.0, 0.35), "strain 0 to 35 %");
  EXPECT_EQ(strain_range_text("bend.weft", -36.0, 180.0), "curvature -12 to 60 1/m");
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
