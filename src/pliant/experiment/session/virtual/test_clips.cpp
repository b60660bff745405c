#include "pliant/experiment/session/virtual/test_clips.h"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr double kCordArm = 5e-3;  // from the cloth to where a cord is attached (m)

/// Makes the clips of one session.
class ClipMaker {
 public:
  explicit ClipMaker(const VirtualSession& options)
      : options_(options), size_(options.width, options.height) {}

  std::vector<TestClip> make() const {
    if (options_.test == "stretch-weft") return {stretch_bar(0, 0), stretch_bar(0, 1)};
    if (options_.test == "stretch-warp" || options_.test == "bias-extension") {
      return {stretch_bar(1, 0), stretch_bar(1, 1)};
    }
    if (options_.test == "complex-shear") return {sliding_bar(0), sliding_bar(1)};
    if (options_.test == "shear") {
      return {frame_bar(0, 0), frame_bar(0, 1), frame_bar(1, 0), frame_bar(1, 1)};
    }
    if (options_.test == "corner-pull")
      return {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
    return {};
  }

 private:
  /// A clip along the side at the low (0) or high (1) end of an axis.
  /// @param gap  from the ends of the side (m)
  TestClip bar(int axis, int end, double gap) const {
    static constexpr const char* kNames[2][2] = {{"left", "right"}, {"bottom", "top"}};
    const int along = 1 - axis;
    const double outward = end == 0 ? -1 : 1;
    const double side = end * size_(axis);
    Vector2d inner, outer, arm;
    inner(axis) = side - outward * options_.grip;
    outer(axis) = side;
    arm(axis) = side + outward * kCordArm;
    TestClip clip;
    clip.name = kNames[axis][end];
    for (const double place : {gap, size_(along) - gap}) {
      inner(along) = outer(along) = arm(along) = place;
      clip.holds.extend(inner).extend(outer);
      clip.cords.push_back(arm);
    }
    inner(along) = size_(along) / 2;
    clip.pivot = inner;
    return clip;
  }

  double free_length(int axis) const { return size_(axis) - 2 * options_.grip; }

  /// The strain between what is there at first and the amplitude.
  double strain(double load) const {
    return options_.initial_strain + load * (options_.amplitude - options_.initial_strain);
  }

  /// Pulls straight away from the bar on the other side.
  TestClip stretch_bar(int axis, int end) const {
    TestClip clip = bar(axis, end, 0);
    const Vector2d full = (end - 0.5) * free_length(axis) * Vector2d::Unit(axis);
    clip.motion = [*this, full](double load) { return PlaneMotion{0, strain(load) * full}; };
    return clip;
  }

  /// Moves along itself, the bar on the other side the other way.
  TestClip sliding_bar(int end) const {
    TestClip clip = bar(1, end, 0);
    const Vector2d apart = (end - 0.5) * free_length(1) * Vector2d::UnitY();
    const Vector2d along = (end - 0.5) * Vector2d::UnitX();
    clip.motion = [*this, apart, along](double load) {
      return PlaneMotion{0, options_.initial_strain * apart + load * options_.amplitude * along};
    };
    return clip;
  }

  /// A side of the picture frame. The yarns between the bars keep their length: weft turns by half
  /// of the angle, warp by as much the other way.
  TestClip frame_bar(int axis, int end) const {
    TestClip clip = bar(axis, end, 2 * options_.grip);
    const Vector2d arm = clip.pivot - size_ / 2;
    clip.motion = [*this, arm, axis](double load) {
      const double half = load * options_.amplitude / 2;
      Eigen::Matrix2d rhombus;
      rhombus << std::cos(half), std::sin(half), std::sin(half), std::cos(half);
      return PlaneMotion{axis == 0 ? -half : half,
                         (1 + options_.initial_strain) * (rhombus * arm) - arm};
    };
    return clip;
  }

  /// A small clip that pulls along the diagonal. Corners at opposite ends are a pair; the pair of
  /// the lower left one has its turn under positive loads.
  TestClip corner(int right, int top) const {
    const Vector2d out(2 * right - 1, 2 * top - 1);
    const Vector2d tip(right * size_.x(), top * size_.y());
    const Vector2d inner = tip - options_.grip * out;
    TestClip clip;
    clip.name = std::string(top ? "upper" : "lower") + (right ? "-right" : "-left");
    clip.holds.extend(tip).extend(inner);
    const Vector2d across(-out.y(), out.x());
    for (const double side : {-1.0, 1.0}) {
      clip.cords.push_back(tip + kCordArm / std::sqrt(2) * (out + side * across));
    }
    clip.pivot = inner;
    const Vector2d full = inner - size_ / 2;
    const double sign = right == top ? 1 : -1;
    clip.motion = [*this, full, sign](double load) {
      return PlaneMotion{0, strain(std::max(sign * load, 0.0)) * full};
    };
    return clip;
  }

  VirtualSession options_;
  Vector2d size_;
};

std::vector<double> turning_loads(const VirtualSession& options) {
  const int legs = session_test_kind(options.test).legs;
  std::vector<double> turns{0};
  if (legs == 0) turns.push_back(1);
  for (int leg = 0; leg < legs * options.cycles; ++leg) {
    turns.push_back(leg % 2 == 1 ? 0.0 : leg % 4 == 0 || legs == 2 ? 1.0 : -1.0);
  }
  return turns;
}

}  // namespace

std::vector<TestClip> test_clips(const VirtualSession& options) {
  return ClipMaker(options).make();
}

std::vector<double> frame_loads(const VirtualSession& options) {
  const std::vector<double> turns = turning_loads(options);
  const int legs = static_cast<int>(turns.size()) - 1;
  std::vector<double> loads{turns.front()};
  for (int leg = 0; leg < legs; ++leg) {
    const int first = static_cast<int>(loads.size()) - 1;
    const int last = (leg + 1) * (options.frames - 1) / legs;
    const double from = turns[static_cast<std::size_t>(leg)];
    const double to = turns[static_cast<std::size_t>(leg) + 1];
    for (int frame = first + 1; frame <= last; ++frame) {
      loads.push_back(from + (to - from) * (frame - first) / (last - first));
    }
  }
  return loads;
}

}  // namespace pliant
