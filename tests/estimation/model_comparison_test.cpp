#include "pliant/estimation/model_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/compared_models.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ModelComparisonVerdict, NamesTheBest) {
  EXPECT_THAT(verdict(test::compared(test::sample_fits())),
              HasSubstr("The fitted sessions are followed best by nonlinear orthotropic St. "
                        "Venant-Kirchhoff, with a misfit of 2 %; none of the others comes within "
                        "5 % of that."));
}

TEST(ModelComparisonVerdict, NamesTheSimplestOfThoseThatAreAsGood) {
  EXPECT_THAT(verdict(test::compared({{"stvk", "nonlinear-orthotropic", 2.0, 10},
                                      {"stvk", "linear-isotropic", 2.05, 4}})),
              HasSubstr("linear isotropic St. Venant-Kirchhoff comes within 5 % of that. The "
                        "simplest of these is linear isotropic St. Venant-Kirchhoff, with 4 "
                        "parameters instead of 10."));
}

TEST(ModelComparisonVerdict, SaysWhetherIsotropicVariantsFail) {
  EXPECT_THAT(verdict(test::compared(test::sample_fits())),
              HasSubstr("Isotropic variants, which take weft and warp as one, leave 2 times the "
                        "misfit: they fail this cloth."));
  EXPECT_THAT(verdict(test::compared(
                  {{"stvk", "linear-orthotropic", 2.0}, {"stvk", "linear-isotropic", 2.02}})),
              HasSubstr("Isotropic variants fit as well"));
}

TEST(ModelComparisonVerdict, SaysWhatCurvesAreWorth) {
  EXPECT_THAT(verdict(test::compared({{"stvk", "nonlinear-isotropic", 2.0},
                                      {"springs", "nonlinear-isotropic", 2.0},
                                      {"stvk", "linear-isotropic", 2.4},
                                      {"springs", "linear-isotropic", 3.0}})),
              HasSubstr("do not change with strain, leave 1.2 to 1.5 times the misfit. "));
}

TEST(ModelComparisonVerdict, SaysWhereAVariantIsWorseThanOneThatItContains) {
  EXPECT_THAT(verdict(test::compared(test::sample_fits())),
              HasSubstr("No variant is worse than one that it contains."));
  EXPECT_THAT(verdict(test::compared(
                  {{"stvk", "nonlinear-orthotropic", 3.0}, {"stvk", "linear-orthotropic", 2.0}})),
              HasSubstr("worse are nonlinear orthotropic St. Venant-Kirchhoff than linear, "
                        "orthotropic ones."));
}

TEST(ModelComparisonVerdict, NamesTheSessionThatFitsDifferMostIn) {
  EXPECT_THAT(verdict(test::compared({{"stvk", "linear-isotropic", 2.0, 4, 0.1},
                                      {"springs", "linear-isotropic", 2.0, 4, 0.3}})),
              HasSubstr("Of the fitted sessions pull differs most: from 0.1 N (linear isotropic "
                        "St. Venant-Kirchhoff) to 0.3 N (linear isotropic springs)."));
  EXPECT_THAT(verdict(test::compared({{"stvk", "linear-isotropic", 2.0, 4, 0.1},
                                      {"springs", "linear-isotropic", 2.0, 4, 0.14}})),
              Not(HasSubstr("differs most")));
}

TEST(ModelComparisonVerdict, SaysWhatPredictsBest) {
  EXPECT_THAT(verdict(test::compared(test::sample_fits())),
              HasSubstr("corner by nonlinear orthotropic springs (0.6 N)."));
}

TEST(ModelComparisonVerdict, TellsOfFailuresAndSearchesThatStopped) {
  std::vector<test::SampleFit> fits = test::sample_fits();
  fits[0].converged = false;
  EXPECT_THAT(verdict(test::compared(fits)),
              HasSubstr("1 of 4 fits failed. Not converged: nonlinear orthotropic St. "
                        "Venant-Kirchhoff."));
  EXPECT_EQ(verdict(test::compared({{"stvk", "linear-isotropic", {}}})), "No fit has a result.");
}

}  // namespace
}  // namespace pliant
