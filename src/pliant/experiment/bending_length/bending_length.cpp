#include "pliant/experiment/bending_length/bending_length.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/bending_length/dipping_strip.h"
#include "pliant/material/bending_strain.h"

namespace pliant {
namespace {

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// Standard deviation over mean; nothing for a single value.
std::optional<double> variation_of(const std::vector<double>& values) {
  if (values.size() < 2) return std::nullopt;
  const double mean = mean_of(values);
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size() - 1)) / mean;
}

}  // namespace

double read_overhang_angle(Fields& fields) {
  const auto value = fields.optional("angle");
  if (!value) return kOverhangAngle;
  const double angle = value->positive_quantity(Dimension::angle);
  if (angle >= std::numbers::pi / 2) {
    value->fail("is 90 degrees or more", "the dip of the line to the tip, e.g. 41.5 deg");
  }
  return angle;
}

std::optional<BendingLength> bending_length(const ComponentLaw& law, double area_density,
                                            double angle) {
  PLIANT_ASSERT(area_density > 0, "its own weight bends the strip");
  const double weight = area_density * kStandardGravity;
  const auto strip = dipping_strip(law, weight, angle);
  if (!strip) return std::nullopt;
  BendingLength result;
  result.overhang = strip->overhang;
  result.length = result.overhang / 2;
  result.flexural_rigidity = weight * std::pow(result.length, 3);
  return result;
}

std::optional<ElasticDip> elastic_dip(double angle) {
  // Of a natural length of 5 cm: in the middle of the lengths that are looked through.
  constexpr double kLength = 0.05;
  const double weight = 1 / std::pow(kLength, 3);
  ComponentLaw unit;
  unit.stiffness = ScalarCurve::constant(1 / kStrainPerCurvature);
  const auto strip = dipping_strip(unit, weight, angle);
  if (!strip) return std::nullopt;
  return ElasticDip{strip->overhang / kLength, std::abs(strip->edge_curvature) * strip->overhang};
}

std::optional<BendingLengthSpread> bending_length_spread(const std::vector<double>& overhangs,
                                                         double angle, double weight) {
  PLIANT_ASSERT(!overhangs.empty(), "nothing to take the mean of");
  const auto elastic = elastic_dip(angle);
  if (!elastic) return std::nullopt;
  std::vector<double> lengths, rigidities;
  for (const double overhang : overhangs) {
    lengths.push_back(overhang / elastic->overhang_per_length);
    rigidities.push_back(weight * std::pow(lengths.back(), 3));
  }
  BendingLengthSpread spread;
  spread.readings = static_cast<int>(overhangs.size());
  spread.length = mean_of(lengths);
  spread.length_variation = variation_of(lengths);
  spread.flexural_rigidity = weight * std::pow(spread.length, 3);
  spread.rigidity_variation = variation_of(rigidities);
  return spread;
}

}  // namespace pliant
