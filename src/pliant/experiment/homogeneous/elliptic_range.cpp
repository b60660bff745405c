#include "pliant/experiment/homogeneous/elliptic_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "pliant/experiment/homogeneous/homogeneous_point.h"
#include "pliant/material/solid/ellipticity.h"
#include "pliant/material/solid/solid_density.h"

namespace pliant {
namespace {

constexpr double kLargestStretch = 4, kLargestShear = 3;
constexpr int kSteps = 32;       // of a way
constexpr int kBisections = 30;  // of a step in which ellipticity is lost

enum class Way { uniaxial, equibiaxial, planar, volumetric, shear };
constexpr std::array kWays{Way::uniaxial, Way::equibiaxial, Way::planar, Way::volumetric,
                           Way::shear};

/// Of ways that homogeneous tests go too.
std::optional<HomogeneousMode> mode_of(Way way) {
  if (way == Way::uniaxial) return HomogeneousMode::uniaxial;
  if (way == Way::equibiaxial) return HomogeneousMode::equibiaxial;
  if (way == Way::planar) return HomogeneousMode::planar;
  return std::nullopt;
}

std::string_view name_of(Way way) {
  if (const auto mode = mode_of(way)) return name_of(*mode);
  return way == Way::shear ? "shear" : "volumetric";
}

/// A law without memory, and the deformations of its points.
class Deformed {
 public:
  explicit Deformed(const Material& material)
      : law_(solid_density(elastic(material)).law),
        isochoric_(std::ranges::all_of(material.components, [](const auto& component) {
          return !component.second.stiffness || component.first.ends_with("-bar");
        })) {}

  bool isochoric() const { return isochoric_; }

  /// @param size  of a shear the tangent of its angle, else a stretch
  /// @return nothing beyond a limit of energy, and without an equilibrium across
  std::optional<double> wave_modulus(Way way, double size) const {
    const auto gradient = gradient_at(way, size);
    if (!gradient) return std::nullopt;
    const DeformedPoint point = deformed_point(*law_, *gradient);
    if (!point.stress.allFinite() || !point.tangent.allFinite()) return std::nullopt;
    return least_wave_modulus(point, isochoric_);
  }

 private:
  static Material elastic(Material material) {
    for (auto& [name, component] : material.components) {
      if (component.stiffness) set_law(component, law_of(component).elastic_part());
    }
    return material;
  }

  std::optional<Eigen::Matrix3d> gradient_at(Way way, double size) const {
    if (const auto mode = mode_of(way)) return stretched({*mode, size});
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Identity();
    if (way == Way::shear) {
      gradient(0, 1) = size;
    } else {
      gradient *= size;
    }
    return is_within_limits(gradient) ? std::optional(gradient) : std::nullopt;
  }

  std::optional<Eigen::Matrix3d> stretched(const HomogeneousRow& row) const {
    HomogeneousPoint point(*law_, isochoric_, /*derivatives=*/false);
    const auto found = point.move_to(row);
    if (!found) return std::nullopt;
    return found->stretches.asDiagonal().toDenseMatrix();
  }

  bool is_within_limits(const Eigen::Matrix3d& gradient) const {
    return std::isfinite(deformed_point(*law_, gradient).energy);
  }

  std::shared_ptr<const Sum> law_;
  bool isochoric_;
};

double size_of_step(Way way, bool compressed, double step) {
  const double share = step / kSteps, sign = compressed ? -1 : 1;
  if (way == Way::shear) return sign * share * kLargestShear;
  return std::exp(sign * share * std::log(kLargestStretch));
}

/// Between a step at which something holds and one at which it does not: where it ends.
template <class Holds>
std::pair<double, double> end_between(double with, double without, const Holds& holds) {
  for (int i = 0; i < kBisections; ++i) {
    const double middle = (with + without) / 2;
    (holds(middle) ? with : without) = middle;
  }
  return {with, without};
}

EllipticRange range_of(const Deformed& solid, Way way, bool compressed) {
  const auto size = [&](double step) { return size_of_step(way, compressed, step); };
  const auto is_allowed = [&](double step) {
    return solid.wave_modulus(way, size(step)).has_value();
  };
  const auto is_elliptic = [&](double step) {
    const auto modulus = solid.wave_modulus(way, size(step));
    return modulus && *modulus > 0;
  };
  EllipticRange range{std::string(name_of(way)), compressed, size(0)};
  for (int step = 0; step <= kSteps; ++step) {
    if (is_elliptic(step)) {
      range.reach = size(step);
      continue;
    }
    if (step == 0) {
      range.limited = !is_allowed(0);
      range.lost = !range.limited;
      range.at = size(0);
      return range;
    }
    const double last = is_allowed(step) ? step : end_between(step - 1, step, is_allowed).first;
    range.limited = is_elliptic(last);
    range.lost = !range.limited;
    if (range.limited) {
      range.reach = size(last);
    } else {
      range.at = size(end_between(step - 1, last, is_elliptic).second);
    }
    return range;
  }
  return range;
}

}  // namespace

std::vector<EllipticRange> elliptic_ranges(const Material& material) {
  const Deformed solid(material);
  std::vector<EllipticRange> ranges;
  for (const Way way : kWays) {
    if (way == Way::volumetric && solid.isochoric()) continue;
    for (const bool compressed : {false, true}) {
      ranges.push_back(range_of(solid, way, compressed));
    }
  }
  return ranges;
}

}  // namespace pliant
