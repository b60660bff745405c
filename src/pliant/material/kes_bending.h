#pragma once

#include <optional>

#include "pliant/material/material.h"

namespace pliant {

/// What the pure-bending test of the Kawabata system (KES-FB2) prints of a sheet: numbers of the
/// loop of moment per width over curvature between -2.5/cm and +2.5/cm, once it has closed. Both
/// sides of the sheet count, as the means of them (docs/bending.md).
struct KesBending {
  /// B: mean slope of the loop, its two branches, between 0.5/cm and 1.5/cm (N m, per width).
  double rigidity = 0;
  /// 2HB: width of the loop at 1/cm (N, per width).
  double hysteresis = 0;
  /// Curvature at which unloading from 2.5/cm comes to rest without moment (1/m); none for a sheet
  /// that takes no moment at all.
  std::optional<double> residual_curvature;
};

inline constexpr double kKesLargestCurvature = 250;        ///< 1/m, where the loop turns
inline constexpr double kKesSlopeCurvature[] = {50, 150};  ///< 1/m, between which B is the slope
inline constexpr double kKesHysteresisCurvature = 100;     ///< 1/m, where 2HB is the width

/// The numbers that the test would give for a bending component: its whole law is carried round the
/// loop, stiffness curve and Dahl friction.
/// @param component  its stiffness is given
KesBending kes_bending(const MaterialComponent& component);

}  // namespace pliant
