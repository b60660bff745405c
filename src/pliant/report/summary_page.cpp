#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pliant/report/html.h"
#include "pliant/report/labels.h"
#include "pliant/report/loop_figure.h"
#include "pliant/report/number_format.h"
#include "pliant/report/sections.h"
#include "pliant/report/shape_figures.h"
#include "pliant/report/sheet_figures.h"
#include "pliant/report/sheet_summary.h"
#include "pliant/report/verdict.h"

namespace pliant::report {
namespace {

// What fits one A4 page; the rest is counted and stands below it.
constexpr std::size_t kMaxLoops = 4;
constexpr std::size_t kMaxExperiments = 8;
constexpr std::size_t kMaxFacts = 10;
constexpr std::size_t kMaxListed = 4;
constexpr std::size_t kMaxTextLength = 110;
constexpr std::size_t kMaxNameLength = 22;
constexpr std::size_t kLoopBudget = 200;
constexpr int kPrintWidth = 703;  // A4 less its margins, at 96 px an inch

/// Cut at a character's end: UTF-8 continuation bytes start with the bits 10.
std::string shortened(const std::string& text, std::size_t length = kMaxTextLength) {
  if (text.size() <= length) return text;
  std::size_t end = length;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + " …";
}

std::vector<std::string> first_of(const std::vector<std::string>& texts, std::size_t count) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < std::min(count, texts.size()); ++i) {
    list.push_back(shortened(texts[i], kMaxTextLength));
  }
  if (texts.size() > count) {
    list.push_back(fmt::format("and {} more, listed below", texts.size() - count));
  }
  return list;
}

/// A key of the study is shown in words: `hardware_serial` as `hardware serial`.
std::string in_words(std::string key) {
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}

std::string specimens(const Results& results) {
  int fewest = 0, most = 0, points = 0;
  for (const ResultExperiment& e : results.experiments) {
    fewest = most == 0 ? e.specimens : std::min(fewest, e.specimens);
    most = std::max(most, e.specimens);
    points += e.points;
  }
  const std::string count =
      fewest == most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most);
  return fmt::format("{} per test, {} points", count, points);
}

std::string sessions(const ReportData& data) {
  int frames = 0;
  for (const auto& sheet : data.sheets) frames += sheet->session.frame_count();
  return fmt::format("{}, {} {}", data.sheets.size(), frames,
                     data.is_of_strips() ? "rows" : "frames");
}

std::string facts(const ReportData& data) {
  const Results& results = data.results;
  std::vector<std::pair<std::string, std::string>> all;
  if (results.density) {
    all.emplace_back("Area density", format_significant(1000.0 * *results.density, 3) + " g/m²");
  }
  if (!results.material.empty()) all.emplace_back("Material file", results.material);
  if (data.is_of_sheets()) {
    all.emplace_back(data.is_of_strips() ? "Strips" : "Sessions", sessions(data));
  } else {
    all.emplace_back("Specimens", specimens(results));
  }
  all.insert(all.end(), results.conditions.begin(), results.conditions.end());
  all.insert(all.end(), results.info.begin(), results.info.end());
  all.resize(std::min(all.size(), kMaxFacts));
  for (auto& [name, value] : all) {
    name = shortened(in_words(name), 24);
    value = shortened(value, 80);
  }
  return fact_list(all);
}

/// Of each component the fitted experiment with the most points, in the order of first appearance.
std::vector<std::size_t> representative_experiments(const Results& results) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < results.experiments.size(); ++i) {
    const ResultExperiment& e = results.experiments[i];
    const auto same = std::find_if(chosen.begin(), chosen.end(), [&](std::size_t c) {
      return results.experiments[c].component == e.component;
    });
    if (same == chosen.end()) {
      chosen.push_back(i);
      continue;
    }
    const ResultExperiment& rival = results.experiments[*same];
    const bool better =
        e.validation != rival.validation ? rival.validation : e.points > rival.points;
    if (better) *same = i;
  }
  if (results.judgement.misses.empty()) return chosen;
  // What is missed most is shown first.
  const auto worst = std::ranges::find(results.experiments, results.judgement.misses.front(),
                                       &ResultExperiment::name);
  if (worst == results.experiments.end()) return chosen;
  const auto index = static_cast<std::size_t>(worst - results.experiments.begin());
  std::erase(chosen, index);
  chosen.insert(chosen.begin(), index);
  return chosen;
}

