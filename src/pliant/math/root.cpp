#include "pliant/math/root.h"

#include <algorithm>
#include <cstdint>

#include <boost/math/tools/roots.hpp>

namespace pliant {

double root_in_bracket(const std::function<double(double)>& f, double low, double high) {
  const double f_low = f(low), f_high = f(high);
  if (f_low == 0) return low;
  if (f_high == 0) return high;
  const bool rising = low < high;
  std::uintmax_t steps = 200;
  const auto [left, right] = boost::math::tools::toms748_solve(
      f, rising ? low : high, rising ? high : low, rising ? f_low : f_high, rising ? f_high : f_low,
      boost::math::tools::eps_tolerance<double>(), steps);
  return (left + right) / 2;
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
