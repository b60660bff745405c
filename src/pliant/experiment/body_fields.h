#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "pliant/experiment/test_spec.h"
#include "pliant/geometry/volume_mesh.h"
#include "pliant/io/fields.h"

namespace pliant {

/// The file of a body's mesh as a study names it.
struct BodyFile {
  std::filesystem::path path;
  std::string unit, up;  ///< as they are written
};

/// Reads `mesh`, `unit` and `up`, and the mesh.
/// @throws InputError
VolumeMesh read_body_mesh(Fields& fields, BodyFile& file);
WrittenFields written(const BodyFile& file);

/// The outward direction of a side of a body: -x, +x, -y, +y, -z, +z.
std::optional<Eigen::Vector3d> side_named(std::string_view name);

/// Nodes of a group or a region of a mesh, by name, or of a side of the body; rising.
/// @throws InputError
std::vector<int> read_body_nodes(const Value& value, const VolumeMesh& mesh);

/// `[x, y, z]`, as studies write it.
std::string vector_text(const Eigen::Vector3d& vector);

}  // namespace pliant
