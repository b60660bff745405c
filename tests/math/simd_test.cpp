#include "pliant/math/simd.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

constexpr int kCount = 8;
using Numbers = std::array<double, kCount>;

// Two units in the last place: what the polynomials and the rounding of their sums leave.
constexpr double kLastPlaces = 4.5e-16;

struct Angle {
  template <class V>
  PLIANT_INLINE static void run(const double* y, const double* x, double* angle) {
    for (int l = 0; l < kCount; l += simd::kWidth<V>) {
      simd::store(simd::atan2(simd::load<V>(y + l), simd::load<V>(x + l)), angle + l);
    }
  }
};

struct Decay {
  template <class V>
  PLIANT_INLINE static void run(const double* x, double* result) {
    for (int l = 0; l < kCount; l += simd::kWidth<V>) {
      simd::store(simd::exp_of_negative(simd::load<V>(x + l)), result + l);
    }
  }
};

struct Root {
  template <class V>
  PLIANT_INLINE static void run(const double* x, double* result) {
    for (int l = 0; l < kCount; l += simd::kWidth<V>) {
      simd::store(simd::square_root(simd::load<V>(x + l)), result + l);
    }
  }
};

struct Width {
  template <class V>
  PLIANT_INLINE static void run(int* width) {
    *width = simd::kWidth<V>;
  }
};

/// Numbers of all sizes and both signs.
Numbers of_all_sizes(RandomStream& random) {
  Numbers numbers;
  for (double& x : numbers) x = random.normal() * std::pow(10, random.uniform(-12, 2));
  return numbers;
}

TEST(Simd, TakesTwoAtOnceWhileItIsNarrow) {
  int before = 0, narrow = 0, after = 0;
  simd::run<Width>(&before);
  {
    const simd::Narrow held;
    simd::run<Width>(&narrow);
  }
  simd::run<Width>(&after);
  EXPECT_EQ(narrow, 2);
  EXPECT_GE(before, 2);
  EXPECT_EQ(after, before);
}

TEST(Simd, FindsAnglesOfAllQuadrants) {
  RandomStream random(1);
  for (int i = 0; i < 10000; ++i) {
    const Numbers y = of_all_sizes(random), x = of_all_sizes(random);
    Numbers angle, on_two;
    simd::run<Angle>(y.data(), x.data(), angle.data());
    Angle::run<simd::Two>(y.data(), x.data(), on_two.data());
    EXPECT_EQ(angle, on_two);  // to the bit, whatever the width
    for (size_t l = 0; l < kCount; ++l) {
      const double expected = std::atan2(y[l], x[l]);
      EXPECT_NEAR(angle[l], expected, kLastPlaces * std::abs(expected)) << y[l] << " " << x[l];
    }
  }
}

TEST(Simd, FindsAnglesOnTheAxes) {
  const Numbers y{0, 0, 1, -1, 1, -1, 1, -1}, x{0, 1, 0, 0, 1, 1, -1, -1};
  Numbers angle;
  simd::run<Angle>(y.data(), x.data(), angle.data());
  for (size_t l = 0; l < kCount; ++l) {
    EXPECT_NEAR(angle[l], std::atan2(y[l], x[l]), kLastPlaces * 3);
  }
}

TEST(Simd, FindsHowThingsDecay) {
  RandomStream random(2);
  for (int i = 0; i < 10000; ++i) {
    Numbers x = of_all_sizes(random);
    for (double& one : x) one = -std::abs(one);
    Numbers decay, on_two;
    simd::run<Decay>(x.data(), decay.data());
    Decay::run<simd::Two>(x.data(), on_two.data());
    EXPECT_EQ(decay, on_two);
    for (size_t l = 0; l < kCount; ++l) {
      const double expected = std::exp(x[l]);
      EXPECT_NEAR(decay[l], expected, kLastPlaces * expected) << x[l];
    }
  }
}

TEST(Simd, LetsWhatIsFarAwayDecayToAlmostNothing) {
  const Numbers x{0, -0.0, -1e-300, -700, -1000, -1e300, -INFINITY, -709};
  Numbers decay;
  simd::run<Decay>(x.data(), decay.data());
  for (size_t l = 0; l < 3; ++l) EXPECT_EQ(decay[l], 1);
  for (size_t l = 3; l < kCount; ++l) {
    EXPECT_GE(decay[l], 0);
    EXPECT_LT(decay[l], 1e-303);
  }
}

TEST(Simd, RootsAreThoseOfTheStandard) {
  RandomStream random(3);
  Numbers x = of_all_sizes(random), root;
  for (double& one : x) one = std::abs(one);
  simd::run<Root>(x.data(), root.data());
  for (size_t l = 0; l < kCount; ++l) EXPECT_EQ(root[l], std::sqrt(x[l]));
}

}  // namespace
}  // namespace pliant
