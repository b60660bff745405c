// Where solids lose strong ellipticity, against closed forms.

#include "pliant/experiment/homogeneous/elliptic_range.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "pliant/material/solid/ellipticity.h"
#include "pliant/material/solid/solid_density.h"
#include "pliant/material/solid/standard_solids.h"

#include "solids/solid_labs.h"

namespace pliant {
namespace {

EllipticRange range_of(const Material& material, const std::string& way, bool compressed) {
  for (const EllipticRange& range : elliptic_ranges(material)) {
    if (range.way == way && range.compressed == compressed) return range;
  }
  ADD_FAILURE() << "no way " << way;
  return {};
}

TEST(EllipticRange, NeoHookeanIsEllipticEverywhere) {
  const Material isochoric = test::solid_of({{"I1-bar", test::component_of({test::linear(1e5)})}});
  const std::vector<EllipticRange> ranges = elliptic_ranges(isochoric);
  EXPECT_EQ(ranges.size(), 8u);  // nothing changes its volume
  for (const EllipticRange& range : ranges) {
    EXPECT_FALSE(range.lost) << range.way;
    EXPECT_FALSE(range.limited) << range.way;
  }
}

TEST(EllipticRange, AcousticTensorOfNeoHookeanIsItsClosedForm) {
  // W = mu / 2 (I1 - 3) adds mu F_iJ F_iJ / 2: Q = mu 1 for every n and F.
  const Material material = test::solid_of({{"I1", test::component_of({test::linear(500)})}});
  const auto law = solid_density(material).law;
  Eigen::Matrix3d gradient;
  gradient << 1.2, 0.4, 0, -0.1, 0.8, 0.2, 0.3, 0, 1.5;
  EXPECT_NEAR(least_wave_modulus(deformed_point(*law, gradient), false), 1000, 1e-9);
  EXPECT_NEAR(least_wave_modulus(deformed_point(*law, gradient), true), 1000, 1e-9);
}

TEST(EllipticRange, StVKLosesItInCompressionAtTheStretchesOfItsClosedForms) {
  // Of the same stretch s along all axes S = (3 lambda + 2 mu) (s^2 - 1) / 2 times the identity,
  // and a shear wave has S + mu s^2: it vanishes first.
  constexpr double kLambda = 3e4, kMu = 1e4;
  const double bulk = 3 * kLambda + 2 * kMu;
  const EllipticRange squeezed = range_of(stvk_solid(kLambda, kMu), "volumetric", true);
  EXPECT_TRUE(squeezed.lost);
  EXPECT_NEAR(squeezed.at, std::sqrt(bulk / (bulk + 2 * kMu)), 1e-8);
  // With lambda = 0 a column keeps its width: S = mu (s^2 - 1) along it, and in the plane of n =
  // (c, 0, d) the acoustic tensor over mu is, a = s^2,
  //   [[a (1 + 2 c^2) - c^2, c d s], [c d s, c^2 a + 2 d^2]].
  // Along the column it vanishes at s = sqrt(1 / 3); a little aslant before.
  const EllipticRange column = range_of(stvk_solid(0, kMu), "uniaxial", true);
  double first = 0;
  for (int i = 0; i <= 100000; ++i) {
    const double x = i / 100000.0;  // c^2
    const double b = 2 + x - 4 * x * x;
    const double a = (std::sqrt(b * b + 8 * x * x * (1 - x) * (1 + 2 * x)) - b) /
                     std::max(2 * x * (1 + 2 * x), 1e-9);
    if (x > 0.01) first = std::max(first, a);
  }
  EXPECT_TRUE(column.lost);
  EXPECT_NEAR(column.at, std::sqrt(first), 1e-6);
  EXPECT_GT(column.at, std::sqrt(1.0 / 3));
  // Pulled it stays elliptic.
  for (const char* way : {"uniaxial", "equibiaxial", "planar", "volumetric"}) {
    EXPECT_FALSE(range_of(stvk_solid(kLambda, kMu), way, false).lost) << way;
  }
}

TEST(EllipticRange, EndsAtALimitOfEnergy) {
  Material material = test::solid_of({{"I1-bar", test::component_of({test::linear(1e5)})}});
  material.limits.push_back({{"I1-bar"}, 2e5});
  const EllipticRange pulled = range_of(material, "uniaxial", false);
  EXPECT_TRUE(pulled.limited);
  EXPECT_FALSE(pulled.lost);
  EXPECT_NEAR(pulled.reach, 2, 1e-4);  // I1 - 3 = s^2 + 2 / s - 3; barriers end a little before
}

TEST(EllipticRange, EndsAtALimitOfVolumeWithinTheFirstStep) {
  constexpr double kBulk = 1e6, kLargest = 1.06;
  Material material = neo_hookean_solid(1e5, kBulk);
  material.limits.push_back({{"J"}, kBulk / 2 * (kLargest - 1) * (kLargest - 1)});
  const EllipticRange blown = range_of(material, "volumetric", false);
  EXPECT_TRUE(blown.limited);
  EXPECT_FALSE(blown.lost);
  EXPECT_NEAR(blown.reach, std::cbrt(kLargest), 1e-8);  // a point is led: no barrier is followed
}

}  // namespace
}  // namespace pliant
