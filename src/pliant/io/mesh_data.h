#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace pliant {

// What the formats of mesh files share: plain data, no mesh.

using Point2 = std::array<double, 2>;
using Point3 = std::array<double, 3>;

inline constexpr std::size_t kMaxMeshFileSize = std::size_t{1} << 30;

/// Faces of three or more corners each; a corner is the number of a vertex, counted from 0.
struct Polygons {
  std::vector<int> corners;       ///< of all faces, one after the other
  std::vector<std::size_t> ends;  ///< of each face in `corners`

  std::size_t size() const { return ends.size(); }
  std::size_t begin_of(std::size_t face) const { return face == 0 ? 0 : ends[face - 1]; }
  std::span<const int> operator[](std::size_t face) const {
    return std::span(corners).subspan(begin_of(face), ends[face] - begin_of(face));
  }
  void add(std::span<const int> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    ends.push_back(corners.size());
  }

  bool operator==(const Polygons&) const = default;
};

}  // namespace pliant
