#include "pliant/math/quantiles.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace pliant {
namespace {

double student_quantile(double probability, double degrees) {
  return boost::math::quantile(boost::math::students_t(std::max(degrees, 1.0)), probability);
}

}  // namespace

double student_quantile_95(double degrees) { return student_quantile(0.975, degrees); }

double one_sided_student_quantile_95(double degrees) { return student_quantile(0.95, degrees); }

double chi_square_quantile(double probability, double degrees) {
  // Beyond these the incomplete gamma function takes too many terms; Wilson and Hilferty's normal
  // approximation is good to 1e-8 there.
  constexpr double kMany = 1e5;
  if (degrees > kMany) {
    const double part = 2 / (9 * degrees);
    const double z = boost::math::quantile(boost::math::normal(), probability);
    return degrees * std::pow(1 - part + z * std::sqrt(part), 3);
  }
  return boost::math::quantile(boost::math::chi_squared(std::max(degrees, 1.0)), probability);
}

}  // namespace pliant
