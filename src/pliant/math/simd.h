#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

// What is passed by value here is inlined: no call depends on how.
#pragma GCC diagnostic ignored "-Wpsabi"

/// Arithmetic on a few numbers at once, in the widest vector instructions that the processor has
/// when the program runs. The same operations are made number by number whatever the width, without
/// fused multiplication and addition, so that bits do not depend on the processor. Nor do those of
/// `atan2` and `exp_of_negative`, as those of a mathematical library may.
namespace pliant::simd {

using Two = double __attribute__((vector_size(16)));
using Four = double __attribute__((vector_size(32)));

template <class V>
inline constexpr int kWidth = sizeof(V) / sizeof(double);

#define PLIANT_INLINE [[gnu::always_inline]] inline

#if defined(__x86_64__)
template <class Work, class... Arguments>
[[gnu::target("avx2")]] void run_on_four(Arguments... arguments) {
  Work::template run<Four>(arguments...);
}
#endif

/// While one lives, `run` takes two numbers at once on its thread, as on a processor that cannot
/// take more: to compare bits.
class Narrow {
 public:
  Narrow() : before_(std::exchange(holds_, true)) {}
  ~Narrow() { holds_ = before_; }
  Narrow(const Narrow&) = delete;
  Narrow& operator=(const Narrow&) = delete;
  static bool holds() { return holds_; }

 private:
  inline static constinit thread_local bool holds_ = false;
  bool before_;
};

/// Work::run<V>(arguments...), with V as wide as the processor's instructions. What it calls must
/// be PLIANT_INLINE, as it is itself.
template <class Work, class... Arguments>
void run(Arguments... arguments) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && !Narrow::holds()) {
    run_on_four<Work>(arguments...);
    return;
  }
#endif
  Work::template run<Two>(arguments...);
}

template <class V>
PLIANT_INLINE V load(const double* from) {
  V v;
  std::memcpy(&v, from, sizeof(V));
  return v;
}

template <class V>
PLIANT_INLINE void store(const V& v, double* to) {
  std::memcpy(to, &v, sizeof(V));
}

/// The same number everywhere.
template <class V>
PLIANT_INLINE V all(double x) {
  return x - V{};  // also of -0
}

/// Whole numbers of the same size: bits, and what comparisons give.
template <class V>
using Bits = decltype(V{} < V{});

template <class V>
PLIANT_INLINE Bits<V> bits(const V& x) {
  return __builtin_bit_cast(Bits<V>, x);
}

template <class V>
PLIANT_INLINE V with_bits(const Bits<V>& x) {
  return __builtin_bit_cast(V, x);
}

/// Bits whose sums may overflow.
using WholeTwo = std::uint64_t __attribute__((vector_size(16)));
using WholeFour = std::uint64_t __attribute__((vector_size(32)));
PLIANT_INLINE WholeTwo whole(const Two& x) { return __builtin_bit_cast(WholeTwo, x); }
PLIANT_INLINE WholeFour whole(const Four& x) { return __builtin_bit_cast(WholeFour, x); }

template <class V>
PLIANT_INLINE V absolute(const V& x) {
  return with_bits<V>(bits(x) & ~bits(all<V>(-0.0)));
}

/// The size of x with the sign of `sign`.
template <class V>
PLIANT_INLINE V with_sign(const V& x, const V& sign) {
  const auto of_sign = bits(all<V>(-0.0));
  return with_bits<V>((bits(x) & ~of_sign) | (bits(sign) & of_sign));
}

/// Whether a comparison is true anywhere.
PLIANT_INLINE bool any(const Bits<Two>& x) { return (x[0] | x[1]) != 0; }
PLIANT_INLINE bool any(const Bits<Four>& x) { return (x[0] | x[1] | x[2] | x[3]) != 0; }

PLIANT_INLINE Two square_root(const Two& x) {
#if defined(__SSE2__)
  return _mm_sqrt_pd(x);
#else
  return Two{std::sqrt(x[0]), std::sqrt(x[1])};
#endif
}

