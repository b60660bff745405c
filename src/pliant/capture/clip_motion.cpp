#include "pliant/capture/clip_motion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"

namespace pliant {
namespace {

/// The axis across a side, and whether the side is that of its least coordinate.
struct Across {
  Eigen::Index axis;
  bool is_first;
};

Across across(SampleSide side) {
  const bool along_u = side == SampleSide::bottom || side == SampleSide::top;
  return {along_u ? 1 : 0, side == SampleSide::bottom || side == SampleSide::left};
}

}  // namespace

Eigen::AlignedBox2d held_cloth(const DicFile& dic, const DicClip& clip) {
  const auto [axis, is_first] = across(clip.side);
  const Eigen::Vector2d size(dic.sample.width, dic.sample.height);
  const auto [from, to] = clip.along.value_or(std::pair(0.0, size(1 - axis)));
  constexpr double kDeepest = 0.4;  // of the sample
  if (clip.depth > kDeepest * size(axis) || from >= size(1 - axis) || to > size(1 - axis)) {
    throw InputError(
        {dic.file, 0, "clips"},
        fmt::format("{} holds more than there is of a sample of {} x {}", quoted_value(clip.name),
                    format_quantity(size.x(), Dimension::length),
                    format_quantity(size.y(), Dimension::length)),
        "a `depth` of at most 0.4 of the sample, and `along` within its side");
  }
  Eigen::Vector2d least, most;
  least(axis) = is_first ? 0 : size(axis) - clip.depth;
  most(axis) = is_first ? clip.depth : size(axis);
  least(1 - axis) = from;
  most(1 - axis) = to;
  return {least, most};
}

HeldPlace held_place(const DicFile& dic, const DicClip& clip, const TriangleMesh& rest) {
  constexpr double kRounding = 1e-9;  // m
  const auto [axis, is_first] = across(clip.side);
  HeldPlace held;
  held.cloth = held_cloth(dic, clip);
  held.outward = (is_first ? -1.0 : 1.0) * Eigen::Vector3d::Unit(axis);
  const double inner = is_first ? held.cloth.max()(axis) : held.cloth.min()(axis);
  const Eigen::Vector2d around = Eigen::Vector2d::Constant(kRounding);
  const Eigen::AlignedBox2d box(held.cloth.min() - around, held.cloth.max() + around);
  for (int v = 0; v < rest.vertex_count(); ++v) {
    const Eigen::Vector2d place = rest.positions.col(v).head<2>();
    if (!box.contains(place)) continue;
    held.vertices.push_back(v);
    if (std::abs(place(axis) - inner) < kRounding) held.edge.push_back(v);
  }
  return held;
}

std::vector<SessionClip> session_clips(const std::vector<DicClip>& clips,
                                       const std::vector<HeldPlace>& held) {
  std::vector<SessionClip> result;
  std::set<int> taken;
  for (std::size_t c = 0; c < clips.size(); ++c) {
    SessionClip clip{clips[c].name, clips[c].mass, {}};
    // The corner of two sides is the first clip's.
    std::ranges::copy_if(held[c].vertices, std::back_inserter(clip.clamped),
                         [&](int vertex) { return taken.insert(vertex).second; });
    result.push_back(std::move(clip));
  }
  return result;
}

Pose one_after_another(const Pose& first, const Pose& second) {
  return {(second.rotation * first.rotation).normalized(), second.apply(first.translation)};
}

std::optional<Pose> pose_of_points(const LocalMotion& motion, const Eigen::Matrix3Xd& rest,
                                   const Eigen::Vector3d& outward, double far) {
  // A second row of points, a little inside, tells how the clip has turned about its own edge. It
  // says a direction alone: the cloth may have stretched.
  constexpr double kInside = 0.02;  // of the length of the side
  const double inside = kInside * (rest.rightCols<1>() - rest.leftCols<1>()).norm();
  std::vector<Eigen::Vector3d> from, to;
  for (const auto& place : rest.colwise()) {
    const auto moved = motion.at(place.head<2>(), far);
    if (!moved) continue;
    from.emplace_back(place);
    to.push_back(moved->position);
    from.emplace_back(place - inside * outward);
    to.push_back(moved->position - inside * (moved->slope * outward.head<2>()).normalized());
  }
  if (static_cast<Eigen::Index>(from.size()) < rest.cols()) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(from.size());
  const Eigen::Map<const Eigen::Matrix3Xd> a(from.front().data(), 3, count);
  const Eigen::Map<const Eigen::Matrix3Xd> b(to.front().data(), 3, count);
  const Eigen::Matrix4d rigid = Eigen::umeyama(a, b, /*with_scaling=*/false);
  return Pose{Eigen::Quaterniond(Eigen::Matrix3d(rigid.topLeftCorner<3, 3>())).normalized(),
              rigid.topRightCorner<3, 1>()};
}

}  // namespace pliant
