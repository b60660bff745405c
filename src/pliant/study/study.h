#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/experiment_spec.h"
#include "pliant/experiment/model_options.h"
#include "pliant/experiment/registry.h"

namespace pliant {

enum class EstimatorKind {
  path,    ///< stress carried along the path, exact solution of [T] Eq. 5.2
  anchor,  ///< the published estimator ([T] Eqs. 5.4-5.6)
};

/// One stage of an incremental fit of sheets.
struct PlanStage {
  std::vector<std::string> components;
  std::vector<std::string> experiments;  ///< names, or patterns with `*`
  Location where;
};

/// `fit:` of a study. Keys of the maps are parameter names or patterns with `*`.
struct FitOptions {
  EstimatorKind estimator = EstimatorKind::path;
  int control_points = 5;        ///< most control points of a hermite stiffness
  bool monotone_stress = false;  ///< elastic stress never falls where strain rises
  std::map<std::string, std::pair<double, double>> bounds;
  std::map<std::string, double> fix;
  std::map<std::string, GaussianPrior> priors;
  std::vector<PlanStage> plan;  ///< of sheets; empty: the thesis'
};

struct Study {
  std::string file;
  std::string name;
  double density = 0;  ///< kg/m^2; 0 = not stated
  std::map<std::string, std::string> info;
  std::map<std::string, std::string> conditions;
  std::vector<ExperimentSpec> experiments;
  ModelOptions model;
  FitOptions fit;
  std::vector<std::string> validate;
};

/// Reads a study/1 file.
/// @throws InputError that names file, line and field
Study read_study(const std::filesystem::path& path);

/// An experiment of a study, its data read.
/// @throws InputError for files that cannot be read and for unusable data; AssertionError for a
/// type that is not supported
std::unique_ptr<ComponentExperiment> read_experiment(const ExperimentSpec& spec,
                                                     const Study& study);

/// The study with every default filled in, as a study/1 text that `read_study` reads back.
/// @param directory  the folder that the text will be stored in; data files are named relative to
/// it
std::string resolved_study_text(const Study& study, const std::filesystem::path& directory);

}  // namespace pliant
