#pragma once

#include <optional>
#include <span>

#include "pliant/material/material.h"
#include "pliant/report/curves.h"
#include "pliant/report/figure.h"

namespace pliant::report {

bool has_friction(const ComponentCurve& curve);

/// Stress against strain of one component with its 95 % band; below it how many measured points
/// there are at each strain. Of stretch the axes have both extension and Green strain.
/// @param membrane       measure of the strains, as far as it is known
/// @param data_strains   the strains of the rows that the fit used
/// @param show_friction  false draws the elastic part alone (friction not determined)
Figure stress_strain_figure(const ComponentCurve& curve, std::optional<MembraneMeasure> membrane,
                            std::span<const double> data_strains, bool show_friction);

/// Stress against strain of a component of sheets with its 95 % band, in a cycle where it has
/// friction; below it how many elements of sheets have each strain.
Figure sheet_curve_figure(const ComponentCurve& curve, std::optional<MembraneMeasure> membrane,
                          std::span<const double> sheet_strains);

/// The friction stress of the same cycle between the bounds +- sigma_max(strain).
/// The curve must have its elastic part and its friction bound.
Figure friction_figure(const ComponentCurve& curve, std::optional<MembraneMeasure> membrane);

}  // namespace pliant::report
