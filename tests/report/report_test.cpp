#include "pliant/report/report.h"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/report/embedded_bundle.h"

#include "report/sample_results.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::SampleOptions;
using testing::TemporaryFolder;
using testing::write_sample_results;

std::string report_of(const SampleOptions& options) {
  const TemporaryFolder folder;
  write_sample_results(folder.path(), options);
  return make_report(folder.path());
}

/// The report less the drawing script, whose text is another project's.
std::string own_text(std::string html) {
  const std::string_view script = embedded_report_script();
  const std::size_t begin = script.empty() ? std::string::npos : html.find(script);
  if (begin != std::string::npos) html.erase(begin, script.size());
  return html;
}

TEST(Report, OpensWithWhatTheFitJudges) {
  EXPECT_THAT(report_of({}),
              HasSubstr(std::string("<p class=\"verdict fit\"><strong>Fit for use within the range "
                                    "of the data.</strong> ") +
                        testing::kSampleDetails));
}

TEST(Report, OfAResultThatJudgesNothingHasNoVerdict) {
  const TemporaryFolder folder;
  write_sample_results(folder.path(), {});
  const auto file = folder.path() / "fit.json";
  auto fit = nlohmann::json::parse(std::ifstream(file));
  fit.erase("judgement");
  testing::write_text(file, fit.dump());
  EXPECT_THAT(make_report(folder.path()), Not(HasSubstr("<p class=\"verdict")));
}

TEST(Report, NamesNothingOutsideItself) {
  const std::string html = own_text(report_of({}));
  for (const char* reference : {"http:", "https:", " src=", " href=", "@import", "url("}) {
    EXPECT_THAT(html, Not(HasSubstr(reference)));
  }
}

TEST(Report, ForbidsRequestsByItsSecurityPolicy) {
  EXPECT_THAT(report_of({}), HasSubstr("content=\"default-src 'none';"));
}

TEST(Report, EscapesTextOfTheUser) {
  const std::string html = own_text(
      report_of({.name = "</title><script>alert(1)</script>", .warning = "<img src=x onerror=y>"}));
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(html, Not(HasSubstr("<img")));
  EXPECT_THAT(html, HasSubstr("&lt;img src=x onerror=y&gt;"));
}

TEST(Report, ShowsNoUncertaintyForAParameterThatIsNotDetermined) {
  EXPECT_THAT(
      report_of({}),
      HasSubstr("<code>stretch.bias.friction.a</code><small>friction at zero strain</small>"
                "</td><td class=\"number\">(1.4)</td><td class=\"number\">–</td>"
                "<td class=\"number\">–</td><td class=\"unit\">N/m</td><td class=\"number\">–</td>"
                "<td>not determined</td>"));
}

TEST(Report, DrawsNoFrictionThatIsNotDetermined) {
  EXPECT_THAT(report_of({}),
              AllOf(HasSubstr("Its friction is not determined by the data and not drawn."),
                    Not(HasSubstr("not each number of it"))));
}

TEST(Report, SaysWhenDataNeverUnload) {
  EXPECT_THAT(report_of({.loading_only_bias = true}),
              HasSubstr("<li>friction of stretch.bias: its data never unload</li>"));
}

TEST(Report, OfAnEvaluationHasNoCorrelationsAndPredictsEverything) {
  const std::string html = report_of({.evaluation = true});
  EXPECT_THAT(html, HasSubstr("jersey.json"));
  EXPECT_THAT(html, Not(HasSubstr("Correlations of the estimates")));
  EXPECT_THAT(html, Not(HasSubstr("<td>fitted</td>")));
}

/// The first page, up to the place for a signature.
std::string page_one_of(const SampleOptions& options) {
  const std::string html = own_text(report_of(options));
  return html.substr(0, html.find("class=\"signature\""));
}

TEST(Report, AsksOnPageOneInFullWhatIsHardlyRight) {
  const std::string question =
      "warp-stretch-8cm: the strain reaches 8000 %: is `extension` in mm, not m, or is `length` 20 "
      "m, not 200 mm, or is `length` 200 m, not 200 mm? (fabrics: 0.05 % to 400 %)";
  EXPECT_THAT(page_one_of({}), Not(HasSubstr("Is the data right?")));
  const std::string page = page_one_of({.question = question});
  EXPECT_THAT(page, HasSubstr("<h2>Is the data right?</h2>"));
  const std::size_t first = page.find(question);
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(page.find(question, first + 1), std::string::npos) << "once";
}

