// Scenes of materials whose energies have limits: no frame ends beyond one, and what begins there
// is refused.

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/scene_simulation.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;

// Without its limits the bar is stretched by 60 %, and the energy of its shape is 6.6 kJ/m^3.
constexpr const char* kSoft =
    R"({"pliant": "material/1", "name": "soft", "kind": "solid", "density": 1000,
 "components": {"I1-bar": {"addends": [{"law": "linear", "c": 600}]},
                "J": {"stiffness": {"curve": "constant", "value": 2e4}}},
 "limits": [{"of": ["I1-bar"], "energy": 30}, {"of": ["J"], "energy": 5}]})";

test::FileContents files() { return {{"soft.json", kSoft}}; }

Material limited_cloth() {
  Material material = test::linear_cloth(20, 10, 1e-5);
  material.density = 0.2;
  material.limits.push_back({{"stretch.warp", "shear"}, 0.02});  // a strain of about 0.045
  return material;
}

std::string bar(const std::string& time, const std::string& elements) {
  return "pliant: scene/1\nsolids:\n"
         "  - {name: bar, mesh: {block: [0.02, 0.02, 0.1], cells: [1, 1, 5], elements: " +
         elements +
         "}, material: soft.json}\n"
         "pins: [{solid: bar, within: {box: {low: [-1, -1, 0.1], high: [1, 1, 1]}}}]\n"
         "time: " +
         time + "\n";
}

std::string sheet(const std::string& time, const std::string& cloth = "") {
  return "pliant: scene/1\ncloth:\n"
         "  - {name: sheet, mesh: {grid: 100 mm x 100 mm, nodes: 6x6}, material: cloth.json" +
         cloth + "}\npins: [{cloth: sheet, edges: [top]}]\ngravity: [0, -200, -2]\ntime: " + time +
         "\n";
}

double share_left(const Simulation& simulation) {
  const State& state = simulation.now().state;
  return simulation.built().system->share_left(state.configuration, {state});
}

TEST(LimitScene, ASolidStopsAtItsLimits) {
  for (const char* elements : {"hexahedra", "tetrahedra"}) {
    Simulation simulation =
        test::simulation_of(bar("{step: 5 ms, duration: 1 s}", elements), files());
    double least = 1;
    for (int step = 0; step < 40; ++step) {
      simulation.advance();
      least = std::min(least, share_left(simulation));
      ASSERT_GT(least, 0) << elements << " step " << step;
    }
    EXPECT_LT(least, 0.01) << elements;  // it does reach them
    EXPECT_TRUE(simulation.now().state.configuration.positions.allFinite());
  }
}

TEST(LimitScene, ASolidHangsAtItsLimits) {
  Simulation simulation = test::simulation_of(
      bar("{kind: quasi-static, steps: 1, duration: 1 s}", "hexahedra"), files());
  simulation.advance();
  const double left = share_left(simulation);
  EXPECT_GT(left, 0);
  EXPECT_LT(left, 1e-3);
}

TEST(LimitScene, ASheetStopsAtItsLimit) {
  for (const char* time :
       {"{step: 5 ms, duration: 1 s}", "{kind: quasi-static, steps: 2, duration: 1 s}"}) {
    Simulation simulation = test::simulation_of(sheet(time), limited_cloth());
    for (int step = 0; step < (time[1] == 's' ? 30 : 2); ++step) {
      simulation.advance();
      ASSERT_GT(share_left(simulation), 0) << time;
    }
    EXPECT_LT(share_left(simulation), 0.1) << time;
  }
}

TEST(LimitScene, WhatBeginsBeyondALimitIsRefused) {
  try {
    test::simulation_of(
        sheet("{step: 5 ms, duration: 1 s}", ", noise: {amplitude: 10 mm, seed: 1}"),
        limited_cloth());
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().field, "cloth[0]");
    EXPECT_EQ(error.where().line, 3);
    EXPECT_THAT(error.problem(), HasSubstr("times the energy that a limit of its material allows"));
  }
}

TEST(LimitScene, OneLinearSystemAStepIsRefused) {
  try {
    test::simulation_of(sheet("{step: 5 ms, duration: 1 s, solve: linearized}"), limited_cloth());
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().field, "time.solve");
  }
}

TEST(LimitScene, LimitsOfSeveralSpringsAreRefused) {
  Material material = limited_cloth();
  material.membrane = MembraneMeasure::spring;
  EXPECT_THROW(test::simulation_of(sheet("{step: 5 ms, duration: 1 s}"), material), InputError);
  material.limits = {{{"stretch.warp"}, 0.02}};
  Simulation simulation = test::simulation_of(sheet("{step: 5 ms, duration: 1 s}"), material);
  test::take_steps(simulation, 5);
  EXPECT_GT(share_left(simulation), 0);
}

}  // namespace
}  // namespace pliant
