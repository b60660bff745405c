#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pliant/material/material.h"

namespace pliant::report {

/// One estimated number as fit.json states it; values in `unit`.
struct ResultParameter {
  std::string name;
  std::string component;
  std::string experiment;  ///< the experiment a nuisance parameter belongs to; empty otherwise
  std::string unit;
  std::string note;
  std::optional<double> value;
  std::optional<double> std_error;
  std::optional<double> lower, upper;  ///< 95 % interval
  std::optional<double> between_specimen_sd;
  bool identified = true;
  bool at_bound = false;
  bool fixed = false;
};

/// How numbers begin that belong to one sample of a heterogeneous material.
inline constexpr std::string_view kOfSample = "samples[";

/// What a load-unload loop says at a glance.
struct LoopMeasures {
  std::optional<double> secant_modulus;    ///< N/m, at the peak, engineering strain
  std::optional<double> secant_rigidity;   ///< N m, of moments: at the peak, over curvature
  std::optional<double> hysteresis_ratio;  ///< (Fmax - Fmin) / Favg, [T] 5.2.2
  std::optional<double> loop_loss;         ///< work lost in the loop over work of loading, 0..1
};

/// A figure of a standard (textile_figure.h) that a loop shows, in the laboratory's unit.
struct ResultLoopFigure {
  std::string name;
  std::optional<double> measured, predicted;
};

struct ResultExperiment {
  std::string name, type, direction, component;
  std::string quantity;  ///< what is measured and predicted, with its unit: `force_N`
  std::string prediction_file;
  std::string shape_file;    ///< of strips whose profiles are measured; empty otherwise
  std::string sheet_folder;  ///< of full-field sessions; empty otherwise
  bool validation = false;

  bool measures_sheets() const { return !sheet_folder.empty(); }
  bool measures_lengths() const { return quantity.starts_with("length"); }
  /// Rows of different kinds, each in units of its noise.
  bool measures_readings() const { return quantity == "reading"; }
  bool measures_overhangs() const { return quantity.starts_with("overhang"); }

  std::optional<double> rms_force, peak_force;  ///< N, or N/m for shear
  /// Of the peak force, of the range of the lengths where they are measured, or of the mean
  /// overhang.
  std::optional<double> rms_percent_of_peak, rms_elastic_percent_of_peak;
  std::optional<double> rms_position_mm, rms_elastic_position_mm;
  std::optional<double> rms_limp_percent_of_peak;  ///< of a material without any stiffness
  std::optional<double> rms_percent_of_length;     ///< of distances from a predicted profile
  std::optional<double> fold_height_error_mm;      ///< of sessions; absent in older results
  int points = 0, specimens = 0, excluded = 0;
  std::string noise;  ///< in words; empty where not stated
  std::optional<std::array<double, 2>> strain_range;
  bool unloads = false;  ///< by enough to show friction, without a loop too
  std::optional<LoopMeasures> measured_loop, predicted_loop;
  std::vector<ResultLoopFigure> figures;  ///< of standards, that its loop shows
  std::vector<std::size_t> outliers;      ///< rows, from 0, that the fit leaves by far
  std::vector<std::string> handled;
};

/// A test in which all of a material shows together; values in `unit`.
struct ResultWholeSheet {
  std::string name, type, unit;
  std::string picture_file;  ///< SVG; empty where there is none
  std::optional<double> measured_mean, predicted_mean, rms;
  int points = 0;
  std::vector<std::string> told, handled;
};

struct FitStage {
  std::string component, name, unit;
  std::optional<double> rms;
  bool accepted = true;
  std::string ended = {};  ///< why growth ended with it
};

struct MultiStart {
  std::string component, search, unit;
  int tried = 0, reached_best = 0;
  bool followed = true;      ///< else the starts were compared where they begin
  std::vector<double> ends;  ///< RMS where each start has led, in `unit`
};

struct RankedModel {
  std::string component, name;
  int parameters = 0;
  std::optional<double> rms_percent_of_peak, aic, bic, delta_bic;
  std::string told_by;  ///< the test that would tell it; empty where none is known
};

struct ProfileLikelihood {
  std::string parameter, unit;
  std::vector<double> value, delta_chi2;
  std::optional<double> lower, upper, std_error;
};

struct SingularValues {
  std::string component;
  std::vector<double> values;
};

/// What the equilibria of a fit of sheets have cost.
struct FitWork {
  int equilibria = 0, newton_iterations = 0, factorizations = 0, differentiated = 0;
  int by_differences = 0;  ///< equilibria with derivatives by forward differences
  double equilibrium_seconds = 0, derivative_seconds = 0, other_seconds = 0;
};

/// What the fit says of its own fitness for use; empty in results of earlier versions.
struct ResultJudgement {
  std::string fitness, headline, details;
  std::vector<std::string> undetermined;  ///< by the data, with reasons
  std::vector<std::string> misses;        ///< experiments that are not accepted, the worst first
  std::vector<std::string> criteria;      ///< each limit of the study, and whether it is kept
};

/// What a laboratory reads off the material; values in `unit` (SI).
struct ResultFigure {
  std::string component, name, unit;
  std::optional<double> value, at, std_error, lower, upper;
  bool beyond_range = false;

  /// Whether its 95 % interval leaves out zero.
  bool is_determined() const { return lower && upper && (*lower > 0 || *upper < 0); }
};

/// A file that was read, by its digest.
struct DataDigest {
  std::string experiment, file, sha256;
};

/// fit.json or evaluation.json of a results directory.
struct Results {
  bool evaluation = false;
  std::string name, material, command, created, version, estimator;
  std::vector<DataDigest> data;
  std::optional<double> density;            ///< kg/m^2; of a solid kg/m^3
  std::optional<MembraneMeasure> membrane;  ///< absent in results of earlier versions
  std::vector<ResultFigure> figures;        ///< alike; in the order of the components' names
  std::optional<double> seconds;
  bool converged = true;
  std::map<std::string, std::string> info, conditions;
  std::vector<ResultParameter> parameters, nuisance;
  std::vector<std::vector<double>> covariance;  ///< parameters, then nuisance; NaN = unknown
  std::vector<SingularValues> singular_values;
  std::vector<ResultExperiment> experiments;
  std::vector<ResultWholeSheet> whole_sheets;
  std::optional<FitWork> work;
  std::vector<FitStage> stages;
  std::vector<MultiStart> starts;
  std::vector<RankedModel> models;
  std::vector<ProfileLikelihood> profiles;
  std::vector<std::string> assumptions, warnings;
  std::vector<std::string> questions;  ///< the first of the warnings: they stay on page one
  std::vector<std::string> skipped;    ///< experiments that were not predicted, and why
  ResultJudgement judgement;

  bool has_figures(const std::string& component) const;
  /// Whether a solid was measured.
  bool is_of_solid() const;
  /// Whether the material differs from place to place.
  bool has_samples() const;
  /// Whether a component does.
  bool differs_in(const std::string& component) const;

  /// The warnings beside the questions: the first of them, which stand on page one, or the others,
  /// so that each comes once.
  std::vector<std::string> warnings_of(bool on_page_one) const;
};

/// Reads `directory`/fit.json, or evaluation.json where there is no fit.json.
/// @throws InputError where neither exists, the JSON is broken, or a field is not what it must be
Results read_results(const std::filesystem::path& directory);

}  // namespace pliant::report
