#include "pliant/experiment/pulled_figures.h"

#include <cmath>

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr double kRounding = 1e-9;

/// A line of one stiffness (N/m) out, another back, to an extension.
PulledCycle lines(double out, double back, double end, int rows = 50) {
  PulledCycle cycle;
  for (int i = 0; i <= rows; ++i) {
    const double e = end * i / rows;
    cycle.out.extension.push_back(e);
    cycle.out.load.push_back(out * e);
    cycle.back.extension.push_back(end - e);
    cycle.back.load.push_back(out * end - back * e);
  }
  return cycle;
}

TEST(PulledFigures, OfStraightLinesAreTheirTriangles) {
  // 500 gf/cm at 4 %, and back to nothing at 2 %: half of the work comes back.
  const double stiffness = kKesTensileLoad / 0.04;
  const auto kes = kes_tensile(lines(stiffness, 2 * stiffness, 0.04));
  ASSERT_TRUE(kes);
  EXPECT_NEAR(kes->extension, 0.04, kRounding);
  EXPECT_NEAR(kes->linearity, 1, kRounding);
  EXPECT_NEAR(kes->work, kKesTensileLoad * 0.02, kRounding * kes->work);
  EXPECT_NEAR(*kes->resilience, 0.5, kRounding);
}

TEST(PulledFigures, KnowNoResilienceOfAPullThatGoesOn) {
  const double stiffness = kKesTensileLoad / 0.04;
  const auto beyond = kes_tensile(lines(stiffness, 2 * stiffness, 0.06));
  ASSERT_TRUE(beyond);
  EXPECT_NEAR(beyond->extension, 0.04, kRounding);
  EXPECT_FALSE(beyond->resilience);
  EXPECT_FALSE(kes_tensile(lines(stiffness, 2 * stiffness, 0.03))) << "does not come to 500 gf/cm";
}

TEST(PulledFigures, TellTheElongationThatIsLeft) {
  const auto recovery = elastic_recovery(lines(100, 125, 0.3));
  ASSERT_TRUE(recovery);
  EXPECT_NEAR(recovery->elongation, 0.3, kRounding);
  // Back from 30 N/m to 1 N/m by 29 / 125.
  EXPECT_NEAR(recovery->permanent, 0.3 - 29.0 / 125, kRounding);
  EXPECT_NEAR(recovery->recovery(), 29.0 / 125 / 0.3, kRounding);
  PulledCycle only_out = lines(100, 125, 0.3);
  only_out.back = {};
  EXPECT_FALSE(elastic_recovery(only_out));
}

// A laboratory's sheet of a wool: 168 g/m^2, bending length 15.0 mm, E5 0.67 %, E20 1.87 %, EB5
// 4.7 %; it reports B = 5.56 uN m, F = 0.45 mm^2 and G = 26.17 N/m.
TEST(PulledFigures, OfFastAreThoseOfALaboratorysSheet) {
  const double rigidity = 0.168 * 9.81 * std::pow(15.0e-3, 3);
  EXPECT_NEAR(1e6 * rigidity, 5.56, 0.005);
  EXPECT_NEAR(1e6 * fast_formability(0.0067, 0.0187, rigidity), 0.45, 0.005);
  EXPECT_NEAR(fast_shear_rigidity(0.047), 26.17, 0.005);
}

TEST(PulledFigures, OfALawArePulledToTheForce) {
  const ComponentLaw law{ScalarCurve::constant(300)};
  const auto cycle = pulled_to(law, MembraneMeasure::soft_constraint, 60);
  ASSERT_TRUE(cycle);
  EXPECT_NEAR(cycle->out.extension.back(), 0.2, kRounding);
  EXPECT_NEAR(cycle->back.load.back(), 0, kRounding);
  EXPECT_FALSE(pulled_to(law, MembraneMeasure::soft_constraint, 1000));
}

}  // namespace
}  // namespace pliant
