#pragma once

#include <memory>
#include <optional>

#include "pliant/mechanics/cloth_potentials.h"
#include "pliant/mechanics/point_forces.h"
#include "pliant/solver/static_solver.h"

namespace pliant::test {

inline MaterialComponent component(const ScalarCurve& stiffness,
                                   const std::optional<DahlParameters>& friction = {}) {
  MaterialComponent made;
  made.stiffness = stiffness;
  if (friction) made.friction = ComponentFriction{*friction, {}};
  return made;
}

/// A linear elastic cloth without internal friction; its bending is that of hinges.
inline Material linear_cloth(double stretch, double shear, double bending) {
  Material material;
  material.name = "linear";
  material.density = 0.2;
  material.bending_of = "hinges";
  for (const char* name : {"stretch.weft", "stretch.warp"}) {
    material.components[name] = component(ScalarCurve::constant(stretch));
  }
  material.components["shear"] = component(ScalarCurve::constant(shear));
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    material.components[name] = component(ScalarCurve::constant(bending));
  }
  return material;
}

/// Stretch of cotton ([T] Table 5.1); shear and bending, which the table lacks, are made up.
inline Material cotton() {
  Material material = linear_cloth(0, 0, 0);
  material.name = "cotton";
  material.density = 0.143;
  for (const char* name : {"stretch.weft", "stretch.warp"}) {
    material.components[name] =
        component(ScalarCurve::affine(135.6, 64.03), DahlParameters{2.22, 3.16, 0.006});
  }
  material.components["shear"] =
      component(ScalarCurve::affine(20, 10), DahlParameters{0.5, 0.4, 0.01});
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    material.components[name] =
        component(ScalarCurve::affine(1e-4, 1e-6), DahlParameters{2e-4, 1e-5, 3});
  }
  return material;
}

/// A system of one cloth; pins, loads and `system.finish()` are the test's.
struct ClothSheet {
  TriangleMesh mesh;
  System system;

  ClothSheet(const TriangleMesh& of, const Material& material, const DensityOptions& options = {})
      : mesh(of), system(of.positions, material.density * vertex_areas(of)) {
    add_cloth(system, mesh, material, options);
  }

  /// The weight of all points, along -z or along another direction.
  Eigen::Matrix3Xd weight(const Eigen::Vector3d& down = -Eigen::Vector3d::UnitZ()) const {
    return 9.81 * down * system.masses().transpose();
  }
  void add_gravity(const Eigen::Vector3d& down = -Eigen::Vector3d::UnitZ()) {
    system.add(std::make_shared<PointForces>(weight(down)));
  }
  /// Vertices at rest coordinate v, of a mesh in its rest shape.
  std::vector<int> row_at(double v) const {
    std::vector<int> row;
    for (int i = 0; i < mesh.vertex_count(); ++i) {
      if (std::abs(mesh.positions(1, i) - v) < 1e-9) row.push_back(i);
    }
    return row;
  }
  /// Where points are at rest, for controls that hold them.
  std::vector<Controls::Place> places(const std::vector<int>& points) const {
    std::vector<Controls::Place> places;
    for (const int point : points) places.push_back({point, mesh.positions.col(point)});
    return places;
  }
  void prescribe(const std::vector<int>& points) {
    for (const int point : points) system.coordinates().prescribe(point);
  }
};

}  // namespace pliant::test
