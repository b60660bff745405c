// Cloth that differs from place to place ([T] 4.2.4): energies of its samples, blended by their
// weights at the middles of triangles and hinges.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"
#include "pliant/material/fill.h"
#include "pliant/material/material_samples.h"
#include "pliant/mechanics/cloth_potentials.h"

#include "support/evaluate_system.h"

namespace pliant {
namespace {

constexpr double kWidth = 0.1, kHeight = 0.2;

Material even_cloth(double factor) {
  Material material;
  material.name = "cloth";
  for (const std::string& name : sheet_component_names()) {
    material.components[name].stiffness =
        ScalarCurve::constant(factor * (is_bending(name) ? 1e-5 : 20));
  }
  material.components["area"].stiffness = ScalarCurve::constant(30 * factor);
  return material;
}

/// As stiff as its factors in all components but warp, at places along weft.
Material uneven_cloth(const std::vector<double>& factors) {
  Material material = even_cloth(1);
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(factors.size());
    material.samples.at.push_back(
        {{share * kWidth, kHeight / 2, 0}, even_cloth(factors[k]).components});
    material.samples.at.back().components.erase("stretch.warp");
  }
  material.samples.width = kWidth / static_cast<double>(factors.size());
  take_means(material);
  return material;
}

struct Sheet {
  TriangleMesh mesh = regular_grid(kWidth, kHeight, 5, 7);
  System system;

  explicit Sheet(const Material& material, const DensityOptions& options = {})
      : system(mesh.positions, Eigen::VectorXd::Zero(mesh.vertex_count())) {
    add_cloth(system, mesh, material, options);
    system.finish();
  }

  /// Strained and folded.
  Configuration deformed() const {
    Configuration at = system.initial_state().configuration;
    for (auto x : at.positions.colwise()) {
      x = Eigen::Vector3d(1.1 * x.x() + 0.2 * x.y(), 0.95 * x.y(), 0.4 * x.x() * x.x() / kWidth);
    }
    return at;
  }

  double energy(const Configuration& at) const {
    return test::energy_of(system, at, system.initial_state()).stored;
  }
};

TEST(ClothOfSamples, OfLikeOnesIsTheEvenCloth) {
  const Sheet one(even_cloth(2)), many(uneven_cloth({2, 2, 2}));
  Material warp = even_cloth(2);
  warp.components.at("stretch.warp").stiffness = ScalarCurve::constant(20);
  const Sheet alike(warp);
  const double energy = alike.energy(alike.deformed());
  EXPECT_NEAR(many.energy(many.deformed()), energy, 1e-12 * energy);
  EXPECT_GT(std::abs(one.energy(one.deformed()) - energy), 1e-3 * energy);
}

TEST(ClothOfSamples, StoresTheEnergyOfEachTimesItsWeight) {
  Material cloth = uneven_cloth({1, 4});
  for (SampledComponents& sample : cloth.samples.at) {
    std::erase_if(sample.components, [](const auto& own) { return own.first != "stretch.weft"; });
  }
  for (auto& [name, component] : cloth.components) {
    if (name != "stretch.weft") component.stiffness = ScalarCurve::constant(0);
  }
  const Sheet sheet(cloth);
  Configuration at = sheet.system.initial_state().configuration;
  constexpr double kStretch = 1.2, kStrain = (kStretch * kStretch - 1) / 2;
  at.positions.row(0) *= kStretch;
  double energy = 0;
  for (int t = 0; t < sheet.mesh.triangle_count(); ++t) {
    const Eigen::Vector2d middle = sheet.mesh.rest_triangle(t).rowwise().mean();
    const Eigen::VectorXd weights = weights_at(cloth.samples, {middle.x(), middle.y(), 0});
    const double stiffness = 20 * (weights(0) + 4 * weights(1));
    energy += rest_area(sheet.mesh, t) * stiffness * kStrain * kStrain / 2;
  }
  EXPECT_NEAR(sheet.energy(at), energy, 1e-12 * energy);
}

TEST(ClothOfSamples, NamesTheNumbersOfEach) {
  const Sheet sheet(uneven_cloth({1, 4}));
  const std::vector<std::string>& names = sheet.system.parameters().names;
  EXPECT_EQ(std::ranges::count(names, "samples[1].stretch.weft.k"), 1);
  EXPECT_EQ(std::ranges::count(names, "samples[0].area.k"), 1);
  EXPECT_EQ(std::ranges::count(names, "stretch.warp.k"), 1);
  EXPECT_EQ(std::ranges::count(names, "samples[0].bend.weft.k"), 1);
  EXPECT_EQ(std::ranges::count(names, "stretch.weft.k"), 0);
}

TEST(ClothOfSamples, PullsWithTheSlopeOfItsEnergy) {
  const Sheet sheet(uneven_cloth({1, 4, 0.5}));
  const Configuration at = sheet.deformed();
  const Eigen::Matrix3Xd gradient =
      test::gradient_of(sheet.system, at, sheet.system.initial_state());
  constexpr double kStep = 1e-6;
  for (const int node : {0, 12, 20}) {
    for (int axis = 0; axis < 3; ++axis) {
      Configuration beyond = at, before = at;
      beyond.positions(axis, node) += kStep;
      before.positions(axis, node) -= kStep;
      const double slope = (sheet.energy(beyond) - sheet.energy(before)) / (2 * kStep);
      EXPECT_NEAR(gradient(axis, node), slope, 1e-6 * gradient.norm());
    }
  }
}

}  // namespace
}  // namespace pliant
