#pragma once

#include <string>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/estimation/sheet/sheet_uncertainty.h"
#include "pliant/study/sheet_experiment.h"
#include "pliant/study/study.h"

namespace pliant {

/// Whether a study has sessions to be fitted.
bool fits_sheets(const Study& study);

/// What a fit found counts as measured, and so does what the study states; its guesses as assumed.
void set_status(const FitSettings& settings, SheetFit& fit);

/// Fits of sheets know nothing of some options of strips.
/// @throws InputError
void refuse_foreign_options(const FitSettings& settings);

/// The mass per area that the first of some sheets states (kg/m^2); 0 where none does.
double stated_density(const std::vector<SheetExperiment>& experiments);

/// The tests that are to be fitted.
std::vector<const SheetTest*> tests_to_fit(const std::vector<SheetExperiment>& experiments);

/// The settings of a study's fit, by whose digest its progress is known again.
FitSettings settings_of(const Study& study);

/// Adds what a fit of sheets found to the result of its study: parameters, predictions, curves of
/// its groups, what it leaves undetermined.
void add_sheets(const SheetFit& fit, const SheetUncertainty& uncertainty,
                const std::vector<SheetExperiment>& experiments,
                std::vector<ExperimentResult> predictions, StudyResult& result);

/// Root mean square of the errors of the fitted experiments, each in per cent of its peak force or
/// its sheet's side: the number by which fits of the same experiments are compared.
double misfit_percent(const std::vector<ExperimentResult>& experiments);

/// A solution of a smaller variant of a study's model, where a fit may begin.
struct SheetStart {
  std::string variant;
  Material material;
  CordFrictions cords = {};
};

/// Fits a material to the sessions of a study, and predicts all of them with it.
/// @param starts  the fit begins at each of them, too; the best is kept, which may be a start as it
///                is
/// @throws InputError, SolverError, Interrupted
StudyResult fit_sheet_study(const Study& study, const RunContext& context,
                            const std::vector<SheetStart>& starts = {});

/// Adds the predictions of a study's sessions with a material to a result, and asks for the
/// friction of cords that neither study nor `cords` tell. Where the material lacks a component
/// sessions are skipped.
/// @param cords  of the fit of the material
void evaluate_sheets(const Study& study, const Material& material, const CordFrictions& cords,
                     const RunContext& context, StudyResult& result);

}  // namespace pliant
