#include "pliant/estimation/statistics/specimens.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <boost/math/tools/roots.hpp>

#include "pliant/base/assert.h"
#include "pliant/math/quantiles.h"

namespace pliant {
namespace {

constexpr double kSmallestVarianceShare = 1e-12;  // of the spread: equal weights then
constexpr int kBits = 30;                         // of between_sd^2

/// Weighed mean and squares about it, with a between-specimen variance.
struct Weighed {
  double mean = 0, squares = 0, weights = 0;
};

Weighed weighed(const SpecimenFits& fits, double between, double least) {
  Weighed result;
  for (size_t i = 0; i < fits.value.size(); ++i) {
    const double weight = 1 / std::max(between + fits.variance[i], least);
    result.weights += weight;
    result.mean += weight * fits.value[i];
  }
  result.mean /= result.weights;
  for (size_t i = 0; i < fits.value.size(); ++i) {
    const double weight = 1 / std::max(between + fits.variance[i], least);
    result.squares += weight * (fits.value[i] - result.mean) * (fits.value[i] - result.mean);
  }
  return result;
}

/// A joint fit gives a specimen the share 1 / variance, whatever the material does: by how much
/// that raises the variance of a mean over specimens that differ, against equal shares.
double unevenness(const SpecimenFits& fits, double least) {
  double sum = 0, squares = 0;
  for (const double variance : fits.variance) {
    const double weight = 1 / std::max(variance, least);
    sum += weight;
    squares += weight * weight;
  }
  return static_cast<double>(fits.value.size()) * squares / (sum * sum);
}

/// The variance at which the weighed squares are as many as the degrees of freedom.
double paule_mandel(const SpecimenFits& fits, double largest, double least) {
  const auto degrees = static_cast<double>(fits.value.size() - 1);
  const auto excess = [&](double between) {
    return weighed(fits, between, least).squares - degrees;
  };
  if (excess(0) <= 0) return 0;
  std::uintmax_t rounds = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, 0.0, largest, boost::math::tools::eps_tolerance<double>(kBits), rounds);
  return (bracket.first + bracket.second) / 2;
}

}  // namespace

std::optional<SpecimenSpread> specimen_spread(const SpecimenFits& fits) {
  PLIANT_ASSERT(fits.value.size() == fits.variance.size(), "each fit has a variance");
  if (fits.value.size() < 2) return std::nullopt;
  const auto [low, high] = std::minmax_element(fits.value.begin(), fits.value.end());
  const double range = *high - *low;
  SpecimenSpread spread;
  spread.degrees = static_cast<double>(fits.value.size() - 1);
  spread.mean = *low;
  if (range == 0) return spread;
  const double least = kSmallestVarianceShare * range * range;
  // With weights of 1 / (m range^2) at most the squares are below 1.
  const double largest = static_cast<double>(fits.value.size()) * range * range;
  const double between = paule_mandel(fits, largest, least);
  const Weighed at = weighed(fits, between, least);
  spread.between_sd = std::sqrt(between);
  spread.mean = at.mean;
  const auto count = static_cast<double>(fits.value.size());
  const double variance = std::max(at.squares / (spread.degrees * at.weights), between / count);
  spread.mean_sd = std::sqrt(variance * unevenness(fits, least));
  return spread;
}

MeanError fabric_mean_error(double joint_sd, double joint_degrees,
                            const std::optional<SpecimenSpread>& spread) {
  MeanError error{joint_sd, joint_degrees, student_quantile_95(joint_degrees) * joint_sd};
  if (!spread) return error;
  const double half_width = student_quantile_95(spread->degrees) * spread->mean_sd;
  if (!(half_width <= error.half_width)) error = {spread->mean_sd, spread->degrees, half_width};
  return error;
}

}  // namespace pliant
