#pragma once

#include <vector>

#include "pliant/report/figure.h"
#include "pliant/report/plot_style.h"
#include "pliant/report/sheet_session.h"

namespace pliant::report {

/// Measured lines are thin and predicted ones thick, as in [T] Fig. 3.6.
inline constexpr SeriesStyle kMeasuredSheet = {"measured-sheet", "measured", "#b34700",
                                               "solid",          nullptr,    1.0};
inline constexpr SeriesStyle kPredictedSheet = {"predicted-sheet", "material", "#00538a",
                                                "solid",           nullptr,    3.0};

/// What `force_curves` sums up of both, over how far the session has gone.
/// @param compact  for the small figures of page one
Figure sheet_force_figure(const SheetSession& sheet, bool compact);

/// Some frames seen from the side: the nodes along the middle of the sheet, across the edge of the
/// table or along weft.
Figure sheet_profile_figure(const SheetSession& sheet, bool compact);

/// One of them: forces where there are clips.
Figure sheet_figure(const SheetSession& sheet, bool compact);

}  // namespace pliant::report
