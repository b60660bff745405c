#pragma once

#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/estimation/sheet/sheet_problem.h"
#include "pliant/study/sheet_experiment.h"

namespace pliant {

/// What a material predicts of experiments, compared with what was measured. Frames without
/// equilibrium are missing in it.
/// @param cords  of fitted experiments; unknown ones of others are taken to drag as these do on the
///               average
/// @param work   gets what it has cost
/// @throws SolverError where no frame of an experiment has one
std::vector<ExperimentResult> sheet_predictions(const std::vector<SheetExperiment>& experiments,
                                                const Material& material,
                                                const CordFrictions& cords,
                                                const RunContext& context, EquilibriumWork& work);

/// Warns of the frames that are missing.
void warn_of_missing_frames(const std::vector<ExperimentResult>& experiments, StudyResult& result);

/// Warns of fitted sessions that state their noise and are missed by several times as much.
/// @param predictions  of the experiments, in their order
void warn_of_misfit(const std::vector<SheetExperiment>& experiments,
                    const std::vector<ExperimentResult>& predictions, StudyResult& result);

}  // namespace pliant
