#include "pliant/experiment/profile_rows.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>
#include <fmt/format.h>
#include <unsupported/Eigen/Splines>

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

std::vector<double> ProfileRows::shares() const {
  std::vector<double> result{0};
  for (size_t i = 1; i < points.size(); ++i) {
    result.push_back(result.back() + (points[i] - points[i - 1]).norm());
  }
  for (double& share : result) share /= result.back();
  return result;
}

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

std::vector<double> profile_curvature(const ProfileRows& profile) {
  constexpr int kDegree = 3, kPointsPerKnot = 3, kMostSpans = 12;
  using Line = Eigen::Spline<double, 2>;
  const auto count = static_cast<Eigen::Index>(profile.points.size());
  const int spans = std::clamp(static_cast<int>(count) / kPointsPerKnot, 1, kMostSpans);
  Eigen::RowVectorXd knots(spans + 2 * kDegree + 1);
  knots << Eigen::RowVectorXd::Zero(kDegree), Eigen::RowVectorXd::LinSpaced(spans + 1, 0, 1),
      Eigen::RowVectorXd::Ones(kDegree);
  const std::vector<double> shares = profile.shares();
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(count, spans + kDegree), points(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double u = shares[static_cast<size_t>(i)];
    const Eigen::Index span = Line::Span(u, kDegree, knots);
    basis.row(i).segment(span - kDegree, kDegree + 1) = Line::BasisFunctions(u, kDegree, knots);
    points.row(i) = profile.points[static_cast<size_t>(i)].transpose();
  }
  const Eigen::MatrixXd controls = basis.colPivHouseholderQr().solve(points);
  const Line line(knots, Line::ControlPointVectorType(controls.transpose()));
  std::vector<double> curvature;
  for (const double u : shares) {
    const auto d = line.derivatives(u, 2);
    const double turn = d(0, 1) * d(1, 2) - d(1, 1) * d(0, 2);
    curvature.push_back(turn / std::pow(std::hypot(d(0, 1), d(1, 1)), 3));
  }
  return curvature;
}

}  // namespace pliant
