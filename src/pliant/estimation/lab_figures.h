#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/estimation/statistics/curve_error.h"
#include "pliant/material/material.h"

namespace pliant {

/// A figure by which textile laboratories know a cloth, of one component of a material.
struct LabFigure {
  std::string component;
  std::string name;  ///< "secant_modulus", as in fit.json
  std::string unit;  ///< of the value: "N/m", "N m", "N" or "m"
  double value = 0;
  /// Where the material is read: extension (1), shear angle (rad) or curvature (1/m); nothing where
  /// the name says it.
  std::optional<double> at;
  std::optional<CurveError> error;  ///< nothing where it is not known
  bool beyond_range = false;        ///< read at strains that were not measured
};

/// The figures of a component, read off its law as a laboratory reads them off a chart.
///
/// Stretch and shear: `stiffness_at_rest`, `secant_modulus` at a round extension and at the end of
/// the range, while the cloth is first loaded, and `loop_width` at half of that extension after it
/// has turned there (N/m each, force per width over extension; of shear stress over strain).
/// Bending of a sheet: `rigidity_at_rest` and `secant_rigidity` at the end of the range, moment per
/// width over curvature (N m), `kes_B` and `kes_2HB` (kes_bending.h), and `bending_length` where
/// the density is known (bending_length.h).
/// Contraction: `poisson_ratio` of engineering strains, half way and at the end of the range, and
/// `coupling` (N/m), that of an elastic sheet whose strips stretch and narrow so.
/// Errors are those of the law's parameters, carried over by the figure's derivatives.
/// @param component  its stiffness is given; that of hinges has no figures
/// @param error_of   empty: no errors are known
std::vector<LabFigure> lab_figures(const Material& material, const std::string& component,
                                   const ErrorOfLaw& error_of);

}  // namespace pliant
