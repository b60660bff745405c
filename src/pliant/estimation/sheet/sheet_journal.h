#pragma once

#include <vector>

#include "pliant/base/journal.h"
#include "pliant/estimation/least_squares.h"
#include "pliant/estimation/sheet/sheet_plan.h"
#include "pliant/estimation/sheet/sheet_problem.h"

namespace pliant {

/// Begins a fit of sheets in a journal: its first question names the data, the settings and the
/// start, so that the progress of another fit is refused.
/// @param start  may be null
/// @return the shapes that a fit which was stopped had found
SheetGuesses begin_journal(Journal& journal, const FitSettings& settings,
                           const std::vector<SheetStage>& plan, const Material* start);

void keep_shapes(Journal& journal, const SheetGuesses& shapes);

/// What an answer has cost stands at its end.
void append_counts(const EquilibriumCounts& counts, Journal::Numbers& answer);
/// Takes it off there.
EquilibriumCounts take_counts(Journal::Numbers& answer);

/// A problem whose best values so far go to the journal.
/// @param journal  outlives the problem
LeastSquaresProblem with_journal(LeastSquaresProblem problem, Journal& journal);

}  // namespace pliant
