#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pliant/base/random.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/mechanics/cloth_potentials.h"
#include "pliant/mechanics/system.h"

namespace pliant::test {

inline MaterialComponent component_of(ScalarCurve stiffness) {
  MaterialComponent result;
  result.stiffness = std::move(stiffness);
  return result;
}

inline MaterialComponent component_of(ScalarCurve stiffness, const DahlParameters& dahl) {
  MaterialComponent result = component_of(std::move(stiffness));
  result.friction = ComponentFriction{dahl, {}};
  return result;
}

/// Cotton: stretch from [T] Table 5.1, shear and bending of the same kind of fabric, with friction
/// on every component.
inline Material frictional_cotton() {
  Material material;
  material.name = "cotton";
  material.density = 0.143;
  const MaterialComponent stretch =
      component_of(ScalarCurve::affine(135.6, 64.03), {2.22, 3.16, 0.006});
  material.components["stretch.weft"] = material.components["stretch.warp"] = stretch;
  material.components["shear"] = component_of(ScalarCurve::constant(20), {0.5, 0, 0.01});
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    material.components[name] = component_of(ScalarCurve::constant(1e-5), {2e-5, 0, 20});
  }
  return material;
}

/// Differs in every direction, and has curves of every kind: what cotton alone would not show.
inline Material uneven_cotton() {
  Material material = frictional_cotton();
  material.components["stretch.warp"] = component_of(
      ScalarCurve::hermite({-0.3, -0.05, 0.05, 0.4}, {40, 90, 120, 300}), {1.4, 0.8, 0.02});
  material.components["shear"] =
      component_of(ScalarCurve::hermite({0, 0.1, 0.3}, {12, 15, 40}, true), {0.5, 0.2, 0.03});
  material.components["bend.warp"] =
      component_of(ScalarCurve::affine(3e-5, 2e-7), {1e-5, 1e-8, 15});
  material.components["bend.diagonal"] = component_of(ScalarCurve::constant(2e-5), {3e-5, 0, 30});
  return material;
}

/// A grid whose nodes inside stand up to `share` of an edge beside their places, in the rest plane
/// and in space alike.
inline TriangleMesh jittered_grid(double width, double height, int nodes_u, int nodes_v,
                                  std::uint64_t seed, double share = 0.25) {
  const TriangleMesh grid = regular_grid(width, height, nodes_u, nodes_v);
  Eigen::Matrix2Xd vertices = grid.positions.topRows<2>();
  RandomStream random(seed);
  for (int j = 1; j + 1 < nodes_v; ++j) {
    for (int i = 1; i + 1 < nodes_u; ++i) {
      vertices(0, j * nodes_u + i) += share * random.uniform(-1, 1) * width / (nodes_u - 1);
      vertices(1, j * nodes_u + i) += share * random.uniform(-1, 1) * height / (nodes_v - 1);
    }
  }
  return flat_mesh(vertices, grid.triangles);
}

/// One cloth as a system. `system` is not finished: a test first adds its own supports and forces.
struct ClothSystem {
  TriangleMesh mesh;
  std::unique_ptr<System> system;
  Cloth cloth;
};

inline ClothSystem cloth_system(const TriangleMesh& mesh, const Material& material,
                                const DensityOptions& options = {}) {
  ClothSystem result{mesh, nullptr, {}};
  result.system = std::make_unique<System>(mesh.positions, material.density * vertex_areas(mesh));
  result.cloth = add_cloth(*result.system, mesh, material, options);
  return result;
}

/// The friction form, damping of 1 % and nothing else.
inline DensityOptions damped(FrictionForm form = FrictionForm::variational) {
  return {true, form, 0.01};
}

/// Points that a normal distribution of width `size` (m) moves away from `positions`.
inline Eigen::Matrix3Xd shaken(const Eigen::Matrix3Xd& positions, RandomStream& random,
                               double size) {
  Eigen::Matrix3Xd result = positions;
  for (double& x : result.reshaped()) x += size * random.normal();
  return result;
}

}  // namespace pliant::test
