#include "pliant/capture/cord_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "pliant/base/parallel.h"

namespace pliant {
namespace {

constexpr double kShortest = 8, kLongest = 110;  // pixels from where a cord is fastened
constexpr double kStep = 2;                      // pixels along it
constexpr double kFineTurn = 0.008;              // rad, between directions that are tried

/// How much like a cord each direction in a picture looks from a place: -1 to 1.
class CordRose {
 public:
  /// @param aside  by which cords may pass beside the place (pixels)
  CordRose(const SplinePicture& picture, const CordLook& look, const Eigen::Vector2d& place,
           double longest, double aside)
      : values_(kDirections, -1.0) {
    const int count = static_cast<int>((longest - kShortest) / kStep);
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * std::numbers::pi * i / kDirections;
      const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
      const Eigen::Vector2d normal(-along.y(), along.x());
      for (double off = -aside; off <= aside; off += kStep) {
        double sum = 0;
        for (int k = 0; k < count; ++k) {
          const Eigen::Vector2d at = place + (kShortest + k * kStep) * along + off * normal;
          if (!picture.contains_beside(at, look.side * normal)) break;
          sum += look.ridge(picture, at, normal);
        }
        values_[static_cast<std::size_t>(i)] =
            std::max(values_[static_cast<std::size_t>(i)], sum / std::max(count, 1));
      }
    }
    widen();
  }

  double at(const Eigen::Vector2d& along) const {
    const double turns = std::atan2(along.y(), along.x()) / (2 * std::numbers::pi);
    const auto i = static_cast<long>(std::lround(turns * kDirections));
    return values_[static_cast<std::size_t>((i + kDirections) % kDirections)];
  }

 private:
  static constexpr int kDirections = 1440;

  /// Directions are tried in steps that a cord is too thin for.
  void widen() {
    const std::vector<double> own = values_;
    for (int i = 0; i < kDirections; ++i) {
      for (const int beside : {-2, -1, 1, 2}) {
        const auto j = static_cast<std::size_t>((i + beside + kDirections) % kDirections);
        double& value = values_[static_cast<std::size_t>(i)];
        value = std::max(value, own[j]);
      }
    }
  }

  std::vector<double> values_;
};

/// Cords that hardly turn aside from a line of sight show no direction.
constexpr double kLeastSeen = 0.2;  // of their length

/// The direction in which a camera sees a line leave a place, nothing where it looks along it.
std::optional<Eigen::Vector2d> seen_direction(const CameraModel& camera,
                                              const Eigen::Vector3d& from,
                                              const Eigen::Vector3d& direction) {
  const auto shown = camera.project_with_derivatives(from);
  if (!shown) return std::nullopt;
  const Eigen::Vector2d along = shown->by_point * direction;
  const double most = shown->by_point.norm() / std::numbers::sqrt2;
  if (along.norm() < kLeastSeen * most) return std::nullopt;
  return along;
}

/// What all cameras see around a place.
class PlaceRoses {
 public:
  /// @param left_out  a camera whose picture does not count; none where there is no such
  PlaceRoses(const CordViews& views, const CordLook& look, const Eigen::Vector3d& place,
             double length, double aside, std::size_t left_out)
      : views_(views), place_(place), roses_(views.cameras.size()) {
    parallel_for(static_cast<int>(roses_.size()), [&](int i) {
      const auto c = static_cast<std::size_t>(i);
      if (c == left_out) return;
      const auto shown = views.cameras[c].project_with_derivatives(place);
      if (!shown || !views.pictures[c].contains(shown->pixel)) return;
      constexpr double kForeshortened = 0.7;
      const double pixels = kForeshortened * length * shown->by_point.norm() / std::numbers::sqrt2;
      roses_[c].emplace(views.pictures[c], look, shown->pixel,
                        std::clamp(pixels, 2 * kShortest, kLongest), aside);
    });
  }

  /// Sum over the cameras.
  double at(const Eigen::Vector3d& direction) const {
    double sum = 0;
    for (std::size_t c = 0; c < roses_.size(); ++c) {
      if (!roses_[c]) continue;
      const auto along = seen_direction(views_.cameras[c], place_, direction);
      if (along) sum += roses_[c]->at(*along);
    }
    return sum;
  }

