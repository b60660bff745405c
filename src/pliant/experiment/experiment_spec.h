#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/experiment/experiment_role.h"
#include "pliant/experiment/session/cord_friction.h"
#include "pliant/experiment/session/sheet_objective.h"
#include "pliant/measurement/data_source.h"

namespace pliant {

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

/// Experiment types that this version fits and predicts.
bool is_supported_type(std::string_view type);

/// Types whose data is the full field of a sheet: session.
bool measures_sheets(std::string_view type);

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

}  // namespace pliant
