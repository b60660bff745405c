#include "pliant/experiment/uniaxial_geometry.h"

#include <cmath>

namespace pliant {
namespace {

bool is_green_lagrange(const UniaxialGeometry& geometry) {
  return geometry.measure == MembraneMeasure::stvk;
}

}  // namespace

double strain_at(const UniaxialGeometry& geometry, double length) {
  const double stretch = length / geometry.gauge_length;
  return is_green_lagrange(geometry) ? (stretch * stretch - 1) / 2 : stretch - 1;
}

double strain_slope(const UniaxialGeometry& geometry, double length) {
  const double per_length = 1 / geometry.gauge_length;
  return is_green_lagrange(geometry) ? length * per_length * per_length : per_length;
}

double length_at(const UniaxialGeometry& geometry, double strain) {
  const double stretch = is_green_lagrange(geometry) ? std::sqrt(1 + 2 * strain) : 1 + strain;
  return stretch * geometry.gauge_length;
}

double extension_at(MembraneMeasure measure, double strain) {
  return length_at({.gauge_length = 1, .width = 1, .measure = measure}, strain) - 1;
}

double force_factor(const UniaxialGeometry& geometry, double strain) {
  return is_green_lagrange(geometry) ? geometry.width * std::sqrt(1 + 2 * strain) : geometry.width;
}

double force_factor_slope(const UniaxialGeometry& geometry, double strain) {
  return is_green_lagrange(geometry) ? geometry.width / std::sqrt(1 + 2 * strain) : 0;
}

}  // namespace pliant
