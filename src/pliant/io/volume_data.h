#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "pliant/io/mesh_data.h"

namespace pliant {

/// What a file of a volume mesh says: plain data, no mesh. Corners are numbers of points, from 0.
struct VolumeData {
  /// Elements of one shape.
  template <std::size_t Corners>
  struct Elements {
    std::vector<std::array<int, Corners>> corners;
    std::vector<int> labels;  ///< of the region of each
    std::vector<int> lines;   ///< where each stands, counted from 1; empty when not read

    bool operator==(const Elements&) const = default;
  };

  std::vector<Point3> points;
  Elements<4> tetrahedra;
  Elements<8> hexahedra;
  std::map<int, std::string> region_names;         ///< of labels
  std::map<std::string, std::vector<int>> groups;  ///< of points, rising
  /// After reading: what was left out (triangles, ...) and how often.
  std::map<std::string, int> ignored;
};

}  // namespace pliant
