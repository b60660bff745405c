#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pliant/report/html.h"
#include "pliant/report/labels.h"
#include "pliant/report/material_table.h"
#include "pliant/report/number_format.h"
#include "pliant/report/page_budget.h"
#include "pliant/report/page_one_loops.h"
#include "pliant/report/readable_unit.h"
#include "pliant/report/sections.h"
#include "pliant/report/sheet_summary.h"

namespace pliant::report {
namespace {

// What fits one A4 page; the rest is counted and stands below it.
constexpr std::size_t kMaxListed = 4;
constexpr std::size_t kMaxTextLength = 110;
constexpr std::size_t kMaxNameLength = 22;

/// Cut at a character's end: UTF-8 continuation bytes start with the bits 10.
std::string shortened(const std::string& text, std::size_t length = kMaxTextLength) {
  if (text.size() <= length) return text;
  std::size_t end = length;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + " …";
}

std::vector<std::string> first_of(const std::vector<std::string>& texts, std::size_t count) {
  const std::size_t named = texts.size() > count ? count - 1 : texts.size();
  std::vector<std::string> list;
  for (std::size_t i = 0; i < named; ++i) list.push_back(shortened(texts[i], kMaxTextLength));
  if (texts.size() > named) {
    list.push_back(fmt::format("and {} more, marked below", texts.size() - named));
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

using Facts = std::vector<std::pair<std::string, std::string>>;

Facts all_facts(const ReportData& data) {
  const Results& results = data.results;
  Facts all;
  if (results.density) {
    all.push_back(results.is_of_solid()
                      ? std::pair("Density", format_significant(*results.density, 4) + " kg/m³")
                      : std::pair("Area density",
                                  format_significant(1000.0 * *results.density, 3) + " g/m²"));
  }
  if (!results.facts.material_file.empty())
    all.emplace_back("Material file", results.facts.material_file);
  if (data.is_of_sheets()) {
    all.emplace_back(data.is_of_strips() ? "Strips" : "Sessions", sessions(data));
  } else {
    all.emplace_back("Specimens", specimens(results));
  }
  all.insert(all.end(), results.conditions.begin(), results.conditions.end());
  all.insert(all.end(), results.info.begin(), results.info.end());
  return all;
}

std::string facts(Facts all, std::size_t shown) {
  all.resize(std::min(all.size(), shown));
  for (auto& [name, value] : all) {
    name = shortened(in_words(name), 24);
    value = shortened(value, 80);
  }
  return fact_list(all);
}

std::string pair(std::optional<double> measured, std::optional<double> predicted, int digits) {
  constexpr double kNothing = 1e-6;  // of the larger: what rounding leaves of zero
  if (!measured && !predicted) return kNoValue;
  const double nothing =
      kNothing * std::max(std::abs(measured.value_or(0)), std::abs(predicted.value_or(0)));
  const auto text = [&](std::optional<double> value) {
    return format_significant(value && std::abs(*value) < nothing ? 0 : value, digits);
  };
  return text(measured) + " / " + text(predicted);
}

/// With its unit: of forces per width over extension, or of moments over curvature.
std::string secant_pair(const LoopMeasures& measured, const LoopMeasures& predicted) {
  const bool bent = measured.secant_rigidity.has_value();
  const auto& from = bent ? measured.secant_rigidity : measured.secant_modulus;
  const auto& to = bent ? predicted.secant_rigidity : predicted.secant_modulus;
  if (!from && !to) return kNoValue;
  const ReadableUnit unit = readable_unit(bent ? "N m" : "N/m", from ? *from : *to);
  const auto shown = [&](std::optional<double> value) {
    return value ? std::optional(unit.factor * *value) : std::nullopt;
  };
  return pair(shown(from), shown(to), 3) + " " + unit.name;
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

/// Those that are not accepted, the worst first, then the others as the study has them.
std::vector<const ResultExperiment*> worst_first(const Results& results) {
  std::vector<const ResultExperiment*> order;
  for (const ResultExperiment& e : results.experiments) order.push_back(&e);
  const auto& misses = results.judgement.misses;
  std::ranges::stable_sort(order, {}, [&](const ResultExperiment* e) {
    return std::ranges::find(misses, e->name) - misses.begin();
  });
  return order;
}

/// What does not fit the table must not hide a large error.
std::string hidden_experiments(std::span<const ResultExperiment* const> hidden) {
  if (hidden.empty()) return {};
  double largest = 0;
  for (const ResultExperiment* e : hidden) {
    if (!e->rms_percent_of_peak) return fmt::format(" <small>{} more below</small>", hidden.size());
    largest = std::max(largest, *e->rms_percent_of_peak);
  }
  return fmt::format(" <small>{} more below, with RMS errors up to {} of peak</small>",
                     hidden.size(), escape_html(format_percent(largest)));
}

std::string experiment_table(const Results& results, std::size_t shown) {
  using Align = HtmlTable::Align;
  HtmlTable table({{"Experiment"},
                   {"Use"},
                   {"RMS error", Align::number, "of peak"},
                   {"without friction", Align::number, "best elastic curve"},
                   {"Secant modulus", Align::number, "measured / material"},
                   {"Hysteresis ratio", Align::number, "measured / material"},
                   {"Loop loss", Align::number, "measured / material"}},
                  "compact");
  const std::vector<const ResultExperiment*> experiments = worst_first(results);
  for (const ResultExperiment* experiment : std::span(experiments).first(shown)) {
    const ResultExperiment& e = *experiment;
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
  return "<section><h2>Agreement" + hidden_experiments(std::span(experiments).subspan(shown)) +
         "</h2>\n" + table.html() +
         "<p class=\"small\">RMS error: of the peak force, range of the lengths or mean overhang; "
         "of "
         "profiles their distance. Of the largest cycle: secant from its foot to its peak; loading "
         "minus "
         "unloading force over their mean, at half the extension; work lost over work of "
         "loading.</p></section>\n";
}

std::string not_determined(const ReportData& data) {
  const Results& results = data.results;
  std::vector<std::string> items = results.judgement.undetermined;
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
  const std::vector<std::string> first = warnings_of(results, /*on_page_one=*/true);
  const std::size_t more = warnings_of(results, /*on_page_one=*/false).size();
  if (first.empty()) return "<section><h2>Warnings</h2><p>None.</p></section>\n";
  return "<section class=\"warnings\"><h2>Warnings</h2>\n" + bullet_list(first) +
         (more > 0 ? element("p", fmt::format("{} more below.", more)) : std::string()) +
         "</section>\n";
}

std::string details(const Results& results) { return shortened(results.judgement.details, 560); }

std::string headline(const Results& results) {
  const ResultJudgement& judgement = results.judgement;
  if (judgement.headline.empty()) return {};
  return fmt::format("<p class=\"verdict {}\"><strong>{}</strong> {}</p>\n", judgement.fitness,
                     escape_html(judgement.headline), escape_html(details(results)));
}

std::string criteria(const Results& results) {
  return fmt::format("{}", fmt::join(results.judgement.criteria, "; "));
}

/// What a signature stands for: the version, the time and the beginnings of the digests of the
/// data.
std::string identity(const Results& results) {
  constexpr std::size_t kMost = 4, kDigits = 12;
  std::string text = "Pliant " + results.facts.version;
  if (!results.facts.created.empty()) text += ", " + results.facts.created;
  if (results.data.empty()) return text;
  if (results.data.size() > kMost) {
    return text + fmt::format(". SHA-256 of {} data files below", results.data.size());
  }
  text += ". SHA-256 of the data:";
  for (const DataFile& d : results.data) {
    text += fmt::format(" {} {}…", d.file, d.sha256.substr(0, kDigits));
  }
  return text;
}

std::vector<std::size_t> rows_of(const std::vector<std::string>& tables) {
  std::vector<std::size_t> rows;
  for (const std::string& table : tables) {
    constexpr std::string_view kRow = "<tr";
    std::size_t count = 0;
    for (std::size_t at = table.find(kRow); at != std::string::npos;
         at = table.find(kRow, at + 1)) {
      ++count;
    }
    rows.push_back(count > 0 ? count - 1 : 0);  // less that of the heads
  }
  return rows;
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
  html += headline(results);
  const std::string accepted = criteria(results);
  if (!accepted.empty()) html += element("p", "Acceptance: " + accepted + ".");
  html += doubts(results);
  const Facts fabric = all_facts(data);
  const std::vector<std::string> tables =
      data.is_of_sheets() ? sheet_tables(data) : std::vector<std::string>();
  const PageBudget budget = page_budget(
      results, results.judgement.headline.size() + details(results).size() + accepted.size(),
      fabric.size(), rows_of(tables));
  html += facts(fabric, budget.facts);
  html += page_one_loops(data, budget.loops, budget.height_of_loops, figures);
  html += material_table(results, data.material);
  if (tables.empty()) html += experiment_table(results, budget.experiments);
  for (const std::string& table : tables) html += table;
  if (data.is_of_sheets()) html += sheet_search(results);
  html += "<div class=\"columns\">\n" + warnings(results) + not_determined(data) + "</div>\n";
  html += kSignature;
  html += fmt::format("<p class=\"small\">{}</p>\n", escape_html(identity(results)));
  return html + "</section>\n";
}

}  // namespace pliant::report
