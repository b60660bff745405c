#include "pliant/capture/cord_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "pliant/capture/median.h"

namespace pliant {
namespace {

/// Brightness by which a place stands out from both its sides.
double standing_out(const SplinePicture& picture, const Eigen::Vector2d& place,
                    const Eigen::Vector2d& aside, double sign) {
  const double left = sign * picture.value(place - aside);
  const double right = sign * picture.value(place + aside);
  return sign * picture.value(place) - std::max(left, right);
}

/// Of places along a line, by how much they stand out; of those that the picture shows.
std::vector<double> along(const SplinePicture& picture, const Eigen::Vector2d& from,
                          const Eigen::Vector2d& to, double side, double sign) {
  constexpr int kPlaces = 48;
  const Eigen::Vector2d way = to - from;
  const Eigen::Vector2d aside = side * Eigen::Vector2d(-way.y(), way.x()).normalized();
  std::vector<double> values;
  for (int i = 0; i < kPlaces; ++i) {
    const Eigen::Vector2d place = from + (i + 0.5) / kPlaces * way;
    if (picture.contains_beside(place, aside)) {
      values.push_back(standing_out(picture, place, aside, sign));
    }
  }
  return values;
}

/// The line that stands out most for a width, within the miss of a user; of no contrast where none
/// does.
PointedCord best_line(const SplinePicture& picture, const Eigen::Vector2d& from,
                      const Eigen::Vector2d& to, double sign, double side) {
  constexpr int kMiss = 5;         // pixels
  constexpr double kShare = 0.65;  // of the line's places
  const Eigen::Vector2d way = to - from;
  const Eigen::Vector2d across = Eigen::Vector2d(-way.y(), way.x()).normalized();
  PointedCord best{{sign, side, 0}, from, to};
  for (int first = -kMiss; first <= kMiss; ++first) {
    for (int last = -kMiss; last <= kMiss; ++last) {
      const Eigen::Vector2d a = from + first * across, b = to + last * across;
      const std::vector<double> values = along(picture, a, b, side, sign);
      if (values.empty()) continue;
      const double contrast = median(values);
      if (contrast <= best.look.contrast) continue;
      // A cord stands out nearly everywhere, a line through a texture here and there.
      const auto clear =
          std::ranges::count_if(values, [&](double value) { return value > contrast / 4; });
      if (static_cast<double>(clear) < kShare * static_cast<double>(values.size())) continue;
      best = {{sign, side, contrast}, a, b};
    }
  }
  return best;
}

}  // namespace

double CordLook::ridge(const SplinePicture& picture, const Eigen::Vector2d& place,
                       const Eigen::Vector2d& across) const {
  return std::clamp(standing_out(picture, place, side * across, sign) / contrast, -1.0, 1.0);
}

std::optional<PointedCord> look_of_cord(const SplinePicture& picture, const Eigen::Vector2d& from,
                                        const Eigen::Vector2d& to) {
  constexpr double kFaint = 0.02;                        // of white
  constexpr std::array kSides{2.0, 3.0, 4.0, 6.0, 8.0};  // pixels
  constexpr double kNearly = 0.85;                       // of the contrast that a wider one has
  std::vector<PointedCord> tried;
  for (const double sign : {1.0, -1.0}) {
    for (const double side : kSides) tried.push_back(best_line(picture, from, to, sign, side));
  }
  const auto contrast = [](const PointedCord& cord) { return cord.look.contrast; };
  const double most = contrast(*std::ranges::max_element(tried, {}, contrast));
  if (most < kFaint) return std::nullopt;
  // The narrowest: what is wider than the cord, as a label's margin, does not look like it then.
  return *std::ranges::find_if(
      tried, [&](const PointedCord& cord) { return contrast(cord) >= kNearly * most; });
}

}  // namespace pliant
