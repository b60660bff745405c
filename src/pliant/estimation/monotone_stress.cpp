#include "pliant/estimation/monotone_stress.h"

#include <cmath>
#include <vector>

namespace pliant {
namespace {

constexpr int kSamplesPerSpan = 16;

/// Where tangents are looked at; nowhere for constants.
std::vector<double> strains_of(const ScalarCurve& stiffness, double largest_strain) {
  if (stiffness.kind() == CurveKind::constant) return {};
  if (stiffness.kind() == CurveKind::affine) return {0, largest_strain};
  std::vector<double> strains;
  const std::vector<double>& knots = stiffness.knots();
  for (std::size_t i = 1; i < knots.size(); ++i) {
    for (int k = 0; k < kSamplesPerSpan; ++k) {
      strains.push_back(knots[i - 1] + (knots[i] - knots[i - 1]) * k / kSamplesPerSpan);
    }
  }
  if (knots.size() < 2) return {};
  // The slope jumps to zero at the ends; inside of them is what counts.
  strains.front() = std::nextafter(knots.front(), knots.back());
  strains.push_back(std::nextafter(knots.back(), knots.front()));
  return strains;
}

}  // namespace

Eigen::MatrixXd elastic_tangents(const ScalarCurve& stiffness, double largest_strain) {
  const std::vector<double> strains = strains_of(stiffness, largest_strain);
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(strains.size()), stiffness.size());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const double strain = strains[static_cast<std::size_t>(i)];
    rows.row(i) = stiffness.weights(strain) + strain * stiffness.slope_weights(strain);
  }
  return rows;
}

}  // namespace pliant
