#pragma once

#include <string>
#include <vector>

namespace pliant {

/// What to say of readings that stop at their largest, as of a cell at its limit or one that is not
/// connected: they are the same there in row after row, and hardly anywhere else. Else nothing.
/// @param readings  N
std::string limit_doubt(const std::vector<double>& readings);

/// What to say of a log whose extension does not go with the way of the clip that it is of, by a
/// straight line: rows beside wrong pictures. Else nothing.
/// @param extension, way  of each frame, NaN where they are not known (m)
std::string extension_doubt(const std::vector<double>& extension, const std::vector<double>& way);

}  // namespace pliant
