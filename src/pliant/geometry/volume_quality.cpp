#include "pliant/geometry/volume_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/LU>
#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/hexahedron_shape.h"

namespace pliant {
namespace {

constexpr double kFlat = 1e-6;

constexpr int kTetrahedronEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
constexpr int kHexahedronEdges[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                         {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
// The nodes next to each corner of a hexahedron, in right-handed order.
constexpr int kCornerEdges[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                    {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
constexpr int kSides[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                              {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

std::vector<double> edge_lengths(const VolumeMesh& mesh, int element) {
  const std::vector<int> nodes = mesh.nodes_of(element);
  std::vector<double> lengths;
  const auto add = [&](const int(&edge)[2]) {
    lengths.push_back((mesh.positions.col(nodes[static_cast<size_t>(edge[1])]) -
                       mesh.positions.col(nodes[static_cast<size_t>(edge[0])]))
                          .norm());
  };
  if (nodes.size() == 4) {
    for (const auto& edge : kTetrahedronEdges) add(edge);
  } else {
    for (const auto& edge : kHexahedronEdges) add(edge);
  }
  return lengths;
}

// The volumes that stand for an element: its own, or of each point of a hexahedron times 8.
double least_volume(const VolumeMesh& mesh, int element) {
  const std::vector<int> nodes = mesh.nodes_of(element);
  if (nodes.size() == 8) return 8 * hexahedron_sizes(mesh.positions(Eigen::all, nodes)).minCoeff();
  const Eigen::Matrix<double, 3, 4> x = mesh.positions(Eigen::all, nodes);
  const Eigen::Matrix3d edges = x.rightCols<3>().colwise() - x.col(0);
  return edges.determinant() / 6;
}

std::vector<std::vector<int>> sides_of(const std::vector<int>& nodes) {
  std::vector<std::vector<int>> sides;
  if (nodes.size() == 4) {
    for (size_t i = 0; i < 4; ++i) {
      sides.push_back({nodes[i], nodes[(i + 1) % 4], nodes[(i + 2) % 4]});
    }
  } else {
    for (const auto& side : kSides) {
      std::vector<int> own;
      for (const int corner : side) own.push_back(nodes[static_cast<size_t>(corner)]);
      sides.push_back(own);
    }
  }
  for (auto& side : sides) std::ranges::sort(side);
  return sides;
}

/// What is said of an element, where its file has it.
MeshProblem element_problem(const VolumeMesh& mesh, const VolumeNumbering& numbering, int element,
                            const std::string& text, const std::string& expected) {
  const bool tetrahedron = element < mesh.tetrahedron_count();
  const int number = tetrahedron ? element : element - mesh.tetrahedron_count();
  const int line =
      numbering.element_lines.empty() ? 0 : numbering.element_lines[static_cast<size_t>(element)];
  return {fmt::format("{} {} {}", tetrahedron ? "tetrahedron" : "hexahedron",
                      numbering.first + number, text),
          expected, line};
}

/// Looks for what is wrong, one kind after the other.
class VolumeJudge {
 public:
  VolumeJudge(const VolumeMesh& mesh, const VolumeNumbering& numbering)
      : mesh_(mesh), numbering_(numbering) {}

  std::vector<MeshProblem> problems() && {
    if (mesh_.element_count() == 0) {
      problems_.push_back({"the mesh has no tetrahedra and no hexahedra", "a mesh of a volume"});
      return problems_;
    }
    check_numbers();
    if (!problems_.empty()) return problems_;
    check_finite();
    if (!problems_.empty()) return problems_;
    check_volumes();
    check_sides();
    check_use();
    return problems_;
  }

 private:
  void add(const std::string& text, const std::string& expected, int line = 0) {
    if (problems_.size() < kMaxMeshProblems) problems_.push_back({text, expected, line});
  }

  void add_element(int element, const std::string& text, const std::string& expected) {
    const MeshProblem problem = element_problem(mesh_, numbering_, element, text, expected);
    add(problem.text, problem.expected, problem.line);
  }

  void check_numbers() {
    for (int e = 0; e < mesh_.element_count(); ++e) {
      const std::vector<int> nodes = mesh_.nodes_of(e);
      const auto [low, high] = std::ranges::minmax(nodes);
      if (low < 0 || high >= mesh_.node_count()) {
        add_element(e, "has a node that is not there", fmt::format("{} nodes", mesh_.node_count()));
      } else if (std::set<int>(nodes.begin(), nodes.end()).size() < nodes.size()) {
        add_element(e, "has a node twice", "different nodes");
      }
    }
  }

  void check_finite() {
    for (int i = 0; i < mesh_.node_count(); ++i) {
      if (mesh_.positions.col(i).allFinite()) continue;
      add(fmt::format("the position of node {} is not finite", numbering_.first + i),
          "finite coordinates");
    }
  }

  void check_volumes() {
    for (int e = 0; e < mesh_.element_count(); ++e) {
      const double volume = least_volume(mesh_, e);
      const double longest = std::ranges::max(edge_lengths(mesh_, e));
      if (volume < -kFlat * std::pow(longest, 3)) {
        add_element(e, "is turned inside out", "nodes in the order of the format");
      } else if (volume < kFlat * std::pow(longest, 3)) {
        add_element(e, "is flat", "a volume of more than a millionth of its longest edge cubed");
      }
    }
  }

  void check_sides() {
    std::map<std::vector<int>, int> counts;
    for (int e = 0; e < mesh_.element_count(); ++e) {
      for (const auto& side : sides_of(mesh_.nodes_of(e))) {
        if (++counts[side] == 3) {
          add_element(e, "shares a side with two others", "at most two elements at a side");
        }
      }
    }
  }

  void check_use() {
    std::vector<bool> used(static_cast<size_t>(mesh_.node_count()), false);
    for (int e = 0; e < mesh_.element_count(); ++e) {
      for (const int node : mesh_.nodes_of(e)) used[static_cast<size_t>(node)] = true;
    }
    for (size_t i = 0; i < used.size(); ++i) {
      if (used[i]) continue;
      add(fmt::format("node {} belongs to no element", numbering_.first + static_cast<int>(i)),
          "nodes of elements alone: without one they have no mass");
    }
  }

  const VolumeMesh& mesh_;
  const VolumeNumbering& numbering_;
  std::vector<MeshProblem> problems_;
};

double tetrahedron_shape(const VolumeMesh& mesh, int element) {
  double squares = 0;
  for (const double length : edge_lengths(mesh, element)) squares += length * length;
  return 12 * std::cbrt(std::pow(3 * least_volume(mesh, element), 2)) / squares;
}

double hexahedron_shape(const VolumeMesh& mesh, int element) {
  const std::vector<int> nodes = mesh.nodes_of(element);
  double least = 1;
  for (size_t i = 0; i < 8; ++i) {
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k) {
      const auto other = static_cast<size_t>(kCornerEdges[i][k]);
      edges.col(k) = (mesh.positions.col(nodes[other]) - mesh.positions.col(nodes[i])).normalized();
    }
    least = std::min(least, edges.determinant());
  }
  return least;
}

double shape_of(const VolumeMesh& mesh, int element) {
  return element < mesh.tetrahedron_count() ? tetrahedron_shape(mesh, element)
                                            : hexahedron_shape(mesh, element);
}

}  // namespace

std::vector<MeshProblem> find_volume_problems(const VolumeMesh& mesh,
                                              const VolumeNumbering& numbering) {
  return VolumeJudge(mesh, numbering).problems();
}

void require_good_volume_mesh(const VolumeMesh& mesh, const VolumeNumbering& numbering) {
  const std::vector<MeshProblem> problems = find_volume_problems(mesh, numbering);
  if (problems.empty()) return;
  std::string text = problems.front().text;
  if (problems.size() > 1) text += fmt::format(", and {} problems more", problems.size() - 1);
  throw InputError({numbering.file, problems.front().line}, text, problems.front().expected);
}

std::vector<MeshProblem> find_slivers(const VolumeMesh& mesh, const VolumeNumbering& numbering) {
  constexpr double kSliver = 0.05;
  std::vector<std::pair<double, int>> slivers;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const double shape = shape_of(mesh, e);
    if (shape < kSliver) slivers.emplace_back(shape, e);
  }
  std::ranges::sort(slivers);
  slivers.resize(std::min<size_t>(slivers.size(), kMaxMeshProblems));
  std::vector<MeshProblem> problems;
  for (const auto& [shape, e] : slivers) {
    problems.push_back(element_problem(mesh, numbering, e,
                                       fmt::format("is a sliver: its shape is {:.2g}", shape),
                                       "elements of 0.05 at least; 1 is regular"));
  }
  return problems;
}

VolumeQuality volume_quality(const VolumeMesh& mesh) {
  VolumeQuality quality{INFINITY, 0, 0, INFINITY, 0};
  size_t edges = 0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    for (const double length : edge_lengths(mesh, e)) {
      quality.shortest_edge = std::min(quality.shortest_edge, length);
      quality.longest_edge = std::max(quality.longest_edge, length);
      quality.mean_edge += length;
      ++edges;
    }
    const double shape = shape_of(mesh, e);
    quality.mean_shape += shape / mesh.element_count();
    quality.least_shape = std::min(quality.least_shape, shape);
  }
  quality.mean_edge /= static_cast<double>(edges);
  return quality;
}

}  // namespace pliant
