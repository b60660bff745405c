#include "pliant/geometry/volume_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "pliant/base/errors.h"
#include "pliant/geometry/world_positions.h"
#include "pliant/io/gmsh.h"
#include "pliant/io/medit.h"
#include "pliant/io/vtu_volume.h"

namespace pliant {
namespace {

constexpr const char* kEndings = ".msh (gmsh), .mesh (Medit) or .vtu (VTK)";

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

template <std::size_t Corners>
auto columns(const VolumeData::Elements<Corners>& elements) {
  Eigen::Matrix<int, static_cast<int>(Corners), Eigen::Dynamic> result(
      static_cast<int>(Corners), std::ssize(elements.corners));
  for (size_t e = 0; e < elements.corners.size(); ++e) {
    for (size_t i = 0; i < Corners; ++i) {
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(e)) = elements.corners[e][i];
    }
  }
  return result;
}

void append(const std::vector<int>& from, std::vector<int>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

VolumeMesh mesh_of(const VolumeData& data) {
  VolumeMesh mesh;
  mesh.positions.resize(3, std::ssize(data.points));
  for (size_t i = 0; i < data.points.size(); ++i) {
    const auto& [x, y, z] = data.points[i];
    mesh.positions.col(static_cast<Eigen::Index>(i)) << x, y, z;
  }
  mesh.tetrahedra = columns(data.tetrahedra);
  mesh.hexahedra = columns(data.hexahedra);
  append(data.tetrahedra.labels, mesh.labels);
  append(data.hexahedra.labels, mesh.labels);
  mesh.region_names = data.region_names;
  mesh.groups = data.groups;
  return mesh;
}

template <int Corners>
auto elements_of(const Eigen::Matrix<int, Corners, Eigen::Dynamic>& columns, const VolumeMesh& mesh,
                 int first) {
  VolumeData::Elements<static_cast<std::size_t>(Corners)> elements;
  for (Eigen::Index e = 0; e < columns.cols(); ++e) {
    std::array<int, static_cast<std::size_t>(Corners)> corners{};
    for (int i = 0; i < Corners; ++i) corners[static_cast<std::size_t>(i)] = columns(i, e);
    elements.corners.push_back(corners);
    elements.labels.push_back(mesh.label_of(first + static_cast<int>(e)));
  }
  return elements;
}

VolumeData data_of(const VolumeMesh& mesh) {
  VolumeData data;
  for (const auto& p : mesh.positions.colwise()) data.points.push_back({p.x(), p.y(), p.z()});
  data.tetrahedra = elements_of(mesh.tetrahedra, mesh, 0);
  data.hexahedra = elements_of(mesh.hexahedra, mesh, mesh.tetrahedron_count());
  data.region_names = mesh.region_names;
  data.groups = mesh.groups;
  return data;
}

/// @param path  of a file that is a volume mesh by its ending
VolumeData read_data(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (ending == ".msh") return read_gmsh(path);
  return ending == ".mesh" ? read_medit(path) : read_vtu_volume(path);
}

}  // namespace

bool is_volume_file(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  return ending == ".msh" || ending == ".mesh" || ending == ".vtu";
}

VolumeFile read_volume_file(const std::filesystem::path& path, const VolumeFileOptions& options) {
  const std::string file = path.string();
  if (!is_volume_file(path)) {
    throw InputError({file}, "is no volume mesh by its ending", kEndings);
  }
  if (!(std::isfinite(options.unit) && options.unit > 0)) {
    throw InputError({file, 0, "unit"}, "the length unit of the file is not given",
                     "metres per unit, above 0");
  }
  const VolumeData data = read_data(path);
  VolumeFile read{mesh_of(data), {.file = file, .first = 1}, data.ignored};
  read.mesh.positions = world_positions(read.mesh.positions, options.unit, options.up, file);
  append(data.tetrahedra.lines, read.numbering.element_lines);
  append(data.hexahedra.lines, read.numbering.element_lines);
  return read;
}

VolumeMesh read_volume_mesh(const std::filesystem::path& path, const VolumeFileOptions& options) {
  VolumeFile read = read_volume_file(path, options);
  require_good_volume_mesh(read.mesh, read.numbering);
  return std::move(read.mesh);
}

std::string volume_file_text(const VolumeMesh& mesh, const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (ending == ".msh") return write_gmsh(data_of(mesh));
  if (ending == ".mesh") return write_medit(data_of(mesh));
  if (ending == ".vtu") return write_vtu_volume(data_of(mesh));
  throw InputError({path.string()}, "is no volume mesh by its ending", kEndings);
}

}  // namespace pliant
