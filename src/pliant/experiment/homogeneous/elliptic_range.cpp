#include "pliant/experiment/homogeneous/elliptic_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

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

const char* name_of(Way way) {
  switch (way) {
    case Way::uniaxial:
      return "uniaxial";
    case Way::equibiaxial:
      return "equibiaxial";
    case Way::planar:
      return "planar";
    case Way::volumetric:
      return "volumetric";
    case Way::shear:
      break;
  }
  return "shear";
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
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Identity();
    switch (way) {
      case Way::shear:
        gradient(0, 1) = size;
        break;
      case Way::volumetric:
        gradient *= size;
        break;
      case Way::uniaxial:
        return stretched({HomogeneousMode::uniaxial, size});
      case Way::equibiaxial:
        return stretched({HomogeneousMode::equibiaxial, size});
      case Way::planar:
        return stretched({HomogeneousMode::planar, size});
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

EllipticRange range_of(const Deformed& solid, Way way, bool compressed) {
  EllipticRange range{name_of(way), compressed};
  range.reach = size_of_step(way, compressed, 0);
  for (int step = 0; step <= kSteps; ++step) {
    const auto modulus = solid.wave_modulus(way, size_of_step(way, compressed, step));
    if (!modulus) {
      range.limited = true;
      return range;
    }
    if (*modulus <= 0) {
      double elliptic = step - 1, lost = step;
      for (int i = 0; i < kBisections && step > 0; ++i) {
        const double middle = (elliptic + lost) / 2;
        const auto between = solid.wave_modulus(way, size_of_step(way, compressed, middle));
        (between && *between > 0 ? elliptic : lost) = middle;
      }
      range.lost = true;
      range.at = size_of_step(way, compressed, lost);
      return range;
    }
    range.reach = size_of_step(way, compressed, step);
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
