// Cloth models and their variants, fitted to the same sessions ([T] 3.5, Tables A.1-A.4).

#include <cmath>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/sheet/sheet_problem.h"
#include "pliant/study/sheet_model_fits.h"
#include "pliant/study/sheet_study.h"

#include "support/five_sheet_tests.h"

namespace pliant {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> names_of(const std::vector<ModelVariant>& combinations) {
  std::vector<std::string> names;
  for (const ModelVariant& combination : combinations) names.push_back(combination.name());
  return names;
}

TEST(ModelVariants, ComeAfterThoseThatTheyContain) {
  EXPECT_THAT(names_of(model_variants({"springs"}, {"nonlinear-orthotropic", "linear-isotropic",
                                                    "linear-orthotropic"})),
              ElementsAre("springs.linear-isotropic", "springs.linear-orthotropic",
                          "springs.nonlinear-orthotropic"));
  for (const SheetVariant& variant : sheet_variants()) {
    EXPECT_TRUE(is_contained(variant, sheet_variants().front()));
    EXPECT_TRUE(is_contained(sheet_variants().back(), variant));
  }
  EXPECT_FALSE(is_contained(sheet_variants()[1], sheet_variants()[2]));
  EXPECT_FALSE(is_contained(sheet_variants()[2], sheet_variants()[1]));
}

/// Fits of models in variants to the five tests of a cloth, by name.
class ModelFits {
 public:
  ModelFits(const Material& truth, const std::vector<std::string>& models,
            const std::vector<std::string>& variants) {
    const test::FiveSheetTests tests(truth, "", 9, 4);
    RunContext context;
    context.threads = 2;
    fit_sheet_models(tests.study(), model_variants(models, variants), context,
                     [&](const ModelFit& fit) { fits_.emplace(fit.combination.name(), fit); });
  }

  const std::map<std::string, ModelFit>& all() const { return fits_; }
  double misfit(const std::string& name) const {
    return misfit_percent(fits_.at(name).result.experiments);
  }
  double rms(const std::string& name, const std::string& experiment) const {
    for (const ExperimentResult& e : fits_.at(name).result.experiments) {
      if (e.name == experiment) return e.rms;
    }
    return NAN;
  }

 private:
  std::map<std::string, ModelFit> fits_;
};

/// Stretch that stiffens, and bending that is four times as stiff along warp as along weft.
Material anisotropic_cloth() {
  Material cloth = test::sheet_cloth(true);
  cloth.components["bend.weft"].stiffness = ScalarCurve::hermite({0}, {4e-6}, true);
  cloth.components["bend.warp"].stiffness = ScalarCurve::hermite({0}, {16e-6}, true);
  return cloth;
}

/// Of the cloth above, whose tests have no noise.
void expect_told_from_others(const ModelFits& fits) {
  // The cloth is one of the freest variant's.
  EXPECT_LT(fits.misfit("stvk.nonlinear-orthotropic"), 0.1);
  // Bending of one stiffness, whose truth differs by a factor of 4, misses by millimetres; curves
  // that differ by direction miss by nothing. Of stretch that rises sixfold a constant misses half.
  for (const char* test : {"bend-weft", "bend-warp"}) {
    EXPECT_GT(fits.rms("stvk.nonlinear-isotropic", test), 1e-3) << test;
    EXPECT_LT(fits.rms("stvk.linear-orthotropic", test), 1e-4) << test;
  }
  EXPECT_GT(fits.rms("stvk.linear-orthotropic", "stretch-weft"), 0.05);
}

void expect_none_worse_than_what_it_contains(const ModelFits& fits) {
  for (const auto& [smaller, fit] : fits.all()) {
    ASSERT_EQ(fit.failure, "") << smaller;
    for (const auto& [larger, other] : fits.all()) {
      if (!is_contained(fit.combination.variant, other.combination.variant)) continue;
      EXPECT_LE(fits.misfit(larger), fits.misfit(smaller)) << larger << " and " << smaller;
      EXPECT_GE(other.result.parameters.size(), fit.result.parameters.size());
    }
  }
}

TEST(SlowSheetModels, FitNoWorseThanTheVariantsThatTheyContainAndTellTheirCloth) {
  const ModelFits fits(
      anisotropic_cloth(), {"stvk"},
      {"nonlinear-orthotropic", "linear-orthotropic", "nonlinear-isotropic", "linear-isotropic"});
  expect_none_worse_than_what_it_contains(fits);
  expect_told_from_others(fits);
}

TEST(SlowSheetModels, OfSpringsFitNoWorseThanTheVariantsThatTheyContain) {
  expect_none_worse_than_what_it_contains(
      {anisotropic_cloth(), {"springs"}, {"linear-orthotropic", "linear-isotropic"}});
}

TEST(SlowSheetModels, OfSpringsAreWorstInBending) {
  const ModelFits fits(anisotropic_cloth(), {"soft-constraint", "stvk", "springs"},
                       {"linear-orthotropic"});
  for (const char* test : {"bend-weft", "bend-warp"}) {
    EXPECT_GT(fits.rms("springs.linear-orthotropic", test),
              10 * fits.rms("stvk.linear-orthotropic", test))
        << test;
    EXPECT_GT(fits.rms("springs.linear-orthotropic", test),
              10 * fits.rms("soft-constraint.linear-orthotropic", test))
        << test;
  }
  for (const ParameterEstimate& p : fits.all().at("springs.linear-orthotropic").result.parameters) {
    EXPECT_EQ(p.unit, p.owner.starts_with("bend") ? "N" : "N/m") << p.name;
  }
}

TEST(SheetStarts, AreKeptWhereNoSearchFindsBetter) {
  const Material truth = anisotropic_cloth();
  const test::FiveSheetTests tests(truth, "", 9, 3);
  Study study = tests.study();
  // A search for one component alone guesses the others.
  study.fit.plan = {{{"stretch.weft"}, {"stretch-weft"}, {}}};
  const StudyResult alone = fit_sheet_study(study, {});
  EXPECT_GT(misfit_percent(alone.experiments), 1);
  const StudyResult begun = fit_sheet_study(study, {}, {{"linear-isotropic", truth}});
  EXPECT_LT(misfit_percent(begun.experiments), 0.1);
  EXPECT_THAT(begun.assumptions, Contains(HasSubstr("linear-isotropic")));
  Material bad = truth;
  bad.components.at("stretch.warp").stiffness = ScalarCurve::hermite({0}, {1e5});
  const StudyResult apart = fit_sheet_study(study, {}, {{"linear-isotropic", bad}});
  EXPECT_EQ(misfit_percent(apart.experiments), misfit_percent(alone.experiments));
}

TEST(SheetStarts, SpringsNeedAGrid) {
  const Session session = [] {
    Session sheet = test::clamped_sheet("stretch-weft", 5, {{0}, {24}});
    sheet.rest.positions(0, 12) += 0.003;
    sheet.frames.resize(1);
    sheet.frames[0].poses.resize(2);
    test::measure(sheet, test::sheet_cloth(false));
    return sheet;
  }();
  const test::TemporaryFolder folder;
  write_session(folder.path() / "pull", session);
  const auto file = folder.write("study.yaml",
                                 "pliant: study/1\nname: s\nexperiments:\n"
                                 "  - {name: pull, type: session, data: pull}\n"
                                 "model: {mesh: measured, bending: spring}\n");
  try {
    fit_sheet_study(read_study(file), {});
    FAIL() << "springs were put on a mesh that is no grid";
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().line, 4);
    EXPECT_THAT(error.what(), HasSubstr("no grid of rectangles"));
  }
}

}  // namespace
}  // namespace pliant