 private:
  CordViews views_;
  Eigen::Vector3d place_;
  std::vector<std::optional<CordRose>> roses_;
};

/// A direction that looks like a cord's.
struct LikelyDirection {
  double value = 0;  // as of PlaceRoses
  Eigen::Vector3d direction;
};

/// The likeliest directions, apart from each other.
std::vector<LikelyDirection> likeliest(std::vector<LikelyDirection> all) {
  constexpr std::size_t kMost = 6;
  constexpr double kApart = 0.995;  // cosine
  std::ranges::sort(all, std::greater{}, &LikelyDirection::value);
  std::vector<LikelyDirection> best;
  for (const LikelyDirection& one : all) {
    if (best.size() == kMost) break;
    const bool is_near = std::ranges::any_of(best, [&](const LikelyDirection& other) {
      return other.direction.dot(one.direction) > kApart;
    });
    if (!is_near) best.push_back(one);
  }
  return best;
}

}  // namespace

std::optional<CordLine> found_cord(const CordViews& views, const CordLook& look,
                                   const CordLine& last, double reach) {
  constexpr double kAside = 6;    // pixels
  constexpr double kLeast = 0.5;  // of what a camera sees of a cord that it sees well
  constexpr auto kNone = std::numeric_limits<std::size_t>::max();
  const PlaceRoses roses(views, look, last.from, last.length, kAside, kNone);
  const Eigen::Vector3d first = last.direction.unitOrthogonal();
  const Eigen::Vector3d second = last.direction.cross(first);
  std::vector<LikelyDirection> all{{roses.at(last.direction), last.direction}};
  for (double turn = kFineTurn; turn <= reach; turn += kFineTurn) {
    const int count = static_cast<int>(2 * std::numbers::pi * std::sin(turn) / kFineTurn) + 1;
    for (int i = 0; i < count; ++i) {
      const double around = 2 * std::numbers::pi * i / count;
      const Eigen::Vector3d direction =
          std::cos(turn) * last.direction +
          std::sin(turn) * (std::cos(around) * first + std::sin(around) * second);
      const double value = roses.at(direction);
      if (value > kLeast) all.push_back({value, direction});
    }
  }
  std::optional<CordLine> best;
  for (const LikelyDirection& one : likeliest(std::move(all))) {
    CordLine start = last;
    start.direction = one.direction;
    const auto line = fitted_cord(views, look, start);
    if (line && (!best || line->seen > best->seen)) best = line;
  }
  return best;
}

namespace {

/// The point of a line that is nearest to a line of sight.
Eigen::Vector3d nearest_to_ray(const CordLine& line, const SightRay& ray) {
  const Eigen::Vector3d apart = ray.from - line.from;
  const double facing = line.direction.dot(ray.direction);
  const double along =
      (apart.dot(line.direction) - facing * apart.dot(ray.direction)) / (1 - facing * facing);
  return line.from + along * line.direction;
}

}  // namespace

std::optional<CordLine> pointed_cord(const CordViews& views, std::size_t camera,
                                     const PointedCord& pointed,
                                     const Eigen::Hyperplane<double, 3>& fastened) {
  constexpr double kOff = 15e-3, kStepOff = 1e-3;  // m, of where it is fastened from the plane
  constexpr double kSteepest = 1.4;                // rad, against the plane of the picture
  const auto first = views.cameras[camera].ray(pointed.from);
  const auto last = views.cameras[camera].ray(pointed.to);
  if (!first || !last) return std::nullopt;
  const double facing = first->direction.dot(fastened.normal());
  if (std::abs(facing) < kLeastSeen) return std::nullopt;
  const double depth = -fastened.signedDistance(first->from) / facing;
  const Eigen::Vector3d aside =
      (last->direction - last->direction.dot(first->direction) * first->direction).normalized();
  const double apart = std::acos(std::clamp(first->direction.dot(last->direction), -1.0, 1.0));
  std::optional<CordLine> best;
  double most = 0;
  for (double off = -kOff; off <= kOff; off += kStepOff) {
    const double here = depth + off / std::abs(facing);
    const Eigen::Vector3d from = first->from + here * first->direction;
    const PlaceRoses roses(views, pointed.look, from, here * apart, 0, camera);
    for (double turn = -kSteepest; turn <= kSteepest; turn += kFineTurn) {
      const Eigen::Vector3d direction = std::cos(turn) * aside + std::sin(turn) * first->direction;
      const double value = roses.at(direction);
      if (value <= most) continue;
      most = value;
      // By the law of sines in the triangle of the camera and both ends.
      const double at_end = std::cos(turn + apart);
      const double length = here * std::sin(apart) / std::max(at_end, kLeastSeen);
      best = CordLine{from, direction, length, 0, 0};
    }
  }
  if (!best) return std::nullopt;
  auto line = fitted_cord(views, pointed.look, *best);
  if (!line) return std::nullopt;
  const Eigen::Vector3d from = nearest_to_ray(*line, *first);
  line->length -= (from - line->from).dot(line->direction);
  line->from = from;
  return line;
}

}  // namespace pliant
