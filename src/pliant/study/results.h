#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/estimation/fit_result.h"
#include "pliant/study/result_files.h"

namespace pliant {

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

/// Noise by which rows were weighted; numbers in `unit`.
struct ResultNoise {
  std::string quantity, unit, source;
  double value = 0;
  std::optional<double> floor;  ///< what neighbouring rows scatter by
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
  std::optional<ResultNoise> noise;
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

/// fit.json or evaluation.json of a results directory.
struct Results {
  bool evaluation = false;
  std::string name, estimator;
  RunFacts facts;
  std::vector<DataFile> data;
  std::optional<double> density;            ///< kg/m^2; of a solid kg/m^3
  std::optional<MembraneMeasure> membrane;  ///< absent in results of earlier versions
  std::vector<ResultFigure> figures;        ///< alike; in the order of the components' names
  std::optional<double> seconds;
  bool converged = true;
  std::map<std::string, std::string> info, conditions;
  std::vector<ResultParameter> parameters, nuisance;
  std::vector<std::vector<double>> covariance;  ///< parameters, then nuisance; NaN = unknown
  std::map<std::string, std::vector<double>> singular_values;  ///< by component
  std::vector<ResultExperiment> experiments;
  std::vector<ResultWholeSheet> whole_sheets;
  std::optional<EquilibriumWork> work;
  std::vector<FitStage> stages;
  std::vector<StartRecord> starts;
  std::vector<ModelRank> models;
  std::vector<Profile> profiles;
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
};

/// Reads `directory`/fit.json, or evaluation.json where there is no fit.json.
/// @throws InputError where neither exists, the JSON is broken, or a field is not what it must be
Results read_results(const std::filesystem::path& directory);

}  // namespace pliant
