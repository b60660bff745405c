#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/io/text_file.h"
#include "pliant/report/embedded_bundle.h"
#include "pliant/report/model_fits_report.h"
#include "pliant/report/report.h"
#include "pliant/report/simulation_report.h"

#include "report/sample_capture.h"
#include "report/sample_results.h"
#include "report/sample_sheets.h"
#include "report/sample_simulation.h"
#include "support/compared_models.h"

namespace pliant {
namespace {

using nlohmann::json;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::SampleOptions;
using testing::TemporaryFolder;
using testing::write_sample_results;
using testing::write_sample_simulation;
using testing::write_text;

/// The first Chromium in PATH; empty when there is none.
std::string find_chromium() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
      const std::filesystem::path program = std::filesystem::path(folder) / name;
      if (std::filesystem::exists(program)) return program.string();
    }
  }
  return {};
}

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// A report in a headless browser.
class BrowserReport : public ::testing::Test {
 protected:
  void SetUp() override {
    chromium_ = find_chromium();
    if (chromium_.empty()) GTEST_SKIP() << "Chromium is not installed";
    if (embedded_report_script().empty()) GTEST_SKIP() << "this build has no drawing script";
  }

  std::string report(const SampleOptions& options = {}) const {
    const std::filesystem::path results = folder_.path() / "results";
    write_sample_results(results, options);
    return make_report(results);
  }

  /// The document as it stands after its scripts have run.
  std::string document_of(const std::string& html) const { return run(html, "--dump-dom"); }

  /// How many pages of A4 the document takes on paper.
  std::size_t printed_pages(const std::string& html) const {
    const std::filesystem::path pdf = folder_.path() / "report.pdf";
    run(html, "--no-pdf-header-footer --print-to-pdf='" + pdf.string() + "'");
    const std::string text = read_text_file(pdf);
    return count(text, "/Type /Page\n");
  }

 private:
  /// What the browser prints on standard output for a document.
  std::string run(const std::string& html, const std::string& action) const {
    const std::filesystem::path file = folder_.path() / "report.html";
    write_text(file, html);
    const std::string home = (folder_.path() / "home").string();
    const std::string command =
        "HOME='" + home + "' '" + chromium_ +
        "' --headless --no-sandbox --disable-gpu --enable-unsafe-swiftshader --disable-quic "
        "--no-first-run"
        " --disable-background-networking --disable-component-update --disable-sync"
        " --user-data-dir='" +
        home + "/profile' --virtual-time-budget=20000 " + action + " 'file://" + file.string() +
        "' 2>/dev/null";
    std::string document;
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return document;
    char buffer[65536];
    for (std::size_t n = 0; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) {
      document.append(buffer, n);
    }
    EXPECT_EQ(pclose(pipe), 0) << command;
    return document;
  }

  TemporaryFolder folder_;
  std::string chromium_;
};

/// The report less its script, in which the same words occur.
std::string without_script(std::string document) {
  const std::string_view script = embedded_report_script();
  const std::size_t begin = document.find("<script>\n");
  if (begin != std::string::npos) document.erase(begin, script.size());
  return document;
}

TEST_F(BrowserReport, DrawsEveryFigureWithoutErrorOrRequest) {
  const std::string html = report();
  const std::size_t figures = count(html, "<div class=\"figure ");
  ASSERT_GT(figures, 20u);
  const std::string document = without_script(document_of(html));
  EXPECT_THAT(document, HasSubstr("data-ready=\"true\""));
  EXPECT_EQ(count(document, "data-drawn=\"true\""), figures);
  EXPECT_THAT(document, Not(HasSubstr("data-script-error")));
  EXPECT_THAT(document, Not(HasSubstr("data-violation")));
}

TEST_F(BrowserReport, OfAnEvaluationIsDrawnToo) {
  const std::string html = report({.evaluation = true});
  const std::string document = without_script(document_of(html));
  EXPECT_EQ(count(document, "data-drawn=\"true\""), count(html, "<div class=\"figure "));
  EXPECT_THAT(document, HasSubstr("data-ready=\"true\""));
}

