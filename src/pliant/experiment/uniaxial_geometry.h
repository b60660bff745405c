#pragma once

#include "pliant/material/material.h"

namespace pliant {

/// A strip or square under uniform stretch along one direction, clamped at its ends ([T] 5.3.2).
struct UniaxialGeometry {
  double gauge_length = 0;  ///< rest length between the clamps (m)
  double width = 0;         ///< across the pull (m)
  MembraneMeasure measure = MembraneMeasure::stvk;
};

/// Strain of the strip at a length between the clamps (m): Green-Lagrange for stvk, else L / L0
/// - 1.
double strain_at(const UniaxialGeometry& geometry, double length);

/// d strain / d length (1/m).
double strain_slope(const UniaxialGeometry& geometry, double length);

double length_at(const UniaxialGeometry& geometry, double strain);

/// Engineering extension, L / L0 - 1, of a strip at a strain.
double extension_at(MembraneMeasure measure, double strain);

/// Force per stress (m): area times d strain / d length ([T] Eq. 5.5), as a function of strain.
double force_factor(const UniaxialGeometry& geometry, double strain);

/// d force factor / d strain (m).
double force_factor_slope(const UniaxialGeometry& geometry, double strain);

}  // namespace pliant