PrintSize loop_print_size(std::size_t count) {
  constexpr int kGap = 12;
  constexpr int kWidest = 340;
  constexpr int kHeight = 172;
  const int columns = static_cast<int>(std::max<std::size_t>(count, 1));
  return {std::min((kPrintWidth - (columns - 1) * kGap) / columns, kWidest), kHeight};
}

/// The small picture of an experiment: its loop, or its strips from the side.
LoopFigure small_figure(const ReportData& data, std::size_t i) {
  const ResultExperiment& e = data.results.experiments[i];
  if (data.sheets[i]) {
    LoopFigure sheet;
    sheet.figure = sheet_figure(data.sheets[i]->session, /*compact=*/true);
    sheet.figure.data_file = e.sheet_folder;
    sheet.legend = {kMeasuredSheet, kPredictedSheet};
    return sheet;
  }
  if (!data.shapes[i]) {
    return loop_figure(e, data.predictions[i], {.budget = kLoopBudget, .compact = true});
  }
  const StripShapes& shapes = *data.shapes[i];
  LoopFigure strips;
  strips.figure = side_view(shapes, chosen_settings(shapes), /*compact=*/true);
  strips.figure.data_file = e.shape_file;
  strips.legend = {kMeasuredShape, kPredictedShape};
  return strips;
}

/// Adds the styles of a figure that the legend does not have yet.
void add_to_legend(const std::vector<SeriesStyle>& styles, std::vector<SeriesStyle>& legend) {
  for (const SeriesStyle& style : styles) {
    const bool known = std::any_of(legend.begin(), legend.end(), [&](const SeriesStyle& other) {
      return std::string_view(other.group) == style.group;
    });
    if (!known) legend.push_back(style);
  }
}

std::string loops(const ReportData& data, FigureSheet& figures) {
  std::vector<std::size_t> chosen = representative_experiments(data.results);
  const std::size_t components = chosen.size();
  chosen.resize(std::min(components, kMaxLoops));
  std::string cells;
  std::vector<SeriesStyle> legend;
  for (const std::size_t i : chosen) {
    const ResultExperiment& e = data.results.experiments[i];
    LoopFigure loop = small_figure(data, i);
    loop.figure.print_size = loop_print_size(chosen.size());
    add_to_legend(loop.legend, legend);
    cells += fmt::format("<figure><figcaption><strong>{}</strong> {}</figcaption>\n{}</figure>\n",
                         escape_html(component_title(e.component)), escape_html(e.name),
                         figures.add(loop.figure, "figure-small"));
  }
  if (cells.empty()) return {};
  return fmt::format(
      "<section class=\"figure-block\"><h2>Measured and predicted</h2>\n{}"
      "<div class=\"loops loops-{}\">\n{}</div>{}</section>\n",
      figures.can_draw() ? legend_html(legend) : std::string(), chosen.size(), cells,
      components > chosen.size()
          ? element("p", fmt::format("{} more components below.", components - chosen.size()))
          : std::string());
}

std::string pair(std::optional<double> measured, std::optional<double> predicted, int digits) {
  if (!measured && !predicted) return kNoValue;
  return format_significant(measured, digits) + " / " + format_significant(predicted, digits);
}

/// In N/m, or in uN m with its unit where a moment was measured.
std::string secant_pair(const LoopMeasures& measured, const LoopMeasures& predicted) {
  if (!measured.secant_rigidity) return pair(measured.secant_modulus, predicted.secant_modulus, 3);
  const auto micro = [](std::optional<double> rigidity) {
    return rigidity ? std::optional<double>(1e6 * *rigidity) : std::nullopt;
  };
  return pair(micro(measured.secant_rigidity), micro(predicted.secant_rigidity), 3) + " µN m";
}

std::string percent_pair(std::optional<double> measured, std::optional<double> predicted) {
  if (!measured && !predicted) return kNoValue;
  const auto percent = [](std::optional<double> fraction) {
    return fraction ? format_percent(100.0 * *fraction) : std::string(kNoValue);
  };
  return percent(measured) + " / " + percent(predicted);
}

std::string error_of_peak(const ResultExperiment& e) {
  if (e.rms_percent_of_peak) return format_percent(e.rms_percent_of_peak);
  if (e.rms_position_mm) return format_significant(e.rms_position_mm, 2) + " mm";
  return kNoValue;
}

