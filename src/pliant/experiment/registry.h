#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/experiment/test_type.h"

namespace pliant {

/// All types of tests, in the order in which they are listed to users.
std::span<const TestType* const> test_types();

/// @return null for a name that is no type's
const TestType* find_test_type(std::string_view name);

/// What is known of a type; of an unknown name nothing.
const TestFacts& facts_of_test(std::string_view name);

/// Reads the name of a type.
/// @throws InputError that names the nearest one, or says that a type is not there yet
const TestType& read_test_type(const Value& value);

/// Strain component that a test of a type and direction determines, e.g. stretch.warp. What bends
/// along the bias is bend.diagonal; oblique strips are sheets that tell shear.
std::string component_of_test(const TestFacts& facts, const std::string& direction);
std::string component_of_test(std::string_view type, const std::string& direction);

}  // namespace pliant