PLIANT_INLINE Four square_root(const Four& x) {
  const Two low = square_root(Two{x[0], x[1]}), high = square_root(Two{x[2], x[3]});
  return Four{low[0], low[1], high[0], high[1]};
}

/// A number that pushes the digits behind the point out of another, |x| < 2^51, added to it.
inline constexpr double kPush = 6755399441055744.0;  // 3 2^51

/// The nearest whole number; of two, the even one.
template <class V>
PLIANT_INLINE V rounded(const V& x) {
  return (x + kPush) - kPush;
}

/// The angle of (x, y), in [-pi, pi], within two units in the last place; 0 at the origin. The
/// polynomial is that of fdlibm (s_atan.c) for |z| < 7/16.
template <class V>
PLIANT_INLINE V atan2(const V& y, const V& x) {
  constexpr double kHalfPi = 1.57079632679489661923, kPi = 3.14159265358979323846;
  constexpr double kHalfPiRest = 6.12323399573676603587e-17;  // what is lost of it
  constexpr double kLimit = 0.41421356237309504880;           // tan(pi / 8)
  const V ax = absolute(x), ay = absolute(y);
  const auto steep = ay > ax;
  const V low = steep ? ax : ay, high = steep ? ay : ax;
  const auto turned = low > kLimit * high;  // by an eighth of a turn
  const V top = turned ? low - high : low;
  V bottom = turned ? low + high : high;
  bottom = bottom == 0 ? all<V>(1) : bottom;
  const V z = top / bottom, w = z * z, v = w * w;
  const V even =
      w * (3.33333333333329318027e-01 +
           v * (1.42857142725034663711e-01 +
                v * (9.09088713343650656196e-02 +
                     v * (6.66107313738753120669e-02 +
                          v * (4.97687799461593236017e-02 + v * 1.62858201153657823623e-02)))));
  const V odd =
      v * (-1.99999999998764832476e-01 +
           v * (-1.11111104054623557880e-01 +
                v * (-7.69187620504482999495e-02 +
                     v * (-5.83357013379057348645e-02 + v * -3.65315727442169155270e-02))));
  const V small = z * (even + odd);
  const V zero{};
  // pi / 4 as a half of pi / 2, in two parts.
  V angle = turned ? kHalfPi / 2 - ((small - kHalfPiRest / 2) - z) : z - small;
  angle = steep ? kHalfPi - (angle - kHalfPiRest) : angle;
  angle = x < zero ? kPi - (angle - 2 * kHalfPiRest) : angle;
  return with_sign(angle, y);
}

/// exp(x) for x <= 0, within two units in the last place; below -700 the value there.
template <class V>
PLIANT_INLINE V exp_of_negative(const V& x) {
  constexpr double kPerLog2 = 1.44269504088896338700;
  constexpr double kLog2 = 6.93147180369123816490e-01, kLog2Rest = 1.90821492927058770002e-10;
  const V at = x > -700.0 ? x : all<V>(-700);
  const V pushed = at * kPerLog2 + kPush, power = pushed - kPush;
  const V r = (at - power * kLog2) - power * kLog2Rest;  // |r| <= log(2) / 2
  // The series to the twelfth power, whose rest is 2e-16 of the whole.
  V sum = all<V>(1.0 / 479001600);
  sum = sum * r + 1.0 / 39916800;
  sum = sum * r + 1.0 / 3628800;
  sum = sum * r + 1.0 / 362880;
  sum = sum * r + 1.0 / 40320;
  sum = sum * r + 1.0 / 5040;
  sum = sum * r + 1.0 / 720;
  sum = sum * r + 1.0 / 120;
  sum = sum * r + 1.0 / 24;
  sum = sum * r + 1.0 / 6;
  sum = sum * r + 0.5;
  sum = r + r * r * sum;
  // Times 2^power: the whole number stands in the last bits of `pushed`, the exponent 52 bits up.
  const V value = 1.0 + sum;
  return __builtin_bit_cast(V, whole(value) + (whole(pushed) << 52));
}

}  // namespace pliant::simd
