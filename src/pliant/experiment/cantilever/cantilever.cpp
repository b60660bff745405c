#include "pliant/experiment/cantilever/cantilever.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "pliant/experiment/cantilever/cantilever_type.h"
#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/strip_figures.h"
#include "pliant/material/bending_strain.h"

namespace pliant {
namespace {

std::optional<std::string> axes_question(const std::vector<ProfileRows>& profiles) {
  for (const ProfileRows& profile : profiles) {
    const Eigen::Vector2d &first = profile.points[1], &tip = profile.points.back();
    if (first.x() < std::abs(first.y())) {
      return fmt::format(
          "a strip of the overhang {} leaves its clamp {}: are the columns `x` and `y` swapped, or "
          "`x` counted the other way?",
          millimetres(profile.setting), first.x() < 0 ? "backwards" : "steeply");
    }
    if (tip.y() > 0) {
      return fmt::format(
          "a strip of the overhang {} ends {} above its clamp: is `y` counted downwards, as in "
          "pictures?",
          millimetres(profile.setting), millimetres(tip.y()));
    }
  }
  return std::nullopt;
}

/// @param path  curvatures and the moments of the cloth's weight along all profiles
std::vector<std::string> questions_of(const std::vector<ProfileRows>& profiles,
                                      const MeasuredPath& path, const ExperimentSpec& spec,
                                      const DataRows& data, double density) {
  StripFigures strip(*spec.test, density);
  // Profiles of another length than their overhangs are refused: a slip is in all three.
  const auto all =
      strip.column("overhang`, `x` and `y", Dimension::length, data.quantity_unit("x"));
  for (const ProfileRows& profile : profiles) {
    strip.add(figures::kLength, profile.setting, {{all}});
  }
  double moments = 0, squares = 0;
  for (std::size_t i = 0; i < path.strain.size(); ++i) {
    moments += path.force[i] * path.strain[i] / kStrainPerCurvature;
    squares += std::pow(path.strain[i] / kStrainPerCurvature, 2);
  }
  const double per_weight = moments / squares / (density * kStandardGravity);
  if (per_weight > 0) {
    strip.add(figures::bending_length_of(density), std::cbrt(per_weight), {{all}});
  }
  return first_asked({axes_question(profiles), strip.question()});
}

}  // namespace

Cantilever::Cantilever(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth)
    : StripProfiles(spec, data, cloth.density, "overhang") {
  if (!spec_of<CantileverSpec>(spec).density_is_known) estimate_density(cloth.density);
  for (const ProfileRows& profile : profiles()) {
    if (!(profile.setting > 0)) {
      throw InputError(data.location(profile.first, "overhang"), "is not positive",
                       "the length that sticks out of the clamp");
    }
    add_strip(profile, profile.setting, 0, data);
  }
  info_.handled.push_back(fmt::format(
      "{} profiles: each strip starts flat and bends under its weight once", profiles().size()));
  info_.questions = questions_of(profiles(), path_, spec, data, cloth.density);
}

}  // namespace pliant
