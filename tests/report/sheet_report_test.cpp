#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/io/text_file.h"
#include "pliant/report/report.h"

#include "report/sample_results.h"
#include "report/sample_sheets.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::TemporaryFolder;

std::string sheet_report(bool evaluation = false) {
  const TemporaryFolder folder;
  testing::write_sample_sheets(folder.path(), evaluation);
  return make_report(folder.path());
}

TEST(SheetReport, HasTheResidualsOfTheThesisTables) {
  EXPECT_THAT(sheet_report(), HasSubstr("<td>as compared</td><td class=\"number\">0.0200 N</td>"
                                        "<td class=\"number\">2.00 mm</td>"));
  EXPECT_THAT(sheet_report(), HasSubstr("<td>free nodes</td><td class=\"number\">1.00 mm</td>"
                                        "<td class=\"number\">2.00 mm</td>"));
}

/// Makes strips of a tester of a sample's sessions.
void make_strip(const std::filesystem::path& results, const char* experiment) {
  for (const char* session : {"measured", "predicted"}) {
    const auto file = results / "sheets" / experiment / session / "session.yaml";
    std::string text = read_text_file(file);
    const std::size_t at = text.find("kind: sheet");
    ASSERT_NE(at, std::string::npos);
    testing::write_text(file, text.replace(at, 11, "kind: strip"));
  }
}

TEST(SheetReport, OfStripsNamesNoSessions) {
  EXPECT_THAT(sheet_report(), HasSubstr("which sessions tell the number"));
  const TemporaryFolder folder;
  testing::write_sample_sheets(folder.path());
  for (const char* experiment : {"stretch-weft", "bend-weft"})
    make_strip(folder.path(), experiment);
  const std::string html = make_report(folder.path());
  EXPECT_THAT(html, HasSubstr("which strips tell the number"));
  EXPECT_THAT(html, Not(HasSubstr("which sessions")));
}

TEST(SheetReport, DrawsNoVerticesOfAStripThatNobodySaw) {
  const TemporaryFolder folder;
  testing::write_sample_sheets(folder.path());
  make_strip(folder.path(), "stretch-weft");
  const std::string html = make_report(folder.path());
  EXPECT_THAT(html, Not(HasSubstr("Measured and predicted sheet of stretch-weft")));
  EXPECT_THAT(html, HasSubstr("Measured and predicted sheet of bend-weft"));
  EXPECT_THAT(html, HasSubstr("RMS error of the force 0.020 N"));
}

TEST(SheetReport, TellsTheErrorOfFoldsWhereverTheyAre) {
  for (const bool evaluation : {false, true}) {
    const std::string html = sheet_report(evaluation);
    EXPECT_THAT(html, HasSubstr("<td>folds</td><td class=\"number\">0.250 mm</td>"
                                "<td class=\"number\">0.0125 mm</td>"));
    EXPECT_THAT(html, HasSubstr("Folds: how far wrinkles differ in height"));
    EXPECT_THAT(html, HasSubstr("wherever they are, 0.25 mm"));
  }
}

TEST(SheetReport, OfResultsThatHaveNoErrorOfFoldsSaysNothingOfIt) {
  const TemporaryFolder folder;
  testing::write_sample_sheets(folder.path());
  const std::filesystem::path file = folder.path() / "fit.json";
  nlohmann::json fit = nlohmann::json::parse(read_text_file(file));
  for (auto& experiment : fit["experiments"]) experiment.erase("fold_height_error_mm");
  testing::write_text(file, fit.dump());
  const std::string html = make_report(folder.path());
  EXPECT_THAT(html, Not(HasSubstr("folds")));
  EXPECT_THAT(html, HasSubstr("<td>free nodes</td>"));
}

TEST(SheetReport, TellsStiffnessAtZeroAndAtTheEndOfTheRange) {
  EXPECT_THAT(sheet_report(),
              HasSubstr("<td>Weft stretch</td><td class=\"number\">80.0</td>"
                        "<td class=\"number\">1.0</td><td class=\"number\">480.0</td>"
                        "<td class=\"number\">5.0</td><td class=\"number\">50 %</td>"
                        "<td>N/m</td>"));
}

