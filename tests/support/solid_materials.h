#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pliant/material/addend/rubber_addends.h"
#include "pliant/material/material.h"

namespace pliant::test {

inline MaterialComponent component_of(std::vector<Addend> addends) {
  MaterialComponent component;
  component.stiffness = ScalarCurve::none();
  component.addends = std::move(addends);
  return component;
}

inline MaterialComponent component_of(const ScalarCurve& stiffness) {
  MaterialComponent component;
  component.stiffness = stiffness;
  return component;
}

inline Addend linear(double c) { return {linear_addend(), Eigen::VectorXd::Constant(1, c)}; }

inline Addend ogden(double mu, double alpha) {
  return {ogden_addend(), Eigen::Vector2d(mu, alpha)};
}

inline Addend polynomial(double c1, double c2, double c3) {
  return {polynomial_addend(), Eigen::Vector3d(c1, c2, c3)};
}

inline Addend arruda_boyce(double mu, double lock) {
  return {arruda_boyce_addend(), Eigen::Vector2d(mu, lock)};
}

inline Material solid_of(std::map<std::string, MaterialComponent> components) {
  Material material;
  material.name = "made-up";
  material.kind = MaterialKind::solid;
  material.components = std::move(components);
  return material;
}

}  // namespace pliant::test
