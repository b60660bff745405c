#pragma once

#include <optional>
#include <string>

#include "pliant/io/fields.h"

namespace pliant {

/// `unit` of the coordinates of a file, which has to be there: m per unit.
double read_file_unit(Fields& fields);

/// `up`: the axis of a file that becomes the world's z.
std::optional<std::string> read_file_up(Fields& fields);

}  // namespace pliant
