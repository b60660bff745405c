#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pliant/io/mesh_data.h"
#include "pliant/scene/simulation.h"

namespace pliant {

/// A file by its name relative to the folder of results, and its bytes.
using NamedFile = std::pair<std::string, std::string>;

/// The files of the present step as frame `index`, in the scene's formats: frames/NNNNNN.ply and
/// .vtu with the vertices of cloths and nodes of solids (m) and the fields that the scene asks for,
/// and where obstacles are led obstacles/NNNNNN.obj.
std::vector<NamedFile> frame_files(const Simulation& simulation, int index);

/// Files about all frames so far: energy.csv, clips.csv where there are clips, simulation.pvd for
/// ParaView.
std::vector<NamedFile> series_files(const Simulation& simulation);

/// The cloths as one OBJ mesh, with rest-plane coordinates (m) as texture coordinates; the PC2 file
/// moves its vertices.
std::string cloth_obj(const Simulation& simulation);
/// The elements of solids as they start (m), without fields; points are numbered as in frames.
std::string solids_vtu(const Simulation& simulation);
/// The obstacles as one OBJ mesh (m), where they are now.
std::string obstacles_obj(const Simulation& simulation);
/// The cloths' vertices, for a frame of the PC2 file.
std::vector<Point3> cloth_points(const Simulation& simulation);

/// Names of the fields that frames carry, and their units.
std::map<std::string, std::string> frame_fields(const Simulation& simulation);

}  // namespace pliant
