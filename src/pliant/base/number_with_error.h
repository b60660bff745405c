#pragma once

#include <string>

namespace pliant {

/// "3640 +- 170": a value and its standard error, rounded to the error's two digits, without powers
/// of ten.
/// @param error  finite and above zero
std::string number_with_error(double value, double error);

}  // namespace pliant
