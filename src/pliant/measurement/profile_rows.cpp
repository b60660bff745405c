#include "pliant/measurement/profile_rows.h"

#include <fmt/format.h>

#include "pliant/math/spline_line.h"

namespace pliant {
namespace {

constexpr size_t kFewestPoints = 5;
constexpr double kSharpestTurn = -0.5;  // cosine of 120 degrees

void require_sound(const ProfileRows& profile, const DataRows& data) {
  if (profile.points.size() < kFewestPoints) {
    throw InputError(data.location(profile.first, "point"),
                     fmt::format("begins a profile of {} points", profile.points.size()),
                     fmt::format("at least {} points a profile", kFewestPoints));
  }
  for (size_t i = 1; i < profile.points.size(); ++i) {
    if (profile.points[i] != profile.points[i - 1]) continue;
    throw InputError(data.location(profile.first + static_cast<int>(i), "x"),
                     "stands where the point before it does", "points along the strip, each apart");
  }
  for (size_t i = 2; i < profile.points.size(); ++i) {
    const Eigen::Vector2d before = profile.points[i - 1] - profile.points[i - 2];
    const Eigen::Vector2d after = profile.points[i] - profile.points[i - 1];
    if (before.dot(after) > kSharpestTurn * before.norm() * after.norm()) continue;
    throw InputError(data.location(profile.first + static_cast<int>(i), "x"),
                     "the line through the points turns back here by more than 120 degrees",
                     "points in their order along the strip, close enough to follow it");
  }
}

}  // namespace

std::vector<double> ProfileRows::shares() const { return length_shares(points); }

std::vector<ProfileRows> read_profiles(const DataRows& data, std::string_view setting) {
  const std::vector<double> settings = data.quantity(setting, Dimension::length);
  const std::vector<double> x = data.quantity("x", Dimension::length);
  const std::vector<double> y = data.quantity("y", Dimension::length);
  const auto numbers = data.optional_integers("point");
  const auto repeats = data.optional_integers("repeat");
  std::vector<ProfileRows> profiles;
  const std::vector<SpecimenRows> specimens = data.specimens();
  for (size_t s = 0; s < specimens.size(); ++s) {
    const int end = specimens[s].first + specimens[s].count;
    for (int row = specimens[s].first; row < end; ++row) {
      const auto i = static_cast<size_t>(row);
      const bool begins = row == specimens[s].first || settings[i] != settings[i - 1] ||
                          (repeats && (*repeats)[i] != (*repeats)[i - 1]) ||
                          (numbers && (*numbers)[i] == 0);
      if (!begins && numbers && (*numbers)[i] <= (*numbers)[i - 1]) {
        throw InputError(
            data.location(row, "point"),
            fmt::format("point {} comes after point {}", (*numbers)[i], (*numbers)[i - 1]),
            "points in their order along the strip, 0 at the clamp");
      }
      if (begins) profiles.push_back({settings[i], static_cast<int>(s), row, {}});
      ProfileRows& profile = profiles.back();
      const auto first = static_cast<size_t>(profile.first);
      profile.points.emplace_back(x[i] - x[first], y[i] - y[first]);
    }
  }
  for (const ProfileRows& profile : profiles) require_sound(profile, data);
  return profiles;
}

}  // namespace pliant