std::string elastic_error(const ResultExperiment& e) {
  if (e.rms_elastic_percent_of_peak) return format_percent(e.rms_elastic_percent_of_peak);
  if (e.rms_elastic_position_mm) return format_significant(e.rms_elastic_position_mm, 2) + " mm";
  return kNoValue;
}

/// What does not fit the table must not hide a large error.
std::string hidden_experiments(const Results& results, std::size_t shown) {
  double largest = 0.0;
  for (std::size_t i = shown; i < results.experiments.size(); ++i) {
    largest = std::max(largest, results.experiments[i].rms_percent_of_peak.value_or(0.0));
  }
  return element("p", fmt::format("{} more below, with RMS errors up to {} of peak.",
                                  results.experiments.size() - shown, format_percent(largest)));
}

std::string experiment_table(const Results& results) {
  using Align = HtmlTable::Align;
  HtmlTable table({{"Experiment"},
                   {"Use"},
                   {"RMS error", Align::number, "of peak"},
                   {"without friction", Align::number, "best elastic curve"},
                   {"Secant modulus (N/m)", Align::number, "measured / material"},
                   {"Hysteresis ratio", Align::number, "measured / material"},
                   {"Loop loss", Align::number, "measured / material"}},
                  "compact");
  const std::size_t shown = std::min(kMaxExperiments, results.experiments.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const ResultExperiment& e = results.experiments[i];
    const LoopMeasures measured = e.measured_loop.value_or(LoopMeasures{});
    const LoopMeasures predicted = e.predicted_loop.value_or(LoopMeasures{});
    table.begin_row();
    table.cell(shortened(e.name, kMaxNameLength));
    table.cell(results.evaluation || e.validation ? "predicted" : "fitted");
    table.cell(error_of_peak(e));
    table.cell(elastic_error(e));
    table.cell(secant_pair(measured, predicted));
    table.cell(pair(measured.hysteresis_ratio, predicted.hysteresis_ratio, 2));
    table.cell(percent_pair(measured.loop_loss, predicted.loop_loss));
  }
  std::string html = "<section><h2>Agreement</h2>\n" + table.html();
  if (shown < results.experiments.size()) html += hidden_experiments(results, shown);
  return html +
         "<p class=\"small\">RMS error: of the peak force, of the largest extension where "
         "lengths are "
         "measured, or of the mean overhang; where profiles are, the distance from the predicted "
         "one. The rest: of the "
         "largest load-unload cycle. Secant modulus: force per width at "
         "the peak "
         "over engineering strain; of bending, moment per width over curvature (µN m). Hysteresis "
         "ratio: loading minus unloading force over their "
         "mean, at "
         "half the extension. Loop loss: work lost in the cycle over the work of loading it. "
         "&ldquo;Fitted&rdquo; experiments shaped the material, &ldquo;predicted&rdquo; ones did "
         "not.</p></section>\n";
}

struct StrainRange {
  std::string component;
  double low, high;
};

/// The strains that the data of each component cover; in an evaluation nothing is fitted, so all
/// experiments count.
std::vector<StrainRange> strain_ranges(const Results& results) {
  std::vector<StrainRange> ranges;
  for (const ResultExperiment& e : results.experiments) {
    if (!e.strain_range || e.measures_sheets() || (e.validation && !results.evaluation)) continue;
    const auto [low, high] = *e.strain_range;
    const auto known = std::find_if(ranges.begin(), ranges.end(), [&](const StrainRange& range) {
      return range.component == e.component;
    });
    if (known == ranges.end()) {
      ranges.push_back({e.component, low, high});
    } else {
      known->low = std::min(known->low, low);
      known->high = std::max(known->high, high);
    }
  }
  return ranges;
}

/// Extension of a strip whose Green-Lagrange strain is E: sqrt(1 + 2E) - 1.
std::string as_extension(const StrainRange& range) {
  if (range.low < -0.5) return {};
  const auto extension = [](double strain) {
    return format_significant(100.0 * (std::sqrt(1.0 + 2.0 * strain) - 1.0), 2);
  };
  return fmt::format(", extension {} to {} %", extension(range.low), extension(range.high));
}

