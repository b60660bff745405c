#include "pliant/report/model_fits_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/temporary_folder.h"
#include "support/compared_models.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string comparison_report(const std::vector<test::SampleFit>& fits = test::sample_fits()) {
  const test::TemporaryFolder folder;
  folder.write("summary.json", summary_json(test::sample_model_fits(fits)));
  return make_model_fits_report(folder.path());
}

TEST(ModelFitsReport, HasTheTableOfTheThesisWithTheBestMarked) {
  const std::string html = comparison_report();
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
  const std::string html = comparison_report();
  const std::size_t fitted = html.find("Fitted sessions"), other = html.find("were not fitted");
  ASSERT_NE(fitted, std::string::npos);
  ASSERT_NE(other, std::string::npos);
  EXPECT_EQ(html.substr(fitted, other - fitted).find("corner"), std::string::npos);
}

TEST(ModelFitsReport, EscapesWhatTheStudySays) {
  std::vector<test::SampleFit> fits = test::sample_fits();
  fits[0].variant = "<b>";
  EXPECT_THAT(comparison_report(fits), Not(HasSubstr("<td><b>")));
}

}  // namespace
}  // namespace pliant
