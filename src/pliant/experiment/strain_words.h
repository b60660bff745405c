#pragma once

#include <string>
#include <string_view>

#include "pliant/material/material.h"

namespace pliant {

/// Where a strain of a component lies, as a tester would say it: "19 % extension (Green strain
/// 20.8 %)", "curvature 250 1/m", "shear strain 13.9 %".
/// @param strain  in the component's own measure: of bending three times the curvature (1/m)
std::string strain_in_words(std::string_view component, double strain, MembraneMeasure measure);

}  // namespace pliant
