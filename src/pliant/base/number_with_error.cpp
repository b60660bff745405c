#include "pliant/base/number_with_error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace pliant {

std::string number_with_error(double value, double error) {
  const int last = static_cast<int>(std::floor(std::log10(error))) - 1;
  const double step = std::pow(10, last);
  const auto rounded = [&](double number) {
    return fmt::format("{:.{}f}", std::round(number / step) * step, std::max(-last, 0));
  };
  return rounded(value) + " +- " + rounded(error);
}

}  // namespace pliant
