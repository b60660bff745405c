#include "pliant/geometry/refined_volume.h"

#include <algorithm>
#include <array>
#include <map>

namespace pliant {
namespace {

/// Whether corner i of a hexahedron is the far one along each axis.
constexpr std::array<std::array<int, 3>, 8> kCorners{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

template <std::size_t Corners>
auto columns(const std::vector<std::array<int, Corners>>& elements) {
  constexpr int kNodes = static_cast<int>(Corners);
  Eigen::Matrix<int, kNodes, Eigen::Dynamic> all(kNodes, std::ssize(elements));
  for (Eigen::Index e = 0; e < all.cols(); ++e) {
    for (int i = 0; i < kNodes; ++i) {
      all(i, e) = elements[static_cast<std::size_t>(e)][static_cast<std::size_t>(i)];
    }
  }
  return all;
}

class Refinement {
 public:
  explicit Refinement(const VolumeMesh& mesh) : mesh_(mesh) {
    for (int i = 0; i < mesh.node_count(); ++i) node({i});
  }

  RefinedVolume result() && {
    for (const auto& corners : mesh_.tetrahedra.colwise()) cut(Eigen::Vector4i(corners));
    for (const auto& corners : mesh_.hexahedra.colwise()) {
      cut(Eigen::Matrix<int, 8, 1>(corners));
    }
    VolumeMesh& fine = refined_.mesh;
    fine.tetrahedra = columns(tetrahedra_);
    fine.hexahedra = columns(hexahedra_);
    fine.positions.resize(3, std::ssize(refined_.between));
    for (Eigen::Index i = 0; i < fine.positions.cols(); ++i) {
      fine.positions.col(i) =
          mesh_.positions(Eigen::all, refined_.between[static_cast<std::size_t>(i)])
              .rowwise()
              .mean();
    }
    for (const int label : mesh_.labels) fine.labels.insert(fine.labels.end(), 8, label);
    fine.region_names = mesh_.region_names;
    for (const auto& [name, nodes] : mesh_.groups) fine.groups[name] = refined_.nodes(nodes);
    return std::move(refined_);
  }

 private:
  int node(std::vector<int> between) {
    std::ranges::sort(between);
    const auto next = static_cast<int>(refined_.between.size());
    const auto [found, added] = known_.try_emplace(between, next);
    if (added) refined_.between.push_back(std::move(between));
    return found->second;
  }

  /// Four tetrahedra at the corners, and four about a diagonal of what is left.
  void cut(const Eigen::Vector4i& v) {
    const auto middle = [&](int i, int j) { return node({v(i), v(j)}); };
    const int m01 = middle(0, 1), m02 = middle(0, 2), m03 = middle(0, 3), m12 = middle(1, 2),
              m13 = middle(1, 3), m23 = middle(2, 3);
    const std::array<std::array<int, 4>, 8> parts{{{v(0), m01, m02, m03},
                                                   {m01, v(1), m12, m13},
                                                   {m02, m12, v(2), m23},
                                                   {m03, m13, m23, v(3)},
                                                   {m01, m02, m03, m13},
                                                   {m01, m12, m02, m13},
                                                   {m02, m03, m13, m23},
                                                   {m02, m13, m12, m23}}};
    tetrahedra_.insert(tetrahedra_.end(), parts.begin(), parts.end());
  }

  void cut(const Eigen::Matrix<int, 8, 1>& v) {
    for (const auto& [x, y, z] : kCorners) {
      std::array<int, 8> part{};
      for (std::size_t i = 0; i < 8; ++i) {
        part[i] = lattice(v, {x + kCorners[i][0], y + kCorners[i][1], z + kCorners[i][2]});
      }
      hexahedra_.push_back(part);
    }
  }

  /// The node at a place of the 3 x 3 x 3 that halves make.
  int lattice(const Eigen::Matrix<int, 8, 1>& v, const std::array<int, 3>& place) {
    std::vector<int> between;
    for (std::size_t i = 0; i < 8; ++i) {
      const auto is_beside = [&](std::size_t axis) {
        return place[axis] == 1 || place[axis] == 2 * kCorners[i][axis];
      };
      if (is_beside(0) && is_beside(1) && is_beside(2)) {
        between.push_back(v(static_cast<Eigen::Index>(i)));
      }
    }
    return node(std::move(between));
  }

  const VolumeMesh& mesh_;
  RefinedVolume refined_;
  std::map<std::vector<int>, int> known_;
  std::vector<std::array<int, 4>> tetrahedra_;
  std::vector<std::array<int, 8>> hexahedra_;
};

}  // namespace

std::vector<int> RefinedVolume::nodes(const std::vector<int>& of_original) const {
  std::vector<int> nodes;
  for (std::size_t i = 0; i < between.size(); ++i) {
    if (std::ranges::includes(of_original, between[i])) nodes.push_back(static_cast<int>(i));
  }
  return nodes;
}

RefinedVolume refined(const VolumeMesh& mesh) { return Refinement(mesh).result(); }

}  // namespace pliant
