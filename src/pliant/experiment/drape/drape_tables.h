#pragma once

#include <string>
#include <vector>

#include "pliant/experiment/drape/drape_setup.h"
#include "pliant/experiment/drape/draped_sheet.h"

namespace pliant {

/// Of the drape coefficients.
double mean_coefficient(const std::vector<DrapedSheet>& draped);

/// The rows of the test, one for each draping: what a study reads.
std::string drape_table(const std::vector<DrapedSheet>& draped);

/// The outlines of the silhouettes, one row for each angle.
std::string outline_table(const std::vector<DrapedSheet>& draped);

/// What the standard advises where the coefficients of a specimen of 30 cm lie outside of 30 % to
/// 85 %, in a sentence; nothing otherwise.
std::vector<std::string> size_advice(const std::vector<DrapedSheet>& draped,
                                     const DrapeSetup& setup);

}  // namespace pliant
