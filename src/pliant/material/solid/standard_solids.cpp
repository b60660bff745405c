#include "pliant/material/solid/standard_solids.h"

#include <array>
#include <string>

#include "pliant/material/addend/rubber_addends.h"

namespace pliant {
namespace {

Material solid(const char* name) {
  Material material;
  material.name = name;
  material.kind = MaterialKind::solid;
  return material;
}

MaterialComponent of(const ScalarCurve& stiffness) {
  MaterialComponent component;
  component.stiffness = stiffness;
  return component;
}

MaterialComponent of(Addend addend) {
  MaterialComponent component = of(ScalarCurve::none());
  component.addends.push_back(std::move(addend));
  return component;
}

Addend linear(double c) { return {linear_addend(), Eigen::VectorXd::Constant(1, c)}; }

}  // namespace

Material stvk_solid(double lambda, double mu) {
  Material material = solid("StVK");
  material.components["trace"] = of(ScalarCurve::constant(lambda));
  material.components["trace-of-square"] = of(linear(mu));
  return material;
}

Material orthotropic_stvk_solid(const Eigen::Matrix3d& normal, const Eigen::Vector3d& shear) {
  constexpr std::array kNormal{"green.xx", "green.yy", "green.zz"};
  constexpr std::array kShear{"green.yz", "green.xz", "green.xy"};
  Material material = solid("orthotropic StVK");
  for (Eigen::Index a = 0; a < 3; ++a) {
    const auto i = static_cast<std::size_t>(a);
    material.components[kNormal[i]] = of(ScalarCurve::constant(normal(a, a)));
    material.components[kShear[i]] = of(ScalarCurve::constant(shear(a)));
    for (Eigen::Index b = a + 1; b < 3; ++b) {
      const std::string pair = std::string(kNormal[i]) + "*" + kNormal[static_cast<std::size_t>(b)];
      material.components[pair] = of(linear(normal(a, b)));
    }
  }
  return material;
}

Material neo_hookean_solid(double c10, double kappa) {
  Material material = solid("Neo-Hookean");
  material.components["I1-bar"] = of(linear(c10));
  material.components["J"] = of(ScalarCurve::constant(kappa));
  return material;
}

}  // namespace pliant
