// Friction of cords and friction of cloth, told apart.

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/sheet/sheet_fit.h"
#include "pliant/experiment/session/virtual_session.h"
#include "pliant/study/study_fit.h"

#include "io/temporary_folder.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;

constexpr double kWidth = 0.1;  // of the loop of each cord (N); a clip has two
constexpr DahlParameters kFriction{2, 5, 0.008};

/// What a stretch along weft does not tell is as a fit guesses it.
Material cloth(bool friction) {
  Material material = first_sheet_material({});
  material.density = 0.2;
  MaterialComponent& weft = material.components.at("stretch.weft");
  weft.stiffness = ScalarCurve::hermite({0.0}, {300.0});
  material.components.at("shear").stiffness = ScalarCurve::hermite({0.0}, {60.0}, true);
  if (friction) weft.friction = ComponentFriction{kFriction, std::nullopt};
  return material;
}

/// Two cycles of a sheet along weft, seen by load cells.
class Stretch {
 public:
  explicit Stretch(const Material& material) {
    VirtualSession options = usual_session("stretch-weft");
    options.nodes = {6, 6};
    options.frames = 49;
    options.cycles = 2;
    options.noise = {.force = 3e-3, .cord_friction = kWidth};
    RandomStream random(3);
    write_session(folder_.path() / "weft", make_virtual_session(material, options, random));
  }

  Study study(const std::string& cord_friction) const {
    folder_.write("study.yaml",
                  fmt::format("pliant: study/1\nname: cords\nexperiments:\n"
                              "  - {{name: weft, type: session, data: weft{}}}\n"
                              "model: {{mesh: measured, variant: linear-orthotropic}}\n",
                              cord_friction));
    return read_study(folder_.path() / "study.yaml");
  }

  StudyResult fit(const std::string& cord_friction) const {
    RunContext context;
    context.threads = 2;
    return fit_study(study(cord_friction), {}, context);
  }

 private:
  test::TemporaryFolder folder_;
};

ParameterEstimate named(const StudyResult& result, const std::string& name) {
  for (const auto* list : {&result.parameters, &result.nuisance}) {
    for (const ParameterEstimate& p : *list) {
      if (p.name == name) return p;
    }
  }
  ADD_FAILURE() << name;
  return {};
}

/// Within three standard errors, which noise leaves once in 370 times.
void expect_found(const ParameterEstimate& estimate, double truth) {
  ASSERT_TRUE(estimate.std_error.has_value()) << estimate.name;
  EXPECT_NEAR(estimate.value, truth, 3 * *estimate.std_error) << estimate.name;
}

/// What the four cords of the two clips have together.
double total_width(const StudyResult& result) {
  double total = 0;
  for (const ParameterEstimate& cord : result.nuisance) total += cord.value;
  return total;
}

TEST(SlowCordFriction, CountsAsFrictionOfTheClothUnlessItIsLookedFor) {
  const Stretch stretch(cloth(true));
  const ParameterEstimate biased = named(stretch.fit(""), "stretch.weft.friction.a");
  EXPECT_GT(biased.value, 1.2 * kFriction.a);

  const StudyResult result = stretch.fit(", cord_friction: unknown");
  const ParameterEstimate a = named(result, "stretch.weft.friction.a");
  expect_found(a, kFriction.a);
  EXPECT_NEAR(a.value, kFriction.a, 0.05 * kFriction.a);
  EXPECT_NEAR(total_width(result), 4 * kWidth, 0.1 * 4 * kWidth);
  ASSERT_EQ(result.nuisance.size(), 4U);
  for (const ParameterEstimate& cord : result.nuisance) {
    // The two of a clip move alike: the data know both together, and they are taken to be alike.
    EXPECT_TRUE(cord.identified) << cord.name;
    expect_found(cord, kWidth);
    EXPECT_THAT(cord.note, HasSubstr("all 2 cords of the clip: 0.")) << cord.name;
    EXPECT_EQ(cord.owner, "weft");
  }
  EXPECT_EQ(result.covariance.rows(),
            static_cast<Eigen::Index>(result.parameters.size() + result.nuisance.size()));
}

TEST(SlowCordFriction, GivesAClothWithoutFrictionNone) {
  const Stretch stretch(cloth(false));
  EXPECT_TRUE(stretch.fit("").material.components.at("stretch.weft").friction.has_value());

  const StudyResult result = stretch.fit(", cord_friction: unknown");
  EXPECT_FALSE(result.material.components.at("stretch.weft").friction.has_value());
  EXPECT_NEAR(total_width(result), 4 * kWidth, 0.02 * 4 * kWidth);
  expect_found(named(result, "stretch.weft.k[0]"), 300);
  // The prediction follows the loop: what is left is the noise of two load cells.
  EXPECT_NEAR(result.experiments.front().rms, std::sqrt(2.0) * 3e-3, 1e-3);

  const StudyResult stated = stretch.fit(", cord_friction: 0.1 N");
  EXPECT_FALSE(stated.material.components.at("stretch.weft").friction.has_value());
  EXPECT_TRUE(stated.nuisance.empty());
  expect_found(named(stated, "stretch.weft.k[0]"), 300);
}

TEST(CordFriction, IsRefusedWherePositionsAreCompared) {
  const Stretch stretch(cloth(false));
  try {
    stretch.fit(", objective: positions, cord_friction: unknown");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("friction of cords"));
  }
}

}  // namespace
}  // namespace pliant