/// The report with a script of the test's own, which runs once all figures are drawn.
std::string when_drawn(std::string html, const std::string& script) {
  html.insert(html.rfind("</body>"),
              "<script>const wait = setInterval(() => {"
              "if (document.documentElement.dataset.ready !== 'true') return;"
              "clearInterval(wait);" +
                  script + "}, 20);</script>");
  return html;
}

// A picture of one pixel: the policy lets data in.
TEST_F(BrowserReport, OfASimulationIsDrawnWithItsPictures) {
  const TemporaryFolder folder;
  write_sample_simulation(folder.path());
  const std::string_view pixel(
      "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\b\0\0\0\0:~\x9b"
      "U\0\0\0\nIDATx\x9c"
      "c`\0\0\0\2\0\1H\xaf\xa4q\0\0\0\0IEND\xae"
      "B`\x82",
      67);
  std::string html = make_simulation_report(folder.path(), {std::string(pixel), {}, ""});
  html = when_drawn(html, "document.body.dataset.width = document.images[0].naturalWidth;");
  const std::string document = without_script(document_of(html));
  EXPECT_EQ(count(document, "data-drawn=\"true\""), 1u);
  EXPECT_THAT(document, HasSubstr("data-width=\"1\""));
  EXPECT_THAT(document, Not(HasSubstr("data-script-error")));
  EXPECT_THAT(document, Not(HasSubstr("data-violation")));
}

TEST_F(BrowserReport, OfACaptureIsDrawnToo) {
  const std::string document = without_script(document_of(testing::sample_capture_report()));
  EXPECT_EQ(count(document, "data-drawn=\"true\""), 3u) << "what was seen, matches and balance";
  EXPECT_THAT(document, HasSubstr("data-ready=\"true\""));
  EXPECT_THAT(document, Not(HasSubstr("data-script-error")));
  EXPECT_THAT(document, Not(HasSubstr("data-violation")));
}

TEST_F(BrowserReport, OfSeveralModelsHasABarForEachFit) {
  const TemporaryFolder folder;
  write_text(folder.path() / "summary.json", summary_json(test::sample_model_fits()));
  const std::string html = when_drawn(make_model_fits_report(folder.path()), R"(
      const bars = [...document.querySelectorAll('#figure-1 .bars .point path')];
      document.body.dataset.bars = bars.filter((bar) => bar.getBoundingClientRect().height > 0).length;)");
  const std::string document = without_script(document_of(html));
  EXPECT_EQ(count(document, "data-drawn=\"true\""), 2u);
  EXPECT_THAT(document, HasSubstr("data-bars=\"3\"")) << "one of four has failed";
  EXPECT_THAT(document, Not(HasSubstr("data-script-error")));
  EXPECT_THAT(document, Not(HasSubstr("data-violation")));
}

TEST_F(BrowserReport, ShowsTheFrameOfASheetThatTheSliderChooses) {
  const TemporaryFolder folder;
  testing::write_sample_sheets(folder.path());
  const std::string html = when_drawn(make_report(folder.path()), R"(
      const slider = document.querySelector('#view-1 input[type=range]');
      if (slider === null) return;
      slider.value = 1;
      slider.dispatchEvent(new Event('input'));
      document.body.dataset.shown = document.querySelector('#view-1 .sheet-frame').textContent;)");
  const std::string document = without_script(document_of(html));
  EXPECT_THAT(document, HasSubstr("data-ready=\"true\""));
  EXPECT_THAT(document, Not(HasSubstr("data-script-error")));
  EXPECT_THAT(document, Not(HasSubstr("data-violation")));
  if (count(document, "data-drawn=\"picture\"") == 2) GTEST_SKIP() << "Chromium has no WebGL here";
  EXPECT_THAT(document,
              HasSubstr("data-shown=\"frame 2 of 5: RMS of free nodes 1 mm, largest 1 mm\""));
}

