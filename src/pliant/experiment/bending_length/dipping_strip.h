#pragma once

#include <optional>

#include <Eigen/Core>

#include "pliant/material/component_law.h"

namespace pliant {

/// Which way a strip bends: as it lies, to the right of its way out (negative curvature), or turned
/// over.
enum class StripFace { up, down };

/// A strip that was pushed out over an edge until the line from the edge to its tip dips by an
/// angle.
struct DippingStrip {
  double overhang = 0;           ///< m
  double edge_curvature = 0;     ///< 1/m, where it leaves the edge; negative with the face up
  Eigen::VectorXd by_parameter;  ///< d overhang / d parameters of the law; empty unless asked for
};

/// How a strip is asked for.
struct DipOptions {
  StripFace face = StripFace::up;
  bool with_derivatives = false;
  int elements = 6;  ///< of the elastica
};

/// The shortest overhang at which a strip dips by an angle. The strip starts flat and free of
/// friction, and bends under its own weight once.
/// @param weight  per area, > 0 (N/m^2)
/// @param angle   rad, in (0, pi/2)
/// @return nothing when no overhang between 1 mm and 10 m reaches the angle, or none has an
///         equilibrium there
std::optional<DippingStrip> dipping_strip(const ComponentLaw& law, double weight, double angle,
                                          const DipOptions& options = {});

}  // namespace pliant
