#include "pliant/material/solid/standard_solids.h"

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

Material neo_hookean_solid(double c10, double kappa) {
  Material material = solid("Neo-Hookean");
  material.components["I1-bar"] = of(linear(c10));
  material.components["J"] = of(ScalarCurve::constant(kappa));
  return material;
}

}  // namespace pliant
