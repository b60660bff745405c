#include "pliant/estimation/law_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/material/addend/addend_registry.h"

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using test::lab_of;
using test::made_up_material;
using test::published_fabric;
using test::strip_cycles;
using test::VirtualStudy;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

StudyResult compared(const Material& material, VirtualTensileCycles cycles) {
  cycles.instrument.force_noise = 5e-3;
  VirtualStudy study(lab_of(material, cycles));
  study.set_model("components: {stretch.warp: {stiffness: affine}}");
  return study.fit({.compare_friction = false, .profiles = {}, .compare_laws = true});
}

TEST(LawComparison, NamesTheLawThatMadeTheData) {
  ComponentLaw law{ScalarCurve::affine(50, 30), FrictionLaw::dahl, {1.2, 2, 0.01}};
  law.addends = {{*find_addend_kind("softening"), Eigen::Vector2d(60, 0.15)}};
  const StudyResult result =
      compared(made_up_material("stretch.warp", law), strip_cycles({0.05, 0.1, 0.2, 0.35}));
  EXPECT_EQ(result.models.front().name, "with softening");
  EXPECT_EQ(result.models.back().name, "nothing that remembers");
  EXPECT_THAT(
      result.warnings,
      ::testing::Contains(HasSubstr("the data ask for another law: with softening leaves")));
}

// Nothing asks for more than friction: all richer laws explain no more than it does.
TEST(LawComparison, KeepsTheLawThatIsEnough) {
  const StudyResult result = compared(published_fabric("cotton"), strip_cycles({0.02, 0.05, 0.1}));
  EXPECT_EQ(result.models.front().name, "as fitted");
  for (const std::string& warning : result.warnings) {
    EXPECT_THAT(warning, ::testing::Not(HasSubstr("ask for another law")));
  }
}

TEST(LawComparison, AsksOfTimeWhereRowsHaveOne) {
  const auto names_of = [](const StudyResult& result) {
    std::vector<std::string> names;
    for (const ModelRank& rank : result.models) names.push_back(rank.name);
    return names;
  };
  VirtualTensileCycles cycles = strip_cycles({0.05, 0.1});
  EXPECT_THAT(names_of(compared(published_fabric("cotton"), cycles)),
              ::testing::Not(::testing::Contains("with maxwell")));
  cycles.duration = 60;
  EXPECT_THAT(names_of(compared(published_fabric("cotton"), cycles)),
              ::testing::Contains("with maxwell"));
}

TEST(LawAdvice, NamesTheTestsThatWouldTellLawsApart) {
  const auto rank = [](const char* name, double delta, const char* told_by) {
    ModelRank one{"shear", name};
    one.delta_bic = delta;
    one.told_by = told_by;
    return one;
  };
  EXPECT_THAT(law_advice({rank("with set", 0, "what is left"), rank("as fitted", 4, ""),
                          rank("with dahl", 30, "small cycles")}),
              ElementsAre("shear: the data hardly tell apart: with set, as fitted; what would: "
                          "what is left"));
}

}  // namespace
}  // namespace pliant
