#include "pliant/experiment/uniaxial_geometry.h"

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr UniaxialGeometry kGreenLagrange{0.1, 0.05, MembraneMeasure::stvk};
constexpr UniaxialGeometry kLinear{0.1, 0.05, MembraneMeasure::soft_constraint};

TEST(UniaxialGeometry, StrainIsGreenLagrangeForStvkElseEngineering) {
  EXPECT_DOUBLE_EQ(strain_at(kGreenLagrange, 0.13), (1.3 * 1.3 - 1) / 2);
  EXPECT_DOUBLE_EQ(strain_at(kLinear, 0.13), 0.13 / 0.1 - 1);
  const UniaxialGeometry spring{0.1, 0.05, MembraneMeasure::spring};
  EXPECT_DOUBLE_EQ(strain_at(spring, 0.13), strain_at(kLinear, 0.13));
}

TEST(UniaxialGeometry, LengthIsTheInverseOfStrain) {
  for (const UniaxialGeometry& geometry : {kGreenLagrange, kLinear}) {
    for (const double length : {0.07, 0.1, 0.23}) {
      EXPECT_NEAR(length_at(geometry, strain_at(geometry, length)), length, 1e-16);  // rounding
    }
  }
}

TEST(UniaxialGeometry, ForceFactorIsAreaTimesStrainPerLength) {
  // [T] Eq. 5.5: force = stress A d strain / d length, A = gauge length times width.
  for (const UniaxialGeometry& geometry : {kGreenLagrange, kLinear}) {
    for (const double length : {0.08, 0.1, 0.17}) {
      const double factor = force_factor(geometry, strain_at(geometry, length));
      EXPECT_NEAR(factor, 0.1 * 0.05 * strain_slope(geometry, length), 1e-16);  // rounding
    }
  }
}

TEST(UniaxialGeometry, SlopesAreThoseOfDifferences) {
  constexpr double kStep = 1e-5;
  for (const UniaxialGeometry& geometry : {kGreenLagrange, kLinear}) {
    const double length = 0.13, strain = strain_at(geometry, length);
    // A quadratic in the length: its central difference is exact but for rounding.
    EXPECT_NEAR(
        strain_slope(geometry, length),
        (strain_at(geometry, length + kStep) - strain_at(geometry, length - kStep)) / (2 * kStep),
        1e-9);
    EXPECT_NEAR(force_factor_slope(geometry, strain),
                (force_factor(geometry, strain + kStep) - force_factor(geometry, strain - kStep)) /
                    (2 * kStep),
                1e-10);  // step^2 times the third derivative
  }
}

}  // namespace
}  // namespace pliant
