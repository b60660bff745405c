#pragma once

#include <map>
#include <string>
#include <vector>

#include "pliant/geometry/volume_mesh.h"

namespace pliant {

/// The elements of each region, rising, by its label.
std::map<int, std::vector<int>> elements_of_regions(const VolumeMesh& mesh);

/// The name of a region, or its number where it has none.
std::string name_of_region(const VolumeMesh& mesh, int label);

}  // namespace pliant
