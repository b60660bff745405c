#pragma once

#include <string>

#include "pliant/report/results.h"

namespace pliant::report {

/// The material at a glance, in a laboratory's units: of each component stiffness, friction and the
/// figures that its tests are known for, with their standard errors, and the range of the data.
std::string material_table(const Results& results);

}  // namespace pliant::report
