#pragma once

#include <string>
#include <vector>

#include "pliant/experiment/model_options.h"
#include "pliant/experiment/session/sheet_test.h"

namespace pliant {

/// The specimens of a tensile test as sheets.
struct StripSheets {
  std::vector<SheetTest> tests;      ///< one a specimen
  std::vector<std::string> handled;  ///< what was found in the data and how it was dealt with
  std::vector<std::string> warnings, questions;
};

/// Load-unload cycles of strips as sequences of a sheet: a rectangle of gauge length and width,
/// clamped along both ends and pulled lengthways without gravity. A warp strip lies along v, a weft
/// strip along u, a bias strip at 45 degrees to both, an oblique one at its angle from u towards v.
/// Compared is the force of the moving clip.
///
/// The rows are thinned: to where the clamps have gone on by a fixed part of their whole way, and
/// the last one before each turn. The force offset is what the slack strip reads, as in predictions
/// of `TensileCycles`. A flat sheet would push where a strip goes slack: while the measured force
/// is zero its clips stay where unloading has left it.
///
/// Rows that are not fitted (conditioning, exclusions) are followed and not compared.
/// @param spec          tensile-cycles of any direction
/// @param area_density  kg/m^2, 0 where none is stated; nothing depends on it
/// @throws InputError as `TensileCycles` does, and for springs, which no bias strip has along it
StripSheets sheets_of_strips(const ExperimentSpec& spec, const DataRows& data,
                             const ModelOptions& model, double area_density);

}  // namespace pliant
