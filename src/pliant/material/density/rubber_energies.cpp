#include "pliant/material/density/rubber_energies.h"

#include <cmath>

namespace pliant {
namespace {

constexpr double kSeries = 0.5;  // below it the quotients below lose digits

// sum_k z^k / (k + first)! by its series.
double exponential_tail(double z, int first) {
  double term = 1, sum = 0;
  for (int k = 1; k <= first; ++k) term /= k;
  for (int k = 0; k < 18; ++k) {
    sum += term;
    term *= z / (k + 1 + first);
  }
  return sum;
}

// (exp(z) - 1) / z
double first_quotient(double z) {
  return std::abs(z) < kSeries ? exponential_tail(z, 1) : std::expm1(z) / z;
}

// (exp(z) - 1 - z) / z^2
double second_quotient(double z) {
  return std::abs(z) < kSeries ? exponential_tail(z, 2) : (std::expm1(z) - z) / (z * z);
}

// Its derivative: (exp(z) - first) / z, which is first - second.
double slope_of_first_quotient(double z) { return first_quotient(z) - second_quotient(z); }

// The derivative of the second: second - 2 third.
double slope_of_second_quotient(double z) {
  const double second = second_quotient(z);
  const double third = std::abs(z) < kSeries ? exponential_tail(z, 3) : (second - 0.5) / z;
  return second - 2 * third;
}

}  // namespace

EnergyAt linear_energy(double x, const Eigen::VectorXd& c) { return {c(0) * x, c(0), 0, {1}, {x}}; }

EnergyAt polynomial_energy(double x, const Eigen::VectorXd& c) {
  return {x * (c(0) + x * (c(1) + x * c(2))),
          c(0) + x * (2 * c(1) + x * 3 * c(2)),
          2 * c(1) + 6 * x * c(2),
          {1, 2 * x, 3 * x * x},
          {x, x * x, x * x * x}};
}

EnergyAt ogden_energy(double x, const Eigen::VectorXd& mu_alpha) {
  const double mu = mu_alpha(0), alpha = mu_alpha(1);
  const double log = std::log1p(x), stretch = 1 + x, z = alpha * log;
  const double unit = 2 * log * first_quotient(z) / stretch;  // stress of mu = 1
  const double energy = 2 * log * log * second_quotient(z);
  return {mu * energy,
          mu * unit,
          mu * (2 * std::exp(z) / stretch - unit) / stretch,
          {unit, 2 * mu * log * log * slope_of_first_quotient(z) / stretch},
          {energy, 2 * mu * log * log * log * slope_of_second_quotient(z)}};
}

EnergyAt arruda_boyce_energy(double x, const Eigen::VectorXd& mu_lock) {
  const double mu = mu_lock(0), lock = mu_lock(1), first = x + 3;
  EnergyAt at;
  double per_lock = 1;  // lock^(2 - 2 i)
  for (std::size_t k = 0; k < kSeriesOfChains.size(); ++k) {
    const auto i = static_cast<double>(k + 1);
    const double c = kSeriesOfChains[k] * per_lock, less = c * i * std::pow(first, i - 1);
    const double energy = c * (std::pow(first, i) - std::pow(3.0, i));
    at.energy += mu * energy;
    at.stress += mu * less;
    at.tangent += mu * less * (i - 1) / first;
    at.stress_by_parameter[0] += less;
    at.stress_by_parameter[1] += mu * less * (2 - 2 * i) / lock;
    at.energy_by_parameter[0] += energy;
    at.energy_by_parameter[1] += mu * energy * (2 - 2 * i) / lock;
    per_lock /= lock * lock;
  }
  return at;
}

EnergyAt exponential_energy(double x, const Eigen::VectorXd& c_b) {
  const double c = c_b(0), b = c_b(1), growth = std::exp(b * x), unit = x * first_quotient(b * x);
  return {c * unit,
          c * growth,
          b * c * growth,
          {growth, c * x * growth},
          {unit, c * x * x * slope_of_first_quotient(b * x)}};
}

}  // namespace pliant
