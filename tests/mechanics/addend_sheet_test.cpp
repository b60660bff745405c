// A sheet whose material has addends: stretched along warp it pulls as the law of the component
// does along the same path.

#include <algorithm>

#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"
#include "pliant/material/addend/addend_registry.h"
#include "pliant/material/fill.h"
#include "pliant/material/law_path.h"
#include "pliant/mechanics/cloth_potentials.h"

#include "support/added_stiffness.h"
#include "support/evaluate_system.h"

namespace pliant {
namespace {

Material knit() {
  Material material;
  material.name = "knit";
  material.density = 0.2;
  for (const std::string& name : sheet_component_names()) {
    set_law(material.components[name], {ScalarCurve::constant(is_bending(name) ? 1e-6 : 20)});
  }
  ComponentLaw warp{ScalarCurve::none(), FrictionLaw::dahl, {1, 2, 0.02}};
  warp.addends = {{test::added_stiffness(), Eigen::Vector2d(30, 50)},
                  {*find_addend_kind("dahl"), Eigen::Vector3d(2, 5, 0.2)},
                  {*find_addend_kind("plastic"), Eigen::Vector2d(20, 0.05)}};
  set_law(material.components["stretch.warp"], warp);
  return material;
}

TEST(AddendSheet, PullsAlongAPathAsItsLawDoes) {
  constexpr double kWidth = 0.1, kHeight = 0.2;
  const TriangleMesh mesh = regular_grid(kWidth, kHeight, 3, 4);
  const Material material = knit();
  System system(mesh.positions, Eigen::VectorXd::Zero(mesh.vertex_count()));
  add_cloth(system, mesh, material, {});
  system.finish();
  LawPath path(*law_of(material, "stretch.warp"), {});
  State state = system.initial_state();
  for (const double stretch : {1.1, 1.03, 1.2, 1.15}) {
    Configuration stretched = system.initial_state().configuration;
    stretched.positions.row(1) *= stretch;
    const Eigen::Matrix3Xd forces = test::gradient_of(system, stretched, state);
    double pull = 0;
    for (int i = 0; i < mesh.vertex_count(); ++i) {
      if (mesh.positions(1, i) > kHeight - 1e-9) pull += forces(1, i);
    }
    const double strain = (stretch * stretch - 1) / 2;
    EXPECT_NEAR(pull, kWidth * stretch * path.at(strain).stress, 1e-12) << stretch;
    path.turn_at(strain, {});
    test::accept(system, state, stretched);
  }
}

// k / 2 (E_weft + E_warp)^2 ([T] Eq. 4.3, the cross term with it), about every stretch.
TEST(CoupledSheet, StoresTheEnergyOfTheSumOfItsStrains) {
  const TriangleMesh mesh = regular_grid(0.1, 0.2, 3, 4);
  Material material = knit();
  set_law(material.components["stretch.warp"], {ScalarCurve::constant(20)});
  Material coupled = material;
  set_law(coupled.components[kCoupling], {ScalarCurve::constant(50)});
  const auto energy = [&](const Material& cloth, double weft, double warp) {
    System system(mesh.positions, Eigen::VectorXd::Zero(mesh.vertex_count()));
    add_cloth(system, mesh, cloth, {});
    system.finish();
    Configuration at = system.initial_state().configuration;
    at.positions.row(0) *= weft;
    at.positions.row(1) *= warp;
    return test::energy_of(system, at, system.initial_state()).stored;
  };
  for (const auto& [weft, warp] : {std::pair{1.1, 1.0}, {1.2, 0.9}, {0.95, 1.3}}) {
    const double sum = (weft * weft - 1) / 2 + (warp * warp - 1) / 2;
    EXPECT_NEAR(energy(coupled, weft, warp) - energy(material, weft, warp),
                0.1 * 0.2 * 50 * sum * sum / 2, 1e-12);
  }
}

TEST(AddendSheet, NamesTheNumbersOfAddendsAmongItsParameters) {
  const TriangleMesh mesh = regular_grid(0.1, 0.1, 2, 2);
  System system(mesh.positions, Eigen::VectorXd::Zero(mesh.vertex_count()));
  add_cloth(system, mesh, knit(), {});
  system.finish();
  const auto& names = system.parameters().names;
  for (const char* name : {"stretch.warp.added.k2", "stretch.warp.dahl.tau"}) {
    EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
  }
  EXPECT_EQ(std::ranges::find(names, "stretch.warp.k"), names.end());
}

TEST(AddendSheet, WithoutFrictionKeepsAllAddendsButFriction) {
  const TriangleMesh mesh = regular_grid(0.1, 0.1, 2, 2);
  System system(mesh.positions, Eigen::VectorXd::Zero(mesh.vertex_count()));
  add_cloth(system, mesh, knit(), {.friction = false});
  system.finish();
  const auto& names = system.parameters().names;
  EXPECT_NE(std::ranges::find(names, "stretch.warp.added.k2"), names.end());
  EXPECT_NE(std::ranges::find(names, "stretch.warp.plastic.yield"), names.end());
  EXPECT_EQ(std::ranges::find(names, "stretch.warp.dahl.tau"), names.end());
}

}  // namespace
}  // namespace pliant
