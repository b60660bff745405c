#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/experiment/experiment.h"
#include "pliant/experiment/sheet/cord_friction.h"
#include "pliant/experiment/sheet/sheet_objective.h"
#include "pliant/io/csv.h"
#include "pliant/material/material.h"

namespace pliant {

/// Where an experiment's rows come from: one file, or a pattern with one specimen a file.
struct DataSource {
  std::vector<std::filesystem::path> files;  ///< sorted by name
  std::string written;                       ///< as the study says it
  CsvOptions csv;
  Location where;
};

/// Rows left out of a fit, numbered from 1 within the experiment's data.
struct ExcludedRows {
  int first = 0;
  int last = 0;
  std::string reason;
};

/// Stated standard deviations of the instrument's noise; absent: estimated from the residuals.
struct StatedNoise {
  std::optional<double> force;  ///< N; N/m in shear-cycles; in pure-bending of the moment per width
  std::optional<double> length;  ///< m; of positions in cantilever and rolled-strip, of overhangs
                                 ///< in bending-length
};

enum class InitialFriction {
  rest,     ///< a fresh specimen: no friction stress at the first row
  unknown,  ///< estimated as a nuisance parameter
};

/// Whether the stated gauge length is the strip's length free of force.
enum class RestLength {
  known,
  unknown,  ///< estimated as a nuisance parameter (default where a pretension is stated)
};

/// Which way a strip buckles between clamps that come nearer: as gravity pulls, or against it.
enum class BucklingSide { down, up };

/// One experiment as a study describes it (docs/formats.md), SI units.
struct ExperimentSpec {
  std::string name;
  std::string type;
  std::string direction;  ///< warp, weft, bias; of an oblique strip its angle as the study writes
                          ///< it; empty where the type has none
  std::optional<double> oblique_angle;  ///< rad from weft, of a strip cut otherwise than along
                                        ///< weft, warp or bias
  std::string standard;
  DataSource data;
  double length = 0;  ///< gauge length; rolled-strip, buckling-bend: of the strip
  double width = 0;
  double clip_mass = 0;
  double pretension = 0;          ///< N, at which the gauge length was set
  double apparatus_friction = 0;  ///< N, stated friction of the instrument
  double transverse_tension = 0;  ///< N/m, shear-cycles
  double angle = 0;               ///< rad, bending-length: of the plane that the tip touches
  int precondition_cycles = 0;
  bool rested = false;
  InitialFriction initial_friction = InitialFriction::rest;
  RestLength rest_length = RestLength::known;
  bool density_is_known = true;             ///< cantilever: else it is estimated along
  BucklingSide side = BucklingSide::down;   ///< buckling-bend
  std::optional<SheetObjective> objective;  ///< session; absent: what is usual for its test
  CordFriction cord_friction;               ///< session
  StatedNoise noise;
  std::vector<ExcludedRows> excluded;
  ExperimentRole role = ExperimentRole::fit;
  std::map<std::string, std::string> other_fields;  ///< of types that this version does not use
  Location where;
};

enum class FrictionChoice { automatic, dahl, none };

struct ComponentModel {
  std::optional<CurveKind> stiffness;
  std::optional<FrictionChoice> friction;
};

struct ModelOptions {
  MembraneMeasure membrane = MembraneMeasure::stvk;
  std::string bending = "discrete-shells";
  bool isotropic = false;           ///< weft and warp share their curves; fits of sheets
  std::optional<double> mesh_edge;  ///< m, of the grid that sheets are simulated on; absent: 24
                                    ///< cells on the longer side
  bool measured_mesh = false;       ///< sheets are simulated on the meshes of their sessions
  bool strips_as_sheets = false;    ///< tensile-cycles are fitted as sheets, else in one dimension
  std::optional<CurveKind> stiffness;  ///< absent: affine for hanging weights, else hermite
  FrictionChoice friction = FrictionChoice::automatic;
  std::map<std::string, ComponentModel> components;
};

/// Whether a model has springs, which lie along weft and warp.
inline bool needs_grid(const ModelOptions& model) {
  return model.membrane == MembraneMeasure::spring || model.bending == "spring";
}

enum class EstimatorKind {
  path,    ///< stress carried along the path, exact solution of [T] Eq. 5.2
  anchor,  ///< the published estimator ([T] Eqs. 5.4-5.6)
};

struct GaussianPrior {
  double mean = 0;
  double sd = 0;
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

/// Experiment types that this version fits and predicts.
bool is_supported_type(std::string_view type);

/// Types whose data is the full field of a sheet: session.
bool measures_sheets(std::string_view type);

/// Whether an experiment is fitted and predicted as a sheet: a session, or a strip where the model
/// asks for it.
bool is_sheet(const ExperimentSpec& spec, const ModelOptions& model);

/// `down` or `up`.
std::string_view name_of(BucklingSide side);

/// Types whose rows are points of strips' profiles: cantilever, rolled-strip.
bool measures_profiles(std::string_view type);

/// Types in which a strip sticks out and bends once from flat: cantilever, bending-length.
bool overhangs(std::string_view type);

/// Types in which its own weight alone bends a strip, from flat: those and bending-length.
bool bends_by_weight(std::string_view type);

/// Types in which the cloth's own weight bends it along, so that they need its mass per area.
bool needs_density(std::string_view type);

/// Strain component that a test of a type and direction determines, e.g. stretch.warp. What bends
/// along the bias is bend.diagonal; oblique strips are sheets that tell shear.
std::string component_of_test(std::string_view type, const std::string& direction);

/// Reads a study/1 file.
/// @throws InputError that names file, line and field
Study read_study(const std::filesystem::path& path);

/// The study with every default filled in, as a study/1 text that `read_study` reads back.
/// @param directory  the folder that the text will be stored in; data files are named relative to
/// it
std::string resolved_study_text(const Study& study, const std::filesystem::path& directory);

/// Whether `name` matches `pattern`, in which `*` stands for any text.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace pliant
