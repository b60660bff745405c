#include "pliant/exchange/keyword_file.h"

#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/volume_regions.h"

namespace pliant {
namespace {

constexpr std::size_t kNumbersPerLine = 16, kLongestComment = 250;
constexpr const char* kAllNodes = "NALL";
constexpr const char* kAllElements = "EALL";

std::string comment(const std::string& text) {
  return "** " + one_line(text, kLongestComment) + "\n";
}

/// Names of sets of one kind, of which no two are alike.
class SetNames {
 public:
  explicit SetNames(const std::string& taken) : taken_{taken} {}

  std::string operator()(const std::string& text) {
    const std::string name = keyword_name(text);
    std::string free = name;
    for (int n = 2; !taken_.insert(free).second; ++n) free = fmt::format("{}_{}", name, n);
    return free;
  }

 private:
  std::set<std::string> taken_;
};

/// The nodes or elements of a set, numbered from 0.
std::string set_text(const std::string& head, const std::vector<int>& members) {
  std::string text = head + "\n";
  for (std::size_t i = 0; i < members.size(); ++i) {
    const bool ends = i + 1 == members.size() || (i + 1) % kNumbersPerLine == 0;
    text += fmt::format("{}{}", members[i] + 1, ends ? "\n" : ", ");
  }
  return text;
}

template <class Elements>
std::string elements_text(const Elements& elements, const std::string& type, int first) {
  if (elements.cols() == 0) return "";
  std::string text = fmt::format("*ELEMENT, TYPE={}, ELSET={}\n", type, kAllElements);
  for (Eigen::Index e = 0; e < elements.cols(); ++e) {
    text += std::to_string(first + static_cast<int>(e) + 1);
    for (const int node : elements.col(e)) text += fmt::format(", {}", node + 1);
    text += "\n";
  }
  return text;
}

std::string regions_text(const VolumeMesh& mesh) {
  const std::map<int, std::vector<int>> regions = elements_of_regions(mesh);
  if (regions.size() < 2 && mesh.region_names.empty()) return "";
  std::string text;
  SetNames name(kAllElements);
  for (const auto& [label, elements] : regions) {
    const auto named = mesh.region_names.find(label);
    const std::string told =
        named == mesh.region_names.end() ? fmt::format("REGION_{}", label) : named->second;
    text += set_text("*ELSET, ELSET=" + name(told), elements);
  }
  return text;
}

std::string mesh_text(const VolumeMesh& mesh, bool hybrid) {
  std::string text = fmt::format("*NODE, NSET={}\n", kAllNodes);
  for (int i = 0; i < mesh.node_count(); ++i) {
    const auto p = mesh.positions.col(i);
    text += fmt::format("{}, {}, {}, {}\n", i + 1, keyword_number(p.x()), keyword_number(p.y()),
                        keyword_number(p.z()));
  }
  const std::string kind = hybrid ? "H" : "";
  text += elements_text(mesh.tetrahedra, "C3D4" + kind, 0);
  text += elements_text(mesh.hexahedra, "C3D8" + kind, mesh.tetrahedron_count());
  text += regions_text(mesh);
  SetNames name(kAllNodes);
  for (const auto& [group, nodes] : mesh.groups) {
    text += set_text("*NSET, NSET=" + name(group), nodes);
  }
  return text;
}

/// What tells elements from ours whose component J has one volume an element or node.
std::vector<std::string> lost_with_elements(const SolidToConvert& solid, KeywordTool tool) {
  if (!solid.material.components.contains("J") ||
      solid.law.volume.form == VolumeEnergy::Form::none) {
    return {};
  }
  std::vector<std::string> lost;
  if (tool == KeywordTool::calculix && solid.mesh->hexahedron_count() > 0) {
    lost.emplace_back(
        "one volume a hexahedron: C3D8 of CalculiX has one at each of its points, and is too stiff "
        "where the volume hardly changes");
  }
  if (solid.mesh->tetrahedron_count() > 0) {
    lost.emplace_back(
        "one volume a node of tetrahedra: C3D4 has one an element, and is too stiff where the "
        "volume hardly changes");
  }
  return lost;
}

void append(const std::vector<std::string>& from, std::vector<std::string>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

ConvertedSolid keyword_file(const SolidToConvert& solid, KeywordTool tool) {
  const ConvertedSolid material = keyword_material(solid, tool);
  ConvertedSolid file;
  append(solid.law.lost, file.lost);
  append(material.lost, file.lost);
  if (solid.mesh) append(lost_with_elements(solid, tool), file.lost);

  file.text = comment(fmt::format("{}: {} for {}, written by pliant convert in SI units",
                                  solid.material.name, name_of(solid.law), name_of(tool)));
  for (const std::string& lost : file.lost) file.text += comment("lost: " + lost);
  const bool hybrid = tool == KeywordTool::abaqus &&
                      solid.law.volume.form == VolumeEnergy::Form::none &&
                      !std::holds_alternative<StvkLaw>(solid.law.shape);
  if (solid.mesh) {
    file.text += "*HEADING\n" + keyword_name(solid.material.name) + "\n";
    file.text += mesh_text(*solid.mesh, hybrid);
  }
  file.text += material.text;
  if (!solid.mesh) return file;
  file.text += fmt::format("*SOLID SECTION, ELSET={}, MATERIAL={}\n", kAllElements,
                           keyword_name(solid.material.name));
  file.text += comment("to be added: *BOUNDARY; *STEP, NLGEOM; *STATIC; loads; *END STEP");
  return file;
}

}  // namespace pliant
