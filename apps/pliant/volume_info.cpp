#include "apps/pliant/volume_info.h"

#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/geometry/volume_file.h"

namespace pliant {
namespace {

std::string short_number(double value) { return format_number(value, kInfoDigits); }

std::string volume_source_text(const VolumeFileSource& source) { return source.file.string(); }

std::string volume_source_text(const SurfaceSource& source) {
  return fmt::format("tetrahedra in {}, edges of {}", source.file.string(),
                     format_quantity(source.edge, Dimension::length));
}

std::string volume_source_text(const LabelSource& source) {
  return fmt::format("tetrahedra in the regions of {}, edges of {}", source.file.string(),
                     format_quantity(source.edge, Dimension::length));
}

std::string volume_source_text(const BlockSource& block) {
  const auto length = [&](int axis) {
    return format_quantity(block.size(axis), Dimension::length);
  };
  return fmt::format("block {} x {} x {}, {} x {} x {} cells", length(0), length(1), length(2),
                     block.cells[0], block.cells[1], block.cells[2]);
}

std::string volume_source_text(const Fingertip& shape) {
  return fmt::format("fingertip {} x {} x {}, edges of {}",
                     format_quantity(shape.length, Dimension::length),
                     format_quantity(shape.width, Dimension::length),
                     format_quantity(shape.height, Dimension::length),
                     format_quantity(shape.edge, Dimension::length));
}

void add_counts(const VolumeMesh& mesh, FileInfo& info) {
  info.json["nodes"] = mesh.node_count();
  info.json["tetrahedra"] = mesh.tetrahedron_count();
  info.json["hexahedra"] = mesh.hexahedron_count();
  info.lines.push_back(labelled("nodes", std::to_string(mesh.node_count())));
  info.lines.push_back(
      labelled("elements", fmt::format("{} tetrahedra, {} hexahedra", mesh.tetrahedron_count(),
                                       mesh.hexahedron_count())));
}

void add_regions(const VolumeMesh& mesh, FileInfo& info) {
  std::map<int, int> counts;
  for (int e = 0; e < mesh.element_count(); ++e) ++counts[mesh.label_of(e)];
  info.json["regions"] = Json::array();
  std::vector<std::string> texts, groups;
  for (const auto& [label, count] : counts) {
    const auto named = mesh.region_names.find(label);
    const std::string name =
        named == mesh.region_names.end() ? std::to_string(label) : named->second;
    info.json["regions"].push_back({{"label", name}, {"elements", count}});
    texts.push_back(fmt::format("{} ({} elements)", name, count));
  }
  info.json["groups"] = Json::object();
  for (const auto& [name, nodes] : mesh.groups) {
    info.json["groups"][name] = nodes.size();
    groups.push_back(fmt::format("{} ({} nodes)", name, nodes.size()));
  }
  info.lines.push_back(labelled("regions", fmt::format("{}", fmt::join(texts, ", "))));
  if (!groups.empty()) {
    info.lines.push_back(labelled("groups", fmt::format("{}", fmt::join(groups, ", "))));
  }
}

void add_extents(const VolumeMesh& mesh, FileInfo& info) {
  const Eigen::Vector3d low = mesh.positions.rowwise().minCoeff();
  const Eigen::Vector3d high = mesh.positions.rowwise().maxCoeff();
  info.json["unit"] = nullptr;
  info.json["min"] = low;
  info.json["max"] = high;
  info.lines.push_back(labelled("unit of length", "not told by the file; what follows is in it"));
  for (int axis = 0; axis < 3; ++axis) {
    info.lines.push_back(
        labelled(std::string(1, "xyz"[axis]),
                 fmt::format("{} to {}", short_number(low[axis]), short_number(high[axis])), 1));
  }
}

// Of a mesh without problems: others have none to speak of.
void add_quality(const VolumeMesh& mesh, FileInfo& info) {
  const VolumeQuality quality = volume_quality(mesh);
  const double volume = element_volumes(mesh).sum();
  const auto sides = boundary_surface(mesh).triangles.cols();
  info.json["volume"] = volume;
  info.json["surface_triangles"] = sides;
  info.json["edges"] = {{"shortest", quality.shortest_edge},
                        {"mean", quality.mean_edge},
                        {"longest", quality.longest_edge}};
  info.json["least_shape"] = quality.least_shape;
  info.json["mean_shape"] = quality.mean_shape;
  info.lines.push_back(labelled("volume", short_number(volume)));
  info.lines.push_back(labelled("surface", fmt::format("{} triangles", sides)));
  info.lines.push_back(labelled(
      "edges", fmt::format("{} to {}, mean {}", short_number(quality.shortest_edge),
                           short_number(quality.longest_edge), short_number(quality.mean_edge))));
  info.lines.push_back(
      labelled("shape", fmt::format("{:.2f} at least, mean {:.2f} (1 is regular, 0 flat)",
                                    quality.least_shape, quality.mean_shape)));
}

}  // namespace

FileInfo volume_info(const std::filesystem::path& path) {
  const VolumeFile file = read_volume_file(path, {.unit = 1});
  FileInfo info = begin_info(path, "volume mesh");
  add_counts(file.mesh, info);
  auto problems = find_volume_problems(file.mesh, file.numbering);
  if (file.mesh.node_count() > 0) add_extents(file.mesh, info);
  add_regions(file.mesh, info);
  if (problems.empty()) {
    add_quality(file.mesh, info);
    problems = find_slivers(file.mesh, file.numbering);
  }
  for (const MeshProblem& problem : problems) {
    const std::string line = problem.line > 0 ? fmt::format("line {}: ", problem.line) : "";
    info.warnings.push_back(fmt::format("{}{}; needed: {}", line, problem.text, problem.expected));
  }
  info.json["left_out"] = file.ignored;
  if (!file.ignored.empty()) {
    info.lines.push_back(labelled("left out", fmt::format("{}", fmt::join(file.ignored, ", "))));
  }
  info.json["warnings"] = info.warnings;
  return info;
}

std::string text_of(const VolumeSource& source) {
  return std::visit([](const auto& kind) { return volume_source_text(kind); }, source.kind);
}

}  // namespace pliant
