#include "pliant/report/simulation_report.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/io/base64.h"
#include "pliant/report/embedded_bundle.h"
#include "pliant/report/energy_figure.h"

#include "report/sample_results.h"
#include "report/sample_simulation.h"

namespace pliant {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::SampleSimulation;
using testing::TemporaryFolder;
using testing::write_sample_simulation;
using testing::write_text;

std::string report_of(const SampleSimulation& sample, const SimulationPictures& pictures = {}) {
  const TemporaryFolder folder;
  write_sample_simulation(folder.path(), sample);
  return make_simulation_report(folder.path(), pictures);
}

/// The report less the drawing script, whose text is another project's.
std::string own_text(std::string html) {
  const std::string_view script = embedded_report_script();
  const std::size_t begin = script.empty() ? std::string::npos : html.find(script);
  if (begin != std::string::npos) html.erase(begin, script.size());
  return html;
}

TEST(SimulationReport, OpensWithWhatWasDone) {
  EXPECT_THAT(report_of({}), HasSubstr("Finished: 40 steps of 5 ms for 4800 triangles, 12.5 ms of "
                                       "computing time a step (median)."));
}

TEST(SimulationReport, SaysWhereAnUnfinishedSimulationStopped) {
  const std::string html = report_of({.finished = false});
  EXPECT_THAT(html, HasSubstr("Not finished: 40 steps of 5 ms"));
  EXPECT_THAT(html, HasSubstr("It stopped at 200 ms; `pliant simulate --resume` goes on"));
}

TEST(SimulationReport, HoldsItsFactsItsStepsAndItsWarnings) {
  const std::string html = report_of({.warning = "bend.warp of cotton was not measured"});
  EXPECT_THAT(html, HasSubstr("<dt>Scene</dt><dd>curtain.yaml</dd>"));
  EXPECT_THAT(html, HasSubstr("<dt>Memory</dt><dd>96 MB</dd>"));
  EXPECT_THAT(html, HasSubstr("<td>Newton iterations</td><td class=\"number\">1</td>"
                              "<td class=\"number\">3</td><td class=\"number\">3.25</td>"));
  EXPECT_THAT(html, HasSubstr("<li>bend.warp of cotton was not measured</li>"));
}

TEST(SimulationReport, SaysInItsHeadlineWhatIsNotModelledAndWhatBecameOfIt) {
  EXPECT_THAT(report_of({}), HasSubstr("(median). Not modelled: contact, drag of the air.</p>"));
  EXPECT_THAT(report_of({.crossing_pairs = "0"}),
              HasSubstr("drag of the air. At the end no triangles pass through each other.</p>"));
  EXPECT_THAT(report_of({.crossing_pairs = "1"}),
              HasSubstr("At the end 1 pair of triangles pass through each other.</p>"));
  EXPECT_THAT(report_of({.finished = false, .crossing_pairs = "40"}),
              HasSubstr("At the last step 40 pairs of triangles pass through each other.</p>"));
}

TEST(SimulationReport, ShowsItsPicturesBeforeFactsAndWarnings) {
  const std::string html = own_text(report_of({.warning = "careful"}, {"png", {}, ""}));
  const std::size_t picture = html.find("<img class"), warnings = html.find("<h2>Warnings</h2>");
  EXPECT_LT(html.find("class=\"verdict\""), picture);
  EXPECT_LT(picture, html.find("<dt>Scene</dt>"));
  EXPECT_LT(html.find("<dt>Scene</dt>"), warnings);
  EXPECT_LT(warnings, html.size());
}

TEST(SimulationReport, ListsLossesBesideTheEnergies) {
  EXPECT_THAT(report_of({}), HasSubstr("<td>kinetic</td><td class=\"number\">95 mJ</td>"));
  EXPECT_THAT(report_of({}), HasSubstr("<td>lost to friction and damping</td>"
                                       "<td class=\"number\">0.19 J</td>"));
  EXPECT_THAT(own_text(report_of({})), Not(HasSubstr("lost to the air")));
  const std::string html = report_of({.drag = 0.0625});
  EXPECT_THAT(html, HasSubstr("<td>lost to friction and damping</td>"
                              "<td class=\"number\">0.128 J</td>"));
  EXPECT_THAT(html, HasSubstr("<td>lost to the air</td><td class=\"number\">62.5 mJ</td>"));
}

TEST(SimulationReport, StatesTheMethod) {
  EXPECT_THAT(report_of({}), HasSubstr("<dt>Method</dt><dd>BDF2, converged to 10 uN, "
                                       "variational friction</dd>"));
  EXPECT_THAT(
      report_of(
          {.method = R"({"kind": "dynamic", "integrator": "backward-euler", "solve": "linearized",
 "tolerance": null, "linear_tolerance": 1e-4, "adaptive": true, "friction": "none"})"}),
      HasSubstr("<dd>backward Euler, one linear system a step, solved to 0.0001, no friction, "
                "steps halved where they fail</dd>"));
  EXPECT_THAT(
      report_of({.method = R"({"kind": "quasi-static", "integrator": null, "solve": "converged",
 "tolerance": 2e-6, "linear_tolerance": null, "adaptive": true, "friction": "linearized"})"}),
      HasSubstr("<dd>path of equilibria, converged to 2 uN, linearized friction, "
                "steps halved where they fail</dd>"));
}

TEST(SimulationReport, TellsWhatTheTimeOfAStepGoesTo) {
  const std::string html = report_of({});
  EXPECT_THAT(html, HasSubstr("forces and Hessians"));
  EXPECT_THAT(html, HasSubstr("search for what is near"));
  EXPECT_THAT(html, HasSubstr("how far vertices may go"));
}

TEST(SimulationReport, TellsThatStepsWereHalved) {
  EXPECT_THAT(report_of({.most_substeps = 4}),
              HasSubstr("<td>Parts that a step was taken in</td><td class=\"number\">1</td>"));
  EXPECT_THAT(report_of({}), Not(HasSubstr("Parts that a step")));
}

TEST(SimulationReport, TellsHowMuchTouches) {
  EXPECT_THAT(report_of({.contacts = R"({"min": 0, "median": 140, "mean": 182.5, "max": 651})"}),
              HasSubstr("<td>Vertices and pairs that touch at its end</td>"
                        "<td class=\"number\">0</td><td class=\"number\">140</td>"));
  EXPECT_THAT(report_of({}), Not(HasSubstr("that touch at its end")));
}

TEST(SimulationReport, TellsHowNearThingsCameAndHowManyWaysWereTested) {
  const std::string html = report_of(
      {.contact_distance = R"({"min": 2e-4, "median": 4.5e-4, "mean": 5e-4, "max": 9e-4})",
       .way_tests = R"({"min": 0, "median": 5120, "mean": 6000, "max": 9000})"});
  EXPECT_THAT(html, HasSubstr("<td>Least contact distance at its end</td>"
                              "<td class=\"number\">0.2 mm</td>"));
  EXPECT_THAT(html, HasSubstr("<td>Ways tested for what is met on them</td>"
                              "<td class=\"number\">0</td><td class=\"number\">5120</td>"));
  EXPECT_THAT(report_of({}), Not(HasSubstr("Ways tested")));
}

TEST(SimulationReport, LeavesOutWhatIsNotThere) {
  const std::string html =
      own_text(report_of({.energy = false, .statistics = false, .method = "null"}));
  EXPECT_THAT(html, Not(HasSubstr("<h2>Energy</h2>")));
  EXPECT_THAT(html, Not(HasSubstr("<h2>Steps</h2>")));
  EXPECT_THAT(html, Not(HasSubstr("<h2>Warnings</h2>")));
  EXPECT_THAT(html, Not(HasSubstr("<dt>Method</dt>")));
  EXPECT_THAT(html, Not(HasSubstr("<img")));
}

TEST(SimulationReport, CarriesItsPictures) {
  const std::string html = report_of({}, {"motion as png", {{"strain.shear", "shear as png"}}, ""});
  for (const char* png : {"motion as png", "shear as png"}) {
    EXPECT_THAT(html, HasSubstr("src=\"data:image/png;base64," + base64(png) + "\""));
  }
  EXPECT_THAT(html, HasSubstr("alt=\"strain.shear\""));
}

TEST(SimulationReport, SaysWhyItHasNoPictures) {
  EXPECT_THAT(report_of({}, {"", {}, "This program cannot draw."}),
              HasSubstr("<p class=\"note\">This program cannot draw.</p>"));
}

TEST(SimulationReport, NamesNothingOutsideItselfAndEscapesTextOfTheUser) {
  const std::string html = own_text(
      report_of({.name = "</title><script>alert(1)</script>", .warning = "<img src=x onerror=y>"}));
  for (const char* reference :
       {"http:", "https:", "<img", " href=", "@import", "url(", "<script>alert"}) {
    EXPECT_THAT(html, Not(HasSubstr(reference)));
  }
  EXPECT_THAT(html, HasSubstr("content=\"default-src 'none';"));
}

TEST(SimulationReport, RefusesResultsThatAreDamaged) {
  const TemporaryFolder folder;
  EXPECT_THROW(make_simulation_report(folder.path(), {}), InputError);
  write_sample_simulation(folder.path());
  std::filesystem::remove(folder.path() / "energy.csv");
  EXPECT_THROW(make_simulation_report(folder.path(), {}), InputError);
  for (const char* json : {"{", R"({"pliant": "fit/1"})", R"({"pliant": "simulation/2"})",
                           R"({"pliant": "simulation/1", "energy": "../energy.csv"})",
                           R"({"pliant": "simulation/1", "steps": "many"})"}) {
    write_text(folder.path() / "simulation.json", json);
    EXPECT_THROW(make_simulation_report(folder.path(), {}), InputError) << json;
  }
}

std::vector<double> values_of(const report::EnergyFigure& energy, std::size_t series) {
  return energy.figure.traces.at(series).at("y").get<std::vector<double>>();
}

TEST(EnergyFigure, DrawsStoredAndTotalEnergyFromTheFirstFrameOn) {
  const auto energy = report::energy_figure(
      {}, {{.time = 0, .stored = 7}, {0.1, 0.25, 6.5, 0.125}, {0.2, 0.125, 6.25, 0.375}});
  ASSERT_EQ(energy.legend.size(), 4u);
  EXPECT_THAT(values_of(energy, 0), ElementsAre(0, 0.25, 0.125));
  EXPECT_THAT(values_of(energy, 1), ElementsAre(0, -0.5, -0.75));
  EXPECT_THAT(values_of(energy, 2), ElementsAre(0, 0.125, 0.375));
  EXPECT_THAT(values_of(energy, 3), ElementsAre(0, -0.125, -0.25));
}

TEST(EnergyFigure, OfAPathOfEquilibriaHasNoKineticEnergy) {
  const auto energy = report::energy_figure({}, {{0, 0, 1}, {1, 0, 2, 0.5}});
  EXPECT_EQ(energy.legend.size(), 3u);
}

TEST(EnergyFigure, DrawsTheWorkOfWhatIsMoved) {
  const auto energy =
      report::energy_figure({}, {{0, 0, 1}, {.time = 1, .kinetic = 2, .stored = 2, .outside = 4}});
  ASSERT_EQ(energy.legend.size(), 5u);
  EXPECT_THAT(values_of(energy, 3), ElementsAre(0, 4));
}

TEST(EnergyFigure, KeepsPeaksOfALongSimulation) {
  std::vector<EnergyRow> rows;
  for (int i = 0; i < 50'000; ++i) rows.push_back({0.001 * i, i == 31'415 ? 9 : 0.5});
  const auto kinetic = values_of(report::energy_figure({}, rows), 0);
  EXPECT_LT(kinetic.size(), 5'000u);
  EXPECT_THAT(kinetic, ::testing::Contains(9));
}

}  // namespace
}  // namespace pliant
