#include "pliant/scene/held_vertices.h"

#include <array>

#include <fmt/format.h>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

constexpr std::array<bool, 3> kEveryDirection{true, true, true};

/// What holds each vertex of a cloth in each direction of the world; a file line, 0 for nothing.
class Holders {
 public:
  explicit Holders(std::span<const ClothVertices> cloths) {
    for (const ClothVertices& cloth : cloths) {
      lines_.emplace_back(static_cast<std::size_t>(cloth.positions.cols()));
    }
  }

  void hold(int cloth, const std::vector<int>& vertices, const std::array<bool, 3>& directions,
            const Location& where) {
    for (const int vertex : vertices) {
      std::array<int, 3>& lines =
          lines_[static_cast<std::size_t>(cloth)][static_cast<std::size_t>(vertex)];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!directions[axis]) continue;
        if (lines[axis] != 0) {
          throw InputError(
              where, fmt::format("vertex {} is held twice, first on line {}", vertex, lines[axis]),
              "each vertex in one clip, or in one pin a direction");
        }
        lines[axis] = where.line;
      }
    }
  }

 private:
  std::vector<std::vector<std::array<int, 3>>> lines_;  // by cloth and vertex
};

void check_cords(const SceneClip& clip, const Eigen::Matrix3Xd& positions) {
  for (const SceneCord& cord : clip.cords) {
    if (!cord.vertex || *cord.vertex < positions.cols()) continue;
    Location where = cord.where;
    where.field += ".vertex";
    throw InputError(where, fmt::format("there is no vertex {}", *cord.vertex),
                     fmt::format("a number below {}", positions.cols()));
  }
}

}  // namespace

HeldVertices held_vertices(const Scene& scene, std::span<const ClothVertices> cloths) {
  PLIANT_ASSERT(cloths.size() == scene.cloth.size() + scene.solids.size(),
                "the vertices of each cloth and solid");
  HeldVertices held;
  Holders holders(cloths);
  for (const ScenePin& pin : scene.pins) {
    const ClothVertices& cloth = cloths[static_cast<std::size_t>(pin.piece)];
    held.pins.push_back(selected_vertices(pin.vertices, cloth));
    holders.hold(pin.piece, held.pins.back(), pin.directions, pin.where);
  }
  for (const SceneClip& clip : scene.clips) {
    const ClothVertices& cloth = cloths[static_cast<std::size_t>(clip.cloth)];
    held.clips.push_back(selected_vertices(clip.vertices, cloth));
    holders.hold(clip.cloth, held.clips.back(), kEveryDirection, clip.where);
    check_cords(clip, cloth.positions);
  }
  return held;
}

}  // namespace pliant
