#pragma once

#include <optional>
#include <vector>

#include "pliant/estimation/unknown.h"
#include "pliant/experiment/session/sheet_test.h"

namespace pliant {

// `bounds`, `fix` and `priors` of a study in fits of sheets. A curve gets its control points one
// after the other, so that their numbers mean nothing beforehand: COMPONENT.k stands for all of
// them.

/// The stiffness that a study fixes for a group of components.
std::optional<double> fixed_stiffness(const FitOptions& options, const ComponentGroup& group);

/// @throws InputError for bounds, fixed values and priors of parameters that a fit of sheets to
///         these tests does not have
void require_known_parameters(const FitSettings& settings,
                              const std::vector<const SheetTest*>& tests);

}  // namespace pliant
