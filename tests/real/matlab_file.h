#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace pliant::test {

// As much of MATLAB's files of level 5 as measurements need: one compressed variable,
// little-endian, of structs and matrices of doubles. Other files end a test by std::runtime_error.

/// A value within a variable, its bytes as they are in the file.
using MatlabValue = std::string_view;
/// A struct, by the names of its fields.
using MatlabStruct = std::map<std::string, MatlabValue>;

/// The bytes of the first variable of a file, of which values are views.
std::string matlab_variable(const std::filesystem::path& file);
/// All of an array of structs.
std::vector<MatlabStruct> matlab_structs(MatlabValue value);
Eigen::MatrixXd matlab_matrix(MatlabValue value);

}  // namespace pliant::test
