#include "pliant/geometry/volume_regions.h"

namespace pliant {

std::map<int, std::vector<int>> elements_of_regions(const VolumeMesh& mesh) {
  std::map<int, std::vector<int>> regions;
  for (int e = 0; e < mesh.element_count(); ++e) regions[mesh.label_of(e)].push_back(e);
  return regions;
}

std::string name_of_region(const VolumeMesh& mesh, int label) {
  const auto named = mesh.region_names.find(label);
  return named == mesh.region_names.end() ? std::to_string(label) : named->second;
}

}  // namespace pliant
