#pragma once

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

#include "pliant/exchange/converted_solid.h"
#include "pliant/material/solid/ellipticity.h"
#include "pliant/material/solid/solid_density.h"
#include "pliant/material/solid/standard_solids.h"

#include "support/solid_materials.h"

namespace pliant::test {

inline constexpr double kBulk = 3e5;  // Pa

/// A law of shape with a law of the volume.
inline Material with_volume(std::map<std::string, MaterialComponent> components,
                            const std::string& metric = "J") {
  components[metric] = component_of(ScalarCurve::constant(kBulk));
  return solid_of(std::move(components));
}

/// The volume's energy bulk / 2 ((J^2 - 1) / 2 - ln J).
inline Material with_volume_of_square(std::map<std::string, MaterialComponent> components) {
  components["J"] = component_of({polynomial(kBulk / 2, kBulk / 4, 0)});
  components["log-J"] = component_of({linear(-kBulk / 2)});
  return solid_of(std::move(components));
}

struct NamedMaterial {
  std::string name;
  Material material;

  friend void PrintTo(const NamedMaterial& named, std::ostream* out) { *out << named.name; }
};

/// Materials of which every tool has the exact energy.
inline std::vector<NamedMaterial> materials_of_all_tools() {
  MaterialComponent yeoh = component_of({linear(4e4), polynomial(1e4, 0, 700)});
  yeoh.stiffness = ScalarCurve::constant(-2000);
  return {
      {"StVK", stvk_solid(2.3e5, 1.1e5)},
      {"NeoHookean", neo_hookean_solid(5.3e4, kBulk)},
      {"MooneyRivlin", with_volume({{"I1-bar", component_of({linear(4.1e4)})},
                                    {"I2-bar", component_of({linear(7e3)})}})},
      {"Yeoh", with_volume({{"I1-bar", yeoh}})},
      {"Ogden1", with_volume({{"stretch-bar", component_of({ogden(9e4, 1.7)})}})},
      {"Ogden3", with_volume({{"stretch-bar",
                               component_of({ogden(6e4, 1.3), ogden(2e3, 5), ogden(1e4, -2.1)})}})},
      {"PowersOfTheStretchAndI2",
       with_volume({{"stretch-bar", component_of({linear(3e4), polynomial(0, 8e4, 0)})},
                    {"I1-bar", component_of({linear(1e4)})}})},
  };
}

/// An orthotropic body, some of it written as squares of sums.
inline Material orthotropic_material() {
  return solid_of({{"green.xx", component_of(ScalarCurve::constant(7e4))},
                   {"green.yy", component_of({polynomial(0, 2e4, 0)})},
                   {"green.zz", component_of(ScalarCurve::constant(5e4))},
                   {"green.xx+yy", component_of(ScalarCurve::constant(2e4))},
                   {"green.yy*green.zz", component_of({linear(1e4)})},
                   {"green.xx*green.zz", component_of({linear(1.5e4)})},
                   {"green.yz", component_of(ScalarCurve::constant(1.1e4))},
                   {"green.xz", component_of(ScalarCurve::constant(1.4e4))},
                   {"green.xy", component_of(ScalarCurve::constant(0.9e4))}});
}

/// Deformation gradients without anything special about them.
inline std::vector<Eigen::Matrix3d> deformations() {
  std::vector<Eigen::Matrix3d> all(4);
  all[0] << 1.2, 0.4, 0, -0.1, 0.8, 0.2, 0.3, 0, 1.5;
  all[1] << 0.9, 0.1, -0.2, 0.3, 1.1, 0, 0.05, -0.3, 0.7;
  all[2] << 1.02, 0.01, 0, 0, 0.97, 0.02, -0.03, 0, 1.01;
  all[3] << 2.5, 0, 0, 0, 0.8, 0.1, 0, 0, 0.6;
  return all;
}

/// The same without a change of volume.
inline std::vector<Eigen::Matrix3d> isochoric_deformations() {
  std::vector<Eigen::Matrix3d> all = deformations();
  for (Eigen::Matrix3d& f : all) f /= std::cbrt(f.determinant());
  return all;
}

inline double energy_of(const Material& material, const Eigen::Matrix3d& f) {
  return deformed_point(*solid_density(material).law, f).energy;
}

/// What the formulas of manuals are written in.
struct Invariants {
  explicit Invariants(const Eigen::Matrix3d& f)
      : c(f.transpose() * f),
        j(f.determinant()),
        i1(c.trace()),
        i2((i1 * i1 - (c * c).trace()) / 2),
        i1_bar(i1 / std::cbrt(j * j)),
        i2_bar(i2 / std::cbrt(std::pow(j, 4))),
        stretches(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(c).eigenvalues().cwiseSqrt()) {}

  /// s1^alpha + s2^alpha + s3^alpha - 3
  static double powers(const Eigen::Vector3d& s, double alpha) {
    return s.array().pow(alpha).sum() - 3;
  }
  Eigen::Vector3d stretches_bar() const { return stretches / std::cbrt(j); }

  Eigen::Matrix3d c;
  double j, i1, i2, i1_bar, i2_bar;
  Eigen::Vector3d stretches;
};

/// lambda / 2 tr(E)^2 + mu tr(E^2) by Young's modulus and Poisson's ratio.
inline double linear_energy_of(double young, double poisson, const Invariants& at) {
  const Eigen::Matrix3d e = (at.c - Eigen::Matrix3d::Identity()) / 2;
  const double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
  return lambda / 2 * e.trace() * e.trace() + young / (2 * (1 + poisson)) * (e * e).trace();
}

/// By the stiffness of the normal Green strains and of 2 E_yz, 2 E_xz, 2 E_xy.
inline double orthotropic_energy_of(const Eigen::Matrix3d& normal, const Eigen::Vector3d& shear,
                                    const Invariants& at) {
  const Eigen::Matrix3d e = (at.c - Eigen::Matrix3d::Identity()) / 2;
  const Eigen::Vector3d own = e.diagonal(), askew(2 * e(1, 2), 2 * e(0, 2), 2 * e(0, 1));
  return own.dot(normal * own) / 2 + shear.dot(askew.cwiseAbs2()) / 2;
}

inline SolidToConvert to_convert(const Material& material, const VolumeMesh* mesh = nullptr) {
  return {material, "rubber.json", standard_law(material, "rubber.json"), mesh};
}

}  // namespace pliant::test
