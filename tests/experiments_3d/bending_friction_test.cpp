// Friction of bending, told by sheets that are pushed over a table's edge.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/estimation/sheet/sheet_fit.h"
#include "pliant/experiment/session/virtual_session.h"
#include "pliant/study/study_fit.h"

#include "io/temporary_folder.h"
#include "support/asked_for.h"

namespace pliant {
namespace {

constexpr DahlParameters kFriction{2e-4, 1e-6, 10};

Material cloth() {
  Material material = first_sheet_material({});
  material.density = 0.15;
  const auto give = [&](const char* name, double stiffness) {
    material.components[name].stiffness = ScalarCurve::hermite({0.0}, {stiffness}, is_even(name));
  };
  give("stretch.weft", 300);
  give("stretch.warp", 500);
  give("shear", 20);
  for (const auto& [name, stiffness] :
       {std::pair{"bend.weft", 4e-6}, {"bend.warp", 6e-6}, {"bend.diagonal", 5e-6}}) {
    give(name, stiffness);
    material.components[name].friction = ComponentFriction{kFriction, std::nullopt};
  }
  return material;
}

/// Sessions along weft and warp on their own mesh.
class OverTheEdge {
 public:
  explicit OverTheEdge(const Material& material, std::uint64_t seed) {
    RandomStream random(seed);
    for (const char* test : {"bend-weft", "bend-warp"}) {
      VirtualSession options = usual_session(test);
      options.nodes = {13, 13};
      options.frames = 20;
      options.amplitude = 0.07;
      options.noise = {.position = 75e-6};
      write_session(folder_.path() / test, make_virtual_session(material, options, random));
      experiments_ += fmt::format("  - {{name: {0}, type: session, data: {0}}}\n", test);
    }
  }

  StudyResult fit(const std::string& friction) const {
    std::string components;
    for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
      components +=
          fmt::format("{}{}: {{friction: {}}}", components.empty() ? "" : ", ", name, friction);
    }
    folder_.write("study.yaml",
                  "pliant: study/1\nname: edge\nexperiments:\n" + experiments_ +
                      "model: {mesh: measured, components: {" + components +
                      "}}\nfit: {fix: {stretch.weft.k: 300, stretch.warp.k: 500, shear.k: 20}}\n");
    RunContext context;
    context.threads = 2;
    return fit_study(read_study(folder_.path() / "study.yaml"), {}, context);
  }

 private:
  test::TemporaryFolder folder_;
  std::string experiments_;
};

const ParameterEstimate& estimate(const StudyResult& fit, const std::string& name) {
  const auto found = std::ranges::find(fit.parameters, name, &ParameterEstimate::name);
  EXPECT_NE(found, fit.parameters.end()) << name;
  return *found;
}

// Elastic curves have to fall and rise for what friction does in going over the edge.
TEST(SlowBendingFriction, IsFoundInSessionsOverAnEdge) {
  const Material truth = cloth();
  const std::uint64_t seeds = test::makes_figures() ? 3 : 1;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const OverTheEdge sessions(truth, seed);
    const StudyResult elastic = sessions.fit("none"), fit = sessions.fit("auto");
    for (std::size_t i = 0; i < fit.experiments.size(); ++i) {
      std::printf("seed %d %s: %.3f mm, elastic %.3f mm\n", static_cast<int>(seed),
                  fit.experiments[i].name.c_str(), 1e3 * fit.experiments[i].rms,
                  1e3 * elastic.experiments[i].rms);
      EXPECT_LT(fit.experiments[i].rms, elastic.experiments[i].rms / 4);
    }
    for (const std::string component : {"bend.weft", "bend.warp"}) {
      const double stiffness = truth.components.at(component).stiffness->value(0);
      EXPECT_NEAR(estimate(fit, component + ".k[0]").value, stiffness, 0.05 * stiffness);
      const std::pair<const char*, double> numbers[] = {{".k[0]", stiffness},
                                                        {".friction.a", kFriction.a},
                                                        {".friction.b", kFriction.b},
                                                        {".friction.tau", kFriction.tau}};
      for (const auto& [name, value] : numbers) {
        const ParameterEstimate& found = estimate(fit, component + name);
        std::printf("  %s %.4g +- %.2g\n", found.name.c_str(), found.value,
                    found.std_error.value_or(0));
        ASSERT_TRUE(found.std_error.has_value()) << found.name;
        EXPECT_NEAR(found.value, value, 3 * *found.std_error) << found.name << ", seed " << seed;
      }
    }
  }
}

TEST(SlowBendingFriction, IsNotFoundWhereThereIsNone) {
  Material elastic = cloth();
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    elastic.components[name].friction.reset();
  }
  const StudyResult fit = OverTheEdge(elastic, 1).fit("auto");
  for (const ParameterEstimate& found : fit.parameters) {
    EXPECT_EQ(found.name.find("friction"), std::string::npos) << found.name;
  }
  EXPECT_NEAR(estimate(fit, "bend.weft.k[0]").value, 4e-6, 0.02 * 4e-6);
}

}  // namespace
}  // namespace pliant
