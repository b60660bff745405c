#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pliant {

/// The size at which readings stop, as of a cell at its limit or one that is not connected: they
/// are the same there in row after row, and hardly anywhere else. Else nothing.
/// @param readings  N
std::optional<double> limit_of(const std::vector<double>& readings);

/// What to say of such readings, or nothing.
std::string limit_doubt(const std::vector<double>& readings);

/// The same, NaN at their limit: what pulls is not known there.
std::vector<double> without_limit(std::vector<double> readings);

/// What to say of a log whose extension does not go with the way of the clip that it is of, by a
/// straight line: rows beside wrong pictures. Else nothing.
/// @param extension, way  of each frame, NaN where they are not known (m)
std::string extension_doubt(const std::vector<double>& extension, const std::vector<double>& way);

}  // namespace pliant
