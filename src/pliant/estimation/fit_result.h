#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/fit_settings.h"
#include "pliant/estimation/judgement.h"
#include "pliant/estimation/lab_figures.h"
#include "pliant/estimation/start_search.h"
#include "pliant/estimation/statistics/outliers.h"
#include "pliant/estimation/whole_sheet_result.h"
#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/loop_figures.h"
#include "pliant/experiment/loop_metrics.h"
#include "pliant/experiment/session/equilibrium_work.h"
#include "pliant/io/vtu.h"
#include "pliant/material/material.h"
#include "pliant/measurement/session.h"
#include "pliant/measurement/session/fold_error.h"

namespace pliant {

/// An estimated number with what the data says about it.
struct ParameterEstimate {
  std::string name;
  std::string owner;  ///< component of a law's parameter, experiment of a nuisance parameter
  std::string unit;
  double value = 0;
  std::optional<double> std_error;
  std::optional<double> lower, upper;  ///< 95 % interval
  bool identified = false;             ///< determined at least weakly
  Determination determination = Determination::none;
  std::optional<double> limit;  ///< one-sided 95 % limit where it is at a bound
  bool at_bound = false;
  bool fixed = false;
  bool of_friction = false;
  std::optional<double> between_specimen_sd;
  std::string told_by = {};  ///< experiments, by their shares of what is known of it
  std::string note;          ///< e.g. the strain of a control point
};

/// A session on the mesh that it was simulated on, and as it was predicted.
struct SheetComparison {
  Session measured;
  Session predicted;        ///< frames that have an equilibrium
  std::vector<int> frames;  ///< which of the measured ones those are, in order

  /// Frames without equilibrium, which are not compared.
  std::vector<int> missing_frames() const;
};

/// How an experiment's measured quantity compares with its prediction.
struct ExperimentResult {
  std::string name, type, direction, component;
  ExperimentRole role = ExperimentRole::fit;
  MeasuredQuantity quantity;
  double rms = 0;                         ///< SI, over the used rows
  double rms_percent = 0;                 ///< of the peak (of the range of lengths, of the strip's
                                          ///< length for distances)
  std::optional<double> r_squared;        ///< share of the variance that is predicted; of solids
  bool unloads = false;                   ///< by enough to show friction
  std::optional<double> elastic_rms;      ///< SI, of the best purely elastic curve
  std::optional<double> elastic_percent;  ///< the same in per cent
  std::optional<double> limp_rms;         ///< SI, of a material without any stiffness
  std::optional<double> limp_percent;     ///< the same in per cent
  double peak_force = 0;                  ///< N, or N/m for forces per width
  int points = 0;
  int excluded = 0;
  std::vector<std::string> specimens;
  double noise = 0;  ///< standard deviation used as weight, SI
  std::string noise_source;
  std::optional<double> stated_noise;  ///< of the measured quantity, SI
  double effective_rows = 0;           ///< rows whose residuals go together count as one
  std::vector<Outlier> outliers;       ///< rows that the fit leaves by far
  std::optional<double> noise_floor;   ///< what neighbouring rows scatter by, whatever the law, SI;
                                       ///< absent for too few rows in a run, and for profiles
  std::pair<double, double> strain_range;
  std::optional<LoopMetrics> measured_loop, predicted_loop;
  std::vector<LoopFigure> measured_figures, predicted_figures;  ///< of standards
  std::optional<StripShapes> shapes;     ///< of strips whose profiles are measured
  std::optional<SheetComparison> sheet;  ///< of full-field sessions
  std::optional<FoldError> folds;        ///< of the same
  std::vector<std::string> handled;

  // Row by row, for predictions/NAME.csv.
  std::vector<OwnColumn> columns;
  std::vector<double> time, strain;
  std::vector<int> direction_of_row, specimen_of_row;
  std::vector<char> used;
  Eigen::VectorXd measured, predicted;
  std::optional<Eigen::VectorXd> elastic;
  std::optional<Eigen::VectorXd> half_band = {};  ///< of the 95 % band of what was predicted
};

/// A stress-strain curve of a fitted component: from rest to the largest strain and back to zero.
struct ComponentCurve {
  std::string component;
  std::vector<double> strain, load, unload, low, high, elastic, max_friction;
};

struct FitStage {
  std::string component, name, unit;
  double rms = 0;
  bool accepted = true;
  std::string ended = {};  ///< of the last step of a growth: why it ended (`name_of(GrowthEnd)`)
};

/// One friction model of a comparison ([T] Fig. 5.3).
struct ModelRank {
  std::string component, name;
  int parameters = 0;
  double rms_percent = 0;
  double aic = 0, bic = 0, delta_bic = 0;
  std::string told_by = {};  ///< the test that would tell it from others; empty: none is known
};

/// Profile likelihood of one parameter: all others fitted again at each value.
struct Profile {
  std::string parameter, unit;
  std::vector<double> value, delta_chi2;
  std::optional<double> lower,
      upper;  ///< where delta_chi2 passes 3.84; absent: not within the range
  std::optional<double> std_error;
};

/// An experiment that a material cannot predict.
struct SkippedExperiment {
  std::string name;
  std::vector<std::string> missing;  ///< components that the material does not have
};

/// Numbers of an experiment that a fit would have found, and nothing tells: it is predicted as on
/// an ideal apparatus.
struct LeftOut {
  std::string experiment;
  std::vector<std::string> numbers;  ///< in words: force offset
};

/// A file, or the folder of a session, that an experiment was read from.
struct DataFile {
  std::string experiment;
  std::string file;    ///< as seen from the study
  std::string sha256;  ///< of a folder that of all its files
};

/// Everything that a fit or an evaluation found out; the content of fit.json and its neighbours.
struct StudyResult {
  std::string name;
  double density = 0;
  std::map<std::string, std::string> info, conditions;
  EstimatorKind estimator = EstimatorKind::path;
  bool converged = true;
  double seconds = 0;
  std::vector<ParameterEstimate> parameters, nuisance;
  Eigen::MatrixXd covariance;  ///< parameters, then nuisance
  std::map<std::string, Eigen::VectorXd> singular_values;
  std::vector<DataFile> data;
  std::vector<ExperimentResult> experiments;
  std::vector<WholeSheetResult> whole_sheets;  ///< of an evaluation
  std::vector<ComponentCurve> curves;
  std::vector<LabFigure> figures;  ///< of the material's components, in the order of their names
  std::optional<EquilibriumWork> work;  ///< of sheets: fits, their predictions and uncertainty
  std::vector<FitStage> stages;
  std::vector<StartRecord> starts;
  std::vector<ModelRank> models;
  std::vector<Profile> profiles;
  std::vector<std::string> assumptions, undetermined, warnings;
  std::vector<std::string> questions;  ///< warnings that doubt units, sizes or the fabric
  std::vector<SkippedExperiment> skipped;
  std::vector<LeftOut> left_out;  ///< of an evaluation
  Judgement judgement;
  Material material;
  std::optional<VtuGrid> body = {};  ///< of a heterogeneous material, at rest
};

/// Adds a record of starts, and to the assumptions where one of them stands alone.
void add_starts(StartRecord starts, StudyResult& result);

}  // namespace pliant
