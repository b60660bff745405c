#include "pliant/material/density/persistent_deformation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/material/density/dahl.h"

namespace pliant {
namespace {

constexpr double kStiffness = 135.6;

TEST(PersistentDeformation, ConversionIsUndoneByItsInverse) {
  for (const double share : {0.5, kSaturationShare, 0.999}) {
    const FrictionAppearance appearance{0.016, 0.04};
    const FrictionAppearance back =
        appearance_of(friction_from(appearance, kStiffness, share), kStiffness, share);
    EXPECT_DOUBLE_EQ(back.persistent, appearance.persistent);
    EXPECT_DOUBLE_EQ(back.saturation, appearance.saturation);
  }
}

TEST(PersistentDeformation, IsTheFormulaOfTheThesis) {
  // alpha = sigma_max / (eps_sat - eps_per) ln(2 / (1 - c)), tau = sigma_max / alpha.
  const ConstantFriction friction = friction_from({0.016, 0.04}, kStiffness, 0.95);
  EXPECT_DOUBLE_EQ(friction.max_stress, kStiffness * 0.016);
  EXPECT_DOUBLE_EQ(friction.tau, (0.04 - 0.016) / std::log(2 / 0.05));
}

TEST(PersistentDeformation, TheLawItselfIsSaturatedAtTheSaturationStrain) {
  // Loading from the persistent strain, where saturated unloading has left -sigma_max.
  const FrictionAppearance appearance{0.016, 0.04};
  const ConstantFriction friction = friction_from(appearance, kStiffness);
  const DahlParameters dahl{friction.max_stress, 0, friction.tau};
  const double stress =
      friction_stress(dahl, appearance.saturation, {appearance.persistent, -friction.max_stress})
          .stress;
  EXPECT_NEAR(stress, kSaturationShare * friction.max_stress, 1e-14);  // rounding
}

TEST(PersistentDeformation, TheLawItselfRestsAtThePersistentStrain) {
  const FrictionAppearance appearance{0.016, 0.04};
  const ConstantFriction friction = friction_from(appearance, kStiffness);
  const DahlParameters dahl{friction.max_stress, 0, friction.tau};
  const double stress =
      friction_stress(dahl, appearance.persistent, {1, friction.max_stress}).stress;
  EXPECT_NEAR(kStiffness * appearance.persistent + stress, 0, 1e-13);  // rounding
}

TEST(PersistentDeformation, RefusesWhatNoMaterialCanDo) {
  EXPECT_THROW(friction_from({0.04, 0.04}, kStiffness), AssertionError);
  EXPECT_THROW(friction_from({-0.01, 0.04}, kStiffness), AssertionError);
  EXPECT_THROW(friction_from({0.01, 0.04}, 0), AssertionError);
  EXPECT_THROW(friction_from({0.01, 0.04}, kStiffness, 1), AssertionError);
  EXPECT_THROW(appearance_of({2, 0.01}, 0), AssertionError);
  EXPECT_THROW(appearance_of({2, 0.01}, kStiffness, 0), AssertionError);
}

}  // namespace
}  // namespace pliant
