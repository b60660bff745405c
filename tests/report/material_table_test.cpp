#include "pliant/report/material_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

ResultFigure figure(const std::string& component, const std::string& name, const std::string& unit,
                    double value, double error, std::optional<double> at = {}) {
  return {component, name, unit, value, at, error, value - 2 * error, value + 2 * error};
}

ResultExperiment experiment(const std::string& component, double end) {
  ResultExperiment e;
  e.component = component;
  e.strain_range = {{0, end}};
  e.unloads = true;
  return e;
}

Results stretched() {
  Results results;
  results.membrane = MembraneMeasure::stvk;
  results.figures = {figure("stretch.warp", "stiffness_at_rest", "N/m", 54.24, 9.05),
                     figure("stretch.warp", "secant_modulus", "N/m", 130.04, 6.04, 0.1),
                     figure("stretch.warp", "secant_modulus", "N/m", 154.41, 3.03, 0.2),
                     figure("stretch.warp", "loop_width", "N/m", 9.344, 0.292, 0.1)};
  results.experiments = {experiment("stretch.warp", 0.22)};
  return results;
}

Results bent() {
  Results results;
  results.figures = {figure("bend.warp", "rigidity_at_rest", "N m", 9.003e-6, 1.1e-8),
                     figure("bend.warp", "kes_B", "N m", 9.003e-6, 1.1e-8),
                     figure("bend.warp", "kes_2HB", "N", 6.405e-4, 1.67e-6),
                     figure("bend.warp", "bending_length", "m", 0.02185, 6.2e-5)};
  results.experiments = {experiment("bend.warp", 750)};
  return results;
}

TEST(MaterialTable, HasStiffnessAndFrictionWithTheirErrorsRoundedAlike) {
  EXPECT_THAT(material_table(stretched()),
              HasSubstr("<td>Warp stretch</td><td class=\"number\">54.2 ± 9.1</td>"
                        "<td class=\"number\">130.0 ± 6.0 at 10 %</td>"
                        "<td class=\"number\">154.4 ± 3.0 at 20 %</td>"
                        "<td class=\"number\">9.34 ± 0.29 at 10 %</td>"));
}

TEST(MaterialTable, HasExtensionBesideGreenStrain) {
  EXPECT_THAT(material_table(stretched()),
              HasSubstr("<td class=\"unit\">0 to 20 %</td><td class=\"unit\">0 to 22 %</td>"));
}

TEST(MaterialTable, CountsBendingInTheUnitsOfALaboratory) {
  const std::string html = material_table(bent());
  EXPECT_THAT(html, HasSubstr("B<small>µN m</small>"));
  EXPECT_THAT(html, HasSubstr("2HB<small>mN</small>"));
  EXPECT_THAT(html, HasSubstr("<td class=\"number\">9.003 ± 0.011</td>"
                              "<td class=\"number\">0.6405 ± 0.0017</td>"
                              "<td class=\"number\">21.850 ± 0.062</td>"
                              "<td class=\"unit\">0 to 250 1/m</td>"));
}

TEST(MaterialTable, PutsInBracketsWhatIsNotDetermined) {
  Results results = stretched();
  results.figures[0].lower = -1;
  results.figures[1].std_error = results.figures[1].lower = results.figures[1].upper = {};
  const std::string html = material_table(results);
  EXPECT_THAT(html, HasSubstr("<td class=\"number\">(54)</td><td class=\"number\">(130)"));
}

TEST(MaterialTable, SaysThatFrictionIsNotDeterminedByDataThatNeverUnload) {
  Results results = stretched();
  results.figures.pop_back();
  results.judgement.undetermined = {"friction of stretch.warp: its data never unload"};
  EXPECT_THAT(material_table(results), HasSubstr("<td class=\"number\">not determined</td>"));
}

TEST(MaterialTable, MarksWhatIsReadBeyondTheData) {
  Results results = bent();
  EXPECT_THAT(material_table(results), Not(HasSubstr("*")));
  results.figures[1].beyond_range = true;
  EXPECT_THAT(material_table(results), HasSubstr("9.003 ± 0.011*"));
  EXPECT_THAT(material_table(results), HasSubstr("* read off the law where there are no data"));
}

TEST(MaterialTable, OfAnEvaluationHasNoErrorsAndSaysWhereTheyAre) {
  Results results = stretched();
  results.evaluation = true;
  for (ResultFigure& one : results.figures) one.std_error = one.lower = one.upper = {};
  const std::string html = material_table(results);
  EXPECT_THAT(html, HasSubstr("<td class=\"number\">54.2</td><td class=\"number\">130 at 10 %"));
  EXPECT_THAT(html, HasSubstr("its errors stand in the report of its fit"));
}

}  // namespace
}  // namespace pliant::report
