#pragma once

#include <string>
#include <vector>

#include "pliant/io/csv.h"

namespace pliant::report {

/// A column of numbers in which an empty cell, NaN here, stands for one that does not exist.
/// @throws InputError for any other cell that is not a number
std::vector<double> numbers_or_none(const CsvTable& table, const std::string& column);

}  // namespace pliant::report