TEST(Report, SaysOnPageOneOfEachLimitWhetherItIsKept) {
  const TemporaryFolder folder;
  write_sample_results(folder.path(), {});
  const auto file = folder.path() / "fit.json";
  auto fit = nlohmann::json::parse(std::ifstream(file));
  fit["judgement"] = {{"fitness", "fit"},
                      {"headline", "Fit for use within the range of the data."},
                      {"experiments", nlohmann::json::array()},
                      {"criteria",
                       {{{"text", "RMS error 1.8 % (warp; limit 3 %): pass"}},
                        {{"text", "error of the span 5 % (weft; limit 2 %): fail"}}}}};
  testing::write_text(file, fit.dump());
  EXPECT_THAT(make_report(folder.path()),
              HasSubstr("<p>Acceptance: RMS error 1.8 % (warp; limit 3 %): pass; error of the span "
                        "5 % (weft; limit 2 %): fail.</p>"));
}

TEST(Report, HasTheDigestsOfTheDataOnPageOne) {
  const TemporaryFolder folder;
  write_sample_results(folder.path(), {});
  const auto file = folder.path() / "fit.json";
  auto fit = nlohmann::json::parse(std::ifstream(file));
  fit["data"] = {{{"experiment", "warp"}, {"file", "a.csv"}, {"sha256", "0123456789abcdef0123"}}};
  testing::write_text(file, fit.dump());
  const std::string html = make_report(folder.path());
  EXPECT_THAT(html.substr(0, html.find("<section id=\"experiments\"")),
              HasSubstr("SHA-256 of the data: a.csv 0123456789ab…"));
}

TEST(Report, OfAnEvaluationNamesOnPageOneWhatWasNotPredicted) {
  EXPECT_THAT(page_one_of({.evaluation = true, .skipped = "frame-shear"}),
              HasSubstr("frame-shear: the material has no shear"));
}

TEST(Report, SaysEachWarningOnce) {
  for (const std::string warning : {"w1", "the clamps slipped by 0.4 mm in row 212"}) {
    const std::string html = own_text(report_of({.warning = warning}));
    const std::size_t first = html.find("<li>" + warning);
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(html.find("<li>" + warning, first + 1), std::string::npos);
  }
}

TEST(Report, HasExtensionAndNoStrainAloneOfStretch) {
  const std::string html = own_text(report_of({}));
  EXPECT_THAT(html, HasSubstr("extension 0 to 30 % (Green strain 0 to 35 %)"));
  EXPECT_THAT(html, HasSubstr("Measured minus material, against extension"));
  EXPECT_THAT(html, HasSubstr("\"text\":\"Extension (%)\""));
  EXPECT_THAT(html, Not(HasSubstr("\"text\":\"Strain (%)\"")));
}

TEST(Report, ShowsTheStrainOverWhichFrictionBuildsUpInPercentWithItsExtension) {
  EXPECT_THAT(report_of({}), HasSubstr("<td class=\"unit\">%</td><td class=\"number\">–</td>"
                                       "<td>Green strain; 1.2 % extension</td>"));
}

TEST(Report, SaysWhyGrowthEnded) {
  const std::string html = report_of({});
  const std::size_t last = html.find("4 control points");
  ASSERT_NE(last, std::string::npos);
  EXPECT_THAT(html.substr(last, html.find("</tr>", last) - last),
              HasSubstr("more is not worth it"));
}

TEST(Report, SaysHowManyPointsItDraws) {
  EXPECT_THAT(report_of({.rows = 4'000, .rich = false}), HasSubstr(" of 4000 points drawn)"));
}

TEST(Report, RefusesAFolderWithoutResults) {
  const TemporaryFolder folder;
  EXPECT_THROW(make_report(folder.path()), InputError);
}

TEST(SlowReport, StaysLightOnLongMeasurements) {
  const std::string html = report_of({.rows = 100'000, .rich = false});
  EXPECT_LT(html.size(), 5u << 20);  // what a mail server takes and a browser opens at once
}

}  // namespace
}  // namespace pliant