TEST(SheetReport, DoesNotTakeFixedStiffnessForUndetermined) {
  EXPECT_THAT(sheet_report(), HasSubstr("<tr><td>Warp bending</td><td class=\"number\">3.00</td>"
                                        "<td class=\"number\">fixed</td>"));
}

TEST(SheetReport, PutsUndeterminedStiffnessInBrackets) {
  EXPECT_THAT(sheet_report(), HasSubstr("<tr class=\"undetermined\"><td>Weft bending</td>"
                                        "<td class=\"number\">(6.0)</td>"));
}

TEST(SheetReport, TellsTheSearch) {
  EXPECT_THAT(sheet_report(),
              HasSubstr("Search: began twice; 3 stages, 2 of them kept; 100 equilibria; 12.0 s."));
}

TEST(SheetReport, TellsWhereTheTimeWent) {
  const std::string html = sheet_report();
  EXPECT_THAT(html, HasSubstr("Forward differences would have needed 340 equilibria instead of "
                              "100, 3.4 times as many. 220 Hessians were factorised."));
  EXPECT_THAT(html, HasSubstr("<td>Derivatives</td><td class=\"number\">3.00</td>"
                              "<td class=\"number\">25 %</td>"));
  EXPECT_THAT(sheet_report(/*evaluation=*/true), Not(HasSubstr("Where the time went")));
}

TEST(SheetReport, TellsFrictionOfClothAndCordsInWords) {
  const std::string html = sheet_report();
  EXPECT_THAT(html, HasSubstr("<td>Weft stretch</td><td class=\"number\">2.00 ± 0.10</td>"
                              "<td class=\"number\">5.00 ± 0.50</td>"
                              "<td class=\"number\">0.80 ± 0.10</td>"));
  EXPECT_THAT(html, HasSubstr("was estimated along: stretch-weft 0.10 to 0.15 N."));
  EXPECT_THAT(html, HasSubstr("Pulleys hold cords back"));
  EXPECT_THAT(html, HasSubstr("goes a loop, too, by the friction of the cloth and of the cords."));
}

TEST(SheetReport, DrawsACycleWhereACurveHasFriction) {
  EXPECT_THAT(sheet_report(),
              HasSubstr("are shown in one cycle from rest to the largest strain and back"));
}

TEST(SheetReport, SaysNothingOfFrictionThatWasNotFitted) {
  EXPECT_THAT(sheet_report(), Not(HasSubstr("friction of bend.weft")));
  EXPECT_THAT(sheet_report(/*evaluation=*/true), Not(HasSubstr("Friction of the cloth")));
}

TEST(SheetReport, HasPicturesForReadersWithoutScript) {
  EXPECT_THAT(sheet_report(),
              HasSubstr("<div class=\"sheet-view\" id=\"view-1\" role=\"group\" "
                        "aria-label=\"Measured and predicted sheet of stretch-weft\">"
                        "<svg class=\"sheet-picture\""));
}

TEST(SheetReport, CountsElementsOfTheFittedSheetsUnderACurve) {
  EXPECT_THAT(sheet_report(), HasSubstr("elements of sheets"));
}

TEST(SheetReport, OfAnEvaluationHasNoStiffnesses) {
  const std::string html = sheet_report(/*evaluation=*/true);
  EXPECT_THAT(html, Not(HasSubstr("<h2>Stiffness</h2>")));
  EXPECT_THAT(html, Not(HasSubstr("fitted</small>")));
}

TEST(SheetReport, OthersHaveNoViews) {
  const TemporaryFolder folder;
  testing::write_sample_results(folder.path(), {});
  EXPECT_THAT(make_report(folder.path()), Not(HasSubstr("id=\"sheet-views\"")));
}

}  // namespace
}  // namespace pliant
