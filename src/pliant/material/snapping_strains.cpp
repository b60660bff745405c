#include "pliant/material/snapping_strains.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "pliant/math/root.h"

namespace pliant {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A cubic stiffness makes the tangent a cubic too: this many samples a span separate its roots.
constexpr int kSamplesPerSpan = 64;

/// |strain| at which a law is looked at: zero, samples of the spans of its curve on one side, its
/// last knot; where it has addends up to `reach` at least.
std::vector<double> samples_of(const ComponentLaw& law, int side, double reach) {
  std::vector<double> ends{0};
  for (const double knot : law.stiffness.knots()) {
    if (side * knot > 0) ends.push_back(side * knot);
  }
  if (!law.addends.empty() && std::abs(reach) > ends.back()) ends.push_back(std::abs(reach));
  std::sort(ends.begin(), ends.end());
  std::vector<double> samples{0};
  for (std::size_t i = 1; i < ends.size(); ++i) {
    for (int k = 1; k <= kSamplesPerSpan; ++k) {
      samples.push_back(ends[i - 1] + (ends[i] - ends[i - 1]) * k / kSamplesPerSpan);
    }
  }
  return samples;
}

/// Intervals in which `f` is negative, sampled; beyond the last sample it keeps the sign it has
/// there.
std::vector<StrainInterval> negative_intervals(const std::function<double(double)>& f,
                                               const std::vector<double>& samples) {
  std::vector<StrainInterval> intervals;
  bool inside = f(samples.front()) < 0;
  if (inside) intervals.push_back({samples.front(), kInfinity});
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const bool negative = f(samples[i]) < 0;
    if (negative == inside) continue;
    const double crossing = root_in_bracket(f, samples[i - 1], samples[i]);
    if (negative) {
      intervals.push_back({crossing, kInfinity});
    } else {
      intervals.back().to = crossing;
    }
    inside = negative;
  }
  return intervals;
}

/// Where the tangent k1 + 2 k2 |strain| falls below b.
std::vector<StrainInterval> affine_snapping(double k1, double k2, double b) {
  const bool at_zero = k1 < b;
  if (k2 == 0)
    return at_zero ? std::vector<StrainInterval>{{0, kInfinity}} : std::vector<StrainInterval>{};
  const double crossing = (b - k1) / (2 * k2);
  if (k2 > 0)
    return at_zero ? std::vector<StrainInterval>{{0, crossing}} : std::vector<StrainInterval>{};
  return {{at_zero ? 0 : crossing, kInfinity}};
}

}  // namespace

std::vector<StrainInterval> snapping_strains(const ComponentLaw& law, int side, double reach) {
  const double b = law.fall();
  const ScalarCurve& stiffness = law.stiffness;
  const std::vector<double>& values = stiffness.values();
  if (law.addends.empty() && stiffness.kind() == CurveKind::constant) {
    return affine_snapping(values[0], 0, b);
  }
  if (law.addends.empty() && stiffness.kind() == CurveKind::affine) {
    return affine_snapping(values[0], values[1], b);
  }
  return negative_intervals([&](double strain) { return law.elastic_tangent(side * strain) - b; },
                            samples_of(law, stiffness.even() ? 1 : side, reach));
}

}  // namespace pliant
