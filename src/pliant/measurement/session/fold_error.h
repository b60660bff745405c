#pragma once

#include "pliant/measurement/session.h"

namespace pliant {

/// How much the folds of two sequences of shapes differ, wherever exactly the folds are.
struct FoldError {
  double height = 0;  ///< of local RMS heights (m)
  double slope = 0;   ///< of local RMS slopes (1)
};

/// Compares the folds of a sheet in two sessions on one rest mesh: an error that does not punish a
/// wrinkle for being shifted, which [T] 3.6 asks for.
///
/// Of each shape the quadratic surface of the rest coordinates that fits it best is taken off; what
/// is left along its normal is the height w of the folds. In windows all over the rest plane, a
/// Gaussian of an eighth of the longer side each, height and slope are sqrt<w^2> and
/// sqrt<|grad w|^2>: A / sqrt 2 and 2 pi A / (sqrt 2 wavelength) for a wrinkle of amplitude A that
/// is not much wider than a window, whatever its phase. The error is the root mean square
/// difference over windows and frames.
///
/// Equal shapes have no error, and neither have those that differ by a rigid motion. Heights see
/// amplitudes, slopes wavelengths as well; noise of the positions adds to the measured ones.
FoldError fold_error(const Session& measured, const Session& predicted);

}  // namespace pliant
