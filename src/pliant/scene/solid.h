#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pliant/geometry/volume_source.h"
#include "pliant/scene/cloth.h"

namespace pliant {

/// A region of a solid's mesh file that is of another material than the rest.
struct SolidRegion {
  SceneMaterial material;
  std::string label;  ///< name or number that the file has for the region
  Location where;
};

/// A place of a solid where its material is known, in the coordinates of its mesh.
struct SceneSample {
  Eigen::Vector3d at;  ///< m
  SceneMaterial material;
  Location where;
};

/// A solid body of a scene/1 file. Its own coordinates are those of its mesh, in metres; from there
/// it is placed in the world, undeformed.
struct SceneSolid {
  std::string name;
  VolumeSource mesh;
  SceneMaterial material;            ///< of a heterogeneous solid that of its first sample
  std::vector<SceneSample> samples;  ///< of a heterogeneous solid
  std::optional<double> width;       ///< of the samples' weights (m); absent: their spacing
  std::vector<SolidRegion> regions;
  Pose place;
  std::optional<Eigen::Vector3d> velocity;  ///< at the start, m/s; at rest when absent
  Location where;
};

/// Reads an element of the list `solids`, with its materials; the mesh is not read.
/// @param taken  names of the cloths and solids so far; gets the new one
/// @throws InputError, also for a material of cloth
SceneSolid read_scene_solid(const Value& value, std::set<std::string>& taken);

/// The material of each element: 0 for the solid's own, 1 + r for that of region r.
/// @throws InputError for a label that the mesh does not have, or one that is there twice
std::vector<int> material_of_elements(const SceneSolid& solid, const VolumeMesh& mesh);

}  // namespace pliant
