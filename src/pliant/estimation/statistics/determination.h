#pragma once

#include "pliant/material/number_error.h"

namespace pliant {

/// The grade of a parameter: the half width of its 95 % interval over its size. The size is its
/// value; a value below a tenth of its scale in the data is judged by that tenth. Half widths up to
/// 0.1 and 0.3 of the size give the first two grades, up to 1 (the interval leaves out zero)
/// `weak`, more or none at all `none`.
///
/// @param value       of the parameter
/// @param half_width  of its 95 % interval, in the same unit; NaN: unseen, fixed or at its bound
/// @param scale       value that would matter in the data, > 0, in the same unit
Determination determination_of(double value, double half_width, double scale);

}  // namespace pliant