/// The report with a line in place of what follows its first page.
std::string page_one_and_a_line(std::string html) {
  const std::size_t begin = html.find("<section id=\"experiments\"");
  const std::size_t end = html.find("</main>");
  return html.replace(begin, end - begin, "<p>Page two</p>");
}

TEST_F(BrowserReport, HasAPageOneOfOnePage) {
  for (const bool rich : {false, true}) {
    for (const bool evaluation : {false, true}) {
      const std::string html = report({.evaluation = evaluation, .rich = rich});
      EXPECT_EQ(printed_pages(page_one_and_a_line(html)), 2U) << rich << evaluation;
    }
  }
}

TEST_F(BrowserReport, OfSheetsHasAPageOneOfOnePage) {
  for (const bool evaluation : {false, true}) {
    const testing::TemporaryFolder folder;
    testing::write_sample_sheets(folder.path(), evaluation);
    EXPECT_EQ(printed_pages(page_one_and_a_line(make_report(folder.path()))), 2U) << evaluation;
  }
}

// What a reader must find on page one without a search: the verdict, what is missed most, and a
// number of the material with its error.
TEST_F(BrowserReport, SaysOnPageOneWhatIsWorstTheVerdictAndAValueWithItsError) {
  const TemporaryFolder folder;
  write_sample_results(folder.path(), {.rich = true});
  json fit = json::parse(read_text_file(folder.path() / "fit.json"));
  const std::string worst = fit["experiments"].back()["name"];
  fit["judgement"] = {{"fitness", "unfit"},
                      {"headline", "Not fit for use. " + worst + ": missed."},
                      {"experiments", {{{"name", worst}, {"fitness", "unfit"}}}}};
  write_text(folder.path() / "fit.json", fit.dump());
  const std::string html = when_drawn(make_report(folder.path()), R"(
      const page = document.querySelector('.page-one');
      const table = (title) => [...page.querySelectorAll('section, div')]
          .filter((part) => part.querySelector('h2')?.textContent.startsWith(title)).pop();
      const verdict = page.querySelector('.verdict');
      document.body.dataset.verdict = verdict.className + '; ' + verdict.querySelector('strong').innerText;
      document.body.dataset.worst = table('Agreement').querySelector('td').innerText;
      document.body.dataset.value = [...table('Material').querySelectorAll('td')]
          .map((cell) => cell.innerText).find((text) => /^[0-9.]+ \u00b1 [0-9.]+/.test(text));)");
  const std::string document = without_script(document_of(html));
  EXPECT_THAT(document,
              HasSubstr("data-verdict=\"verdict unfit; Not fit for use. " + worst + ": missed.\""));
  EXPECT_THAT(document, HasSubstr("data-worst=\"" + worst + "\""));
  EXPECT_THAT(document, ContainsRegex("data-value=\"[0-9.]+ \u00b1 [0-9.]+"));
}

// U+0378 has no letter yet, so no font has it.
TEST_F(BrowserReport, NamesCharactersThatNoFontHas) {
  const std::string document = without_script(document_of(report({.name = "Jersey \u0378"})));
  EXPECT_THAT(document, HasSubstr("shows boxes for them: U+0378."));
}

TEST_F(BrowserReport, SaysNothingOfCharactersThatItsFontsHave) {
  const std::string document = without_script(document_of(report({.name = "Jersey é µ"})));
  EXPECT_THAT(document, Not(HasSubstr("missing-characters\"")));
}

/// The sample report of strips, looked at once for all of its tests.
class BrowserReportOfStrips : public BrowserReport {
 protected:
  const std::string& document() const {
    static const std::string document = without_script(document_of(when_drawn(report(), kLook)));
    return document;
  }

