#include "pliant/geometry/label_volume.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <Eigen/LU>

namespace pliant {

int LabelVolume::at(const Eigen::Vector3d& place) const {
  const Eigen::Vector3d index = axes.inverse() * (place - origin);
  std::array<int, 3> first{};
  std::array<double, 3> share{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    if (!(index(axis) >= 0 && index(axis) <= size(axis) - 1)) return 0;
    first[a] = std::min(static_cast<int>(index(axis)), size(axis) - 2);
    share[a] = index(axis) - first[a];
  }
  std::array<int, 8> around{};
  std::array<double, 8> weights{};
  for (std::size_t corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::array<int, 3> voxel = first;
    for (std::size_t a = 0; a < 3; ++a) {
      const bool next = ((corner >> a) & 1U) != 0;
      weight *= next ? share[a] : 1 - share[a];
      voxel[a] += next ? 1 : 0;
    }
    const auto number = voxel[0] + static_cast<std::int64_t>(size.x()) *
                                       (voxel[1] + static_cast<std::int64_t>(size.y()) * voxel[2]);
    around[corner] = labels[static_cast<std::size_t>(number)];
    // Onto the first that is alike.
    weights[static_cast<std::size_t>(std::ranges::find(around, around[corner]) - around.begin())] +=
        weight;
  }
  return around[static_cast<std::size_t>(std::ranges::max_element(weights) - weights.begin())];
}

}  // namespace pliant
