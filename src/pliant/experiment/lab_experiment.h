#pragma once

#include <string>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/experiment/experiment_spec.h"
#include "pliant/experiment/session/virtual/options.h"
#include "pliant/experiment/virtual_instrument.h"

namespace pliant {

/// A virtual experiment of a lab/1 file.
struct LabExperiment {
  std::string name, type, direction;
  double length = 0.1, width = 0.1;
  double clip_mass = 0;
  Instrument instrument;
  std::vector<double> peaks;     ///< hanging-weights: N; tensile-cycles: engineering strain;
                                 ///< shear-cycles: rad; pure-bending: 1/m; buckling-bend:
                                 ///< approach of the clamps as a share of the length
  double step = 1;               ///< hanging-weights: N between weights
  int repeats = 1;               ///< of the whole sequence
  int samples = 100;             ///< rows of a half cycle of the largest amplitude
  std::vector<double> settings;  ///< m; cantilever: overhangs; rolled-strip: radii of the
                                 ///< cylinders, negative where they turn the strip right
  int points = 25;               ///< of a profile
  double slack = 0;  ///< m, tensile-cycles, buckling-bend: clamps start nearer than the gauge
                     ///< length by this much
  double transverse_tension = 0;
  double angle = 0;  ///< rad, bending-length
  // buckling-bend
  BucklingSide side = BucklingSide::down;
  double strip_length = 0;  ///< m, what the strip has in truth between its clamps
  double force_offset = 0;  ///< N
  double force_drift = 0;   ///< N, of the force's zero from the first row to the last
  VirtualSession session;   ///< of the type session, which has a name and nothing else of the above
  Location where;
};

}  // namespace pliant
