#include "pliant/report/model_fits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/report/model_fits_report.h"
#include "pliant/report/model_fits_verdict.h"

#include "report/sample_model_fits.h"

namespace pliant {
namespace {

using report::model_fits_verdict;
using report::ModelFits;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::SampleFit;
using testing::TemporaryFolder;
using testing::write_sample_model_fits;

ModelFits read(const std::vector<SampleFit>& fits) {
  const TemporaryFolder folder;
  write_sample_model_fits(folder.path(), fits);
  return report::read_model_fits(folder.path());
}

std::string report_of(const std::vector<SampleFit>& fits = testing::sample_fits()) {
  const TemporaryFolder folder;
  write_sample_model_fits(folder.path(), fits);
  return make_model_fits_report(folder.path());
}

TEST(ModelFits, AreReadWithThoseThatFailed) {
  const ModelFits fits = read(testing::sample_fits());
  ASSERT_EQ(fits.rows.size(), 4u);
  ASSERT_EQ(fits.sessions.size(), 2u);
  EXPECT_EQ(fits.sessions[0].unit, "N");
  EXPECT_TRUE(fits.sessions[1].validation);
  EXPECT_EQ(fits.rows[0].errors[0], 0.123);
  EXPECT_EQ(fits.rows[3].failure, "no grid");
  EXPECT_FALSE(fits.rows[3].errors[0].has_value());
}

TEST(ModelFits, NameTheFieldThatIsWrong) {
  const TemporaryFolder folder;
  testing::write_text(folder.path() / "summary.json",
                      R"({"pliant": "fits-of-models/1", "fits": [{"model": 3}]})");
  try {
    report::read_model_fits(folder.path());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("fits[0].model"));
  }
}

TEST(ModelFitsVerdict, NamesTheBest) {
  EXPECT_THAT(model_fits_verdict(read(testing::sample_fits())),
              HasSubstr("The fitted sessions are followed best by nonlinear orthotropic St. "
                        "Venant-Kirchhoff, with a misfit of 2.0 %; none of the others comes within "
                        "5 % of that."));
}

TEST(ModelFitsVerdict, NamesTheSimplestOfThoseThatAreAsGood) {
  EXPECT_THAT(model_fits_verdict(read({{"stvk", "nonlinear-orthotropic", 2.0, 10},
                                       {"stvk", "linear-isotropic", 2.05, 4}})),
              HasSubstr("linear isotropic St. Venant-Kirchhoff comes within 5 % of that. The "
                        "simplest of these is linear isotropic St. Venant-Kirchhoff, with 4 "
                        "parameters instead of 10."));
}

TEST(ModelFitsVerdict, SaysWhetherIsotropicVariantsFail) {
  EXPECT_THAT(model_fits_verdict(read(testing::sample_fits())),
              HasSubstr("Isotropic variants, which take weft and warp as one, leave 2.0 times the "
                        "misfit: they fail this cloth."));
  EXPECT_THAT(model_fits_verdict(
                  read({{"stvk", "linear-orthotropic", 2.0}, {"stvk", "linear-isotropic", 2.02}})),
              HasSubstr("Isotropic variants fit as well"));
}

TEST(ModelFitsVerdict, SaysWhatCurvesAreWorth) {
  EXPECT_THAT(model_fits_verdict(read({{"stvk", "nonlinear-isotropic", 2.0},
                                       {"springs", "nonlinear-isotropic", 2.0},
                                       {"stvk", "linear-isotropic", 2.4},
                                       {"springs", "linear-isotropic", 3.0}})),
              HasSubstr("do not change with strain, leave 1.2 to 1.5 times the misfit. "));
}

TEST(ModelFitsVerdict, SaysWhereAVariantIsWorseThanOneThatItContains) {
  EXPECT_THAT(model_fits_verdict(read(testing::sample_fits())),
              HasSubstr("No variant is worse than one that it contains."));
  EXPECT_THAT(model_fits_verdict(read(
                  {{"stvk", "nonlinear-orthotropic", 3.0}, {"stvk", "linear-orthotropic", 2.0}})),
              HasSubstr("worse are nonlinear orthotropic St. Venant-Kirchhoff than linear, "
                        "orthotropic ones."));
}

TEST(ModelFitsVerdict, NamesTheSessionThatFitsDifferMostIn) {
  EXPECT_THAT(model_fits_verdict(read({{"stvk", "linear-isotropic", 2.0, 4, 0.1},
                                       {"springs", "linear-isotropic", 2.0, 4, 0.3}})),
              HasSubstr("Of the fitted sessions pull differs most: from 0.100 N (linear isotropic "
                        "St. Venant-Kirchhoff) to 0.300 N (linear isotropic springs)."));
  EXPECT_THAT(model_fits_verdict(read({{"stvk", "linear-isotropic", 2.0, 4, 0.1},
                                       {"springs", "linear-isotropic", 2.0, 4, 0.14}})),
              Not(HasSubstr("differs most")));
}

TEST(ModelFitsVerdict, SaysWhatPredictsBest) {
  EXPECT_THAT(model_fits_verdict(read(testing::sample_fits())),
              HasSubstr("corner by nonlinear orthotropic springs (0.600 N)."));
}

TEST(ModelFitsVerdict, TellsOfFailuresAndSearchesThatStopped) {
  std::vector<SampleFit> fits = testing::sample_fits();
  fits[0].converged = false;
  EXPECT_THAT(model_fits_verdict(read(fits)),
              HasSubstr("1 of 4 fits failed. Not converged: nonlinear orthotropic St. "
                        "Venant-Kirchhoff."));
  EXPECT_EQ(model_fits_verdict(read({{"stvk", "linear-isotropic", {}}})), "No fit has a result.");
}

TEST(ModelFitsReport, HasTheTableOfTheThesisWithTheBestMarked) {
  const std::string html = report_of();
  EXPECT_THAT(html, HasSubstr("<td>nonlinear, orthotropic</td><td><a "
                              "href=\"stvk.nonlinear-orthotropic/report.html\">St. "
                              "Venant-Kirchhoff</a></td><td class=\"number\"><strong>0.123"
                              "</strong></td><td class=\"number\"><strong>2.00</strong></td>"
                              "<td class=\"number\">10</td><td class=\"number\">12</td>"));
  EXPECT_THAT(html, HasSubstr("<tr><td></td><td><a href=\"springs.nonlinear-orthotropic"));
  EXPECT_THAT(html, HasSubstr("Springs <em>failed</em>"));
  EXPECT_THAT(html, HasSubstr("<li>nonlinear isotropic springs: no grid</li>"));
}

TEST(ModelFitsReport, KeepsPredictedSessionsApart) {
  const std::string html = report_of();
  const std::size_t fitted = html.find("Fitted sessions"), other = html.find("were not fitted");
  ASSERT_NE(fitted, std::string::npos);
  ASSERT_NE(other, std::string::npos);
  EXPECT_EQ(html.substr(fitted, other - fitted).find("corner"), std::string::npos);
}

TEST(ModelFitsReport, EscapesWhatTheStudySays) {
  std::vector<SampleFit> fits = testing::sample_fits();
  fits[0].variant = "<b>";
  EXPECT_THAT(report_of(fits), Not(HasSubstr("<td><b>")));
}

}  // namespace
}  // namespace pliant
