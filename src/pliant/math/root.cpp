#include "pliant/math/root.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant {

double root_in_bracket(const std::function<double(double)>& f, double low, double high) {
  double f_low = f(low), f_high = f(high);
  if (f_low == 0) return low;
  if (f_high == 0) return high;
  constexpr double kRounding = 2 * std::numeric_limits<double>::epsilon();
  int kept_side = 0;
  for (int i = 0; i < 200; ++i) {
    const double width = std::abs(high - low);
    if (width <= kRounding * std::max(std::abs(low), std::abs(high))) break;
    double x = (low * f_high - high * f_low) / (f_high - f_low);
    // Every fourth step halves the bracket, whatever the secant says.
    if (i % 4 == 3 || !(x > std::min(low, high) && x < std::max(low, high))) x = (low + high) / 2;
    const double fx = f(x);
    if (fx == 0) return x;
    if ((fx < 0) == (f_low < 0)) {
      low = x;
      f_low = fx;
      if (kept_side == 1) f_high /= 2;
      kept_side = 1;
    } else {
      high = x;
      f_high = fx;
      if (kept_side == -1) f_low /= 2;
      kept_side = -1;
    }
  }
  return (low + high) / 2;
}

std::optional<double> first_root(const std::function<double(double)>& f, double from, double step,
                                 double limit) {
  const double f_from = f(from);
  if (f_from == 0) return from;
  for (double low = from; step > 0 ? low < limit : low > limit;) {
    const double high = step > 0 ? std::min(low + step, limit) : std::max(low + step, limit);
    const double f_high = f(high);
    if ((f_high < 0) != (f_from < 0) || f_high == 0) return root_in_bracket(f, low, high);
    low = high;
  }
  return std::nullopt;
}

}  // namespace pliant