 private:
  static constexpr const char* kLook = R"(
      {
        const figure = document.getElementById('figure-1');
        const width = () => figure.querySelector('.main-svg').getBoundingClientRect().width;
        const before = width();
        window.dispatchEvent(new Event('beforeprint'));
        document.body.dataset.fits = width() === Number(figure.dataset.printWidth);
        window.dispatchEvent(new Event('afterprint'));
        document.body.dataset.restored = width() === before;
      }
      {
        const figures = [...document.querySelectorAll('#experiments .figure, #curves .figure')];
        const kept = figures.filter((f) => f.closest('.together')?.querySelector('h3'));
        const rules = [...document.styleSheets[0].cssRules].filter((r) => r instanceof CSSMediaRule);
        const print = rules.find((r) => r.media.mediaText === 'print');
        const avoids = [...print.cssRules].find((r) => r.selectorText?.includes('.together'));
        document.body.dataset.loose = figures.length - kept.length;
        document.body.dataset.avoids = avoids?.style.breakInside;
      }
      {
        const figures = [...document.querySelectorAll('.page-one .figure')];
        const box = (element) => element.getBoundingClientRect();
        const page = box(document.querySelector('.page-one'));
        document.body.dataset.left = Math.min(...figures.map((f) => box(f).left)) - page.left;
        document.body.dataset.right = page.right - Math.max(...figures.map((f) => box(f).right));
        document.body.dataset.beside = box(figures[0]).top === box(figures[1]).top;
      }
      {
        const traces = document.querySelectorAll('#figure-1 .scatterlayer .trace');
        const kinds = [...traces].map((t) => t.querySelector('.js-line') ? 'line' : 'marker');
        document.body.dataset.order = kinds.join();
      }
      {
        const titles = [...document.querySelectorAll('#curves .figure .infolayer text')];
        document.body.dataset.titles = titles.slice(0, 4).map((t) => t.textContent).join('|');
      }
      {
        const entry = document.querySelector('button.legend-entry[data-group=measured-load]');
        entry.click();
        const figure = document.getElementById('figure-1');
        const hidden = figure.data.filter((trace) => trace.visible === false);
        document.body.dataset.hidden = hidden.map((trace) => trace.legendgroup).join();
      })";
};

TEST_F(BrowserReportOfStrips, TakesThePrintedSizeOnPaperAndGivesItUpAfterwards) {
  EXPECT_THAT(document(), HasSubstr("data-fits=\"true\""));
  EXPECT_THAT(document(), HasSubstr("data-restored=\"true\""));
}

// The style sheet keeps `.together` on one page of paper.
TEST_F(BrowserReportOfStrips, KeepsHeadingsWithTheirFiguresOnPaper) {
  EXPECT_THAT(document(), HasSubstr("data-loose=\"0\""));
  EXPECT_THAT(document(), HasSubstr("data-avoids=\"avoid\""));
}

TEST_F(BrowserReportOfStrips, FillsTheWidthOfPageOneWithItsLoops) {
  EXPECT_THAT(document(), HasSubstr("data-left=\"0\""));
  EXPECT_THAT(document(), HasSubstr("data-right=\"0\""));
  EXPECT_THAT(document(), HasSubstr("data-beside=\"true\"")) << "validation beside the fit";
}

TEST_F(BrowserReportOfStrips, DrawsTheMarkersOfPageOneAboveItsLines) {
  EXPECT_THAT(document(), HasSubstr("data-order=\"line,line,marker,marker\""));
}

TEST_F(BrowserReportOfStrips, HasGreenStrainAboveACurveAndExtensionBelowIt) {
  EXPECT_THAT(document(), HasSubstr("Extension (%)|"));
  EXPECT_THAT(document(), HasSubstr("Green strain (%)"));
}

TEST_F(BrowserReportOfStrips, ALegendEntryHidesItsSeries) {
  EXPECT_THAT(document(), HasSubstr("data-hidden=\"measured-load\""));
}

/// Shows that the check above would see a request: the policy stops it and marks the document.
TEST_F(BrowserReport, MarksARequestThatWouldLeaveTheFile) {
  std::string html = report();
  html.insert(html.rfind("</body>"), "<script>new Image().src = 'http://127.0.0.1:9/';</script>");
  EXPECT_THAT(without_script(document_of(html)), HasSubstr("data-violation=\"img-src"));
}

}  // namespace
}  // namespace pliant
