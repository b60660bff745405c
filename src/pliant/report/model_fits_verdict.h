#pragma once

#include <string>

#include "pliant/report/model_fits.h"

namespace pliant::report {

/// Misfits within this factor of each other are not told apart.
inline constexpr double kAlike = 1.05;

/// What the table of several fits shows, in a few sentences: which is the best, what curves and
/// directions of their own are worth, whether a variant is worse than one that it contains, and
/// which fits predict best.
std::string model_fits_verdict(const ModelFits& fits);

}  // namespace pliant::report
