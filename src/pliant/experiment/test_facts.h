#pragma once

#include <optional>
#include <string_view>

#include "pliant/math/scalar_curve.h"

namespace pliant {

/// What a test does to the cloth along its direction.
enum class Deformation {
  stretch,
  shear,
  bend,
  contraction,  ///< across a pull
};

/// What holds of all experiments of a type, for folders that know no test by its name.
struct TestFacts {
  std::optional<Deformation> deformation = {};  ///< none where each sheet tells its own
  bool measures_sheets = false;                 ///< data is the full field of a sheet, no table
  bool only_predicted = false;   ///< all of a material shows together: no fit learns from it, and a
                                 ///< prediction takes a whole material
  bool measures_solids = false;  ///< of a solid, whose components all show together
  bool may_be_sheet = false;     ///< its strips can be fitted as sheets, where the model asks
  bool measures_profiles = false;  ///< rows are points of strips' profiles
  bool overhangs = false;          ///< a strip sticks out and bends once from flat
  bool is_released = false;        ///< a strip is bent to a cylinder and let go
  bool bends_by_weight = false;    ///< its own weight alone bends a strip, from flat
  bool needs_density = false;      ///< the cloth's own weight bends it along
  bool follows_time = false;       ///< rows are followed in time, where a law flows with it
  bool has_unknown_zero = false;   ///< of the force: errors are shares of its span, and what the
                                   ///< material carries is not known without a fit

  /// Stiffness that experiments of this type alone are fitted with by default.
  CurveKind stiffness = CurveKind::hermite;
  /// A few readings of a published test of friction: with others that are sparse too the published
  /// stiffness k1 + k2 |strain| fits.
  bool is_sparse = false;

  // Words of results; empty where there is nothing to say.
  std::string_view assumption = {};    ///< taken for granted in a fit, after the experiment's name;
                                       ///< empty: that of what drives the path
  std::string_view unfitted = {};      ///< how the apparatus is taken in a prediction without a fit
  std::string_view undetermined = {};  ///< of a stiffness that this type alone determines
};

}  // namespace pliant
