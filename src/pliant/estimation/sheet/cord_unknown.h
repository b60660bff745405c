#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/sheet/sheet_unknown.h"
#include "pliant/experiment/session/sheet_test.h"

namespace pliant {

/// Widths of the loops of cords (N), by the names of their parameters.
using CordFrictions = std::map<std::string, double>;

/// The loops of a test's cords, EXPERIMENT.CLIP.CORD.cord_friction, where they are unknown. They
/// are not negative; without a word of the study their prior is 0 +- 0.1 N ([T] 3.2.3).
std::vector<SheetUnknown> cord_unknowns(const SheetTest& test);

/// The width of the loop of each cord of a test (N): as it was found, else as it is stated; 0 where
/// it is unknown and was not found.
Eigen::VectorXd cord_widths(const SheetTest& test, const CordFrictions& found);

}  // namespace pliant
