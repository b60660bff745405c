#pragma once

#include <string>

#include "pliant/estimation/fit_result.h"

namespace pliant {

/// The body of a fit of a heterogeneous solid as a VTK file: for each number that samples differ in
/// its value in each element (Pa), and its standard error; NaN where that is not known, as some
/// sample that counts there stands at its bound.
/// @param result  has a body
std::string body_map(const StudyResult& result);

}  // namespace pliant