std::string validity(const ReportData& data) {
  const bool green_lagrange = data.membrane == "stvk";
  std::vector<std::string> lines;
  bool membrane = false;
  for (const StrainRange& range : strain_ranges(data.results)) {
    membrane = membrane || !range.component.starts_with("bend");
    const bool convertible = green_lagrange && range.component.starts_with("stretch");
    lines.push_back(fmt::format("{}: {}{}", component_title(range.component),
                                strain_range_text(range.component, range.low, range.high),
                                convertible ? as_extension(range) : std::string()));
  }
  if (lines.empty()) return {};
  std::string html =
      "<section><h2>Range of validity</h2>\n" + bullet_list(first_of(lines, kMaxListed));
  if (green_lagrange && membrane) {
    html +=
        "<p class=\"small\">Strain is Green-Lagrange strain: half of (stretch&sup2; &minus; 1)."
        "</p>\n";
  }
  return html + "</section>\n";
}

std::string not_determined(const ReportData& data) {
  const Results& results = data.results;
  std::vector<std::string> items = undetermined_with_reasons(results);
  if (data.is_of_sheets()) {
    for (std::string& item : items) item = parameter_in_words(item);
  }
  if (results.evaluation && items.empty()) return {};
  if (items.empty()) items.push_back("Nothing: every estimated parameter is determined.");
  return fmt::format("<section><h2>{}</h2>\n{}</section>\n",
                     results.evaluation ? "Not tested by the data" : "Not determined by the data",
                     bullet_list(first_of(items, kMaxListed)));
}

/// What a reader must know before any number: in full, not shortened.
std::string doubts(const Results& results) {
  const auto section = [](const char* title, const std::vector<std::string>& sentences) {
    if (sentences.empty()) return std::string();
    return fmt::format("<section class=\"warnings\"><h2>{}</h2>\n{}</section>\n", title,
                       bullet_list(sentences));
  };
  return section("Is the data right?", results.questions) +
         section("Not predicted", results.skipped);
}

std::string warnings(const Results& results) {
  const std::vector<std::string> others(
      results.warnings.begin() +
          static_cast<std::ptrdiff_t>(std::min(results.questions.size(), results.warnings.size())),
      results.warnings.end());
  if (others.empty()) return "<section><h2>Warnings</h2><p>None.</p></section>\n";
  return "<section class=\"warnings\"><h2>Warnings</h2>\n" +
         bullet_list(first_of(others, kMaxListed)) + "</section>\n";
}

std::string headline(const ReportData& data) {
  const ResultJudgement& judgement = data.results.judgement;
  const std::string details = data.is_of_sheets() ? sheet_verdict(data) : verdict(data.results);
  const std::string text = escape_html(shortened(details, 560));
  if (judgement.headline.empty()) return fmt::format("<p class=\"verdict\">{}</p>\n", text);
  return fmt::format("<p class=\"verdict {}\"><strong>{}</strong> {}</p>\n", judgement.fitness,
                     escape_html(judgement.headline), text);
}

/// What a signature stands for: the version, the time and the beginnings of the digests of the
/// data.
std::string identity(const Results& results) {
  constexpr std::size_t kMost = 4, kDigits = 12;
  std::string text = "Pliant " + results.version;
  if (!results.created.empty()) text += ", " + results.created;
  if (results.data.empty()) return text;
  if (results.data.size() > kMost) {
    return text + fmt::format(". SHA-256 of {} data files below", results.data.size());
  }
  text += ". SHA-256 of the data:";
  for (const DataDigest& d : results.data) {
    text += fmt::format(" {} {}…", d.file, d.sha256.substr(0, kDigits));
  }
  return text;
}

constexpr std::string_view kSignature =
    "<div class=\"signature\"><span>Name</span><span>Date</span><span>Signature</span></div>\n";

}  // namespace

std::string summary_page(const ReportData& data, FigureSheet& figures) {
  const Results& results = data.results;
  std::string html = "<section class=\"page-one\">\n<header><h1>";
  html += escape_html(shortened(results.name, 48));
  html +=
      results.evaluation ? " <span>evaluation of a material</span>" : " <span>material fit</span>";
  html += "</h1></header>\n";
  html += headline(data);
  html += doubts(results);
  html += facts(data);
  html += data.is_of_sheets() ? sheet_findings(data, figures)
                              : loops(data, figures) + experiment_table(results);
  // Sessions have no range of one strain; the warnings take its place.
  const std::string last = warnings(results);
  html += "<div class=\"columns\">\n" + (data.is_of_sheets() ? last : validity(data)) +
          not_determined(data) + "</div>\n";
  if (!data.is_of_sheets()) html += last;
  html += kSignature;
  html += fmt::format("<p class=\"small\">{}</p>\n", escape_html(identity(results)));
  return html + "</section>\n";
}

}  // namespace pliant::report
