#include "pliant/report/sheet_summary.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pliant/report/html.h"
#include "pliant/report/labels.h"
#include "pliant/report/material_table.h"
#include "pliant/report/number_format.h"
#include "pliant/report/sheet_figures.h"

namespace pliant::report {
namespace {

using Align = HtmlTable::Align;

constexpr double kMicro = 1e-6;

bool is_fitted(const ReportData& data, std::size_t i) {
  return !data.results.evaluation && !data.results.experiments[i].validation;
}

/// What the thesis calls a test in its tables.
std::string_view name_in_thesis(std::string_view test) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kNames = {
      {{"stretch-weft", "Stretch-X"},
       {"stretch-warp", "Stretch-Y"},
       {"shear", "Shear"},
       {"bend-weft", "Bend-X"},
       {"bend-warp", "Bend-Y"}}};
  const auto* found = std::ranges::find(kNames, test, &decltype(kNames)::value_type::first);
  return found != kNames.end() ? found->second : test;
}

bool has_fold_error(const ResultExperiment& e) { return e.fold_height_error_mm.has_value(); }

std::string as_compared(const SheetData& sheet) {
  return sheet.rms_clip_force ? format_significant(sheet.rms_clip_force, 3) + " N"
                              : format_significant(1e3 * sheet.rms_distance.value_or(0), 3) + " mm";
}

using Parameters = std::vector<const ResultParameter*>;

Parameters stiffness_of(const Results& results, std::string_view component) {
  Parameters found;
  for (const ResultParameter& p : results.parameters) {
    if (p.component == component && p.name.find(".friction.") == std::string::npos) {
      found.push_back(&p);
    }
  }
  return found;
}

/// Value and standard error in the shown unit; a value that the data do not determine stands in
/// brackets, one that the study states has no error.
void add_value(HtmlTable& table, const ResultParameter& p, double unit) {
  const auto shown = [&](std::optional<double> value) {
    return value ? std::optional(*value / unit) : std::nullopt;
  };
  const UncertainFormat format(shown(p.value), shown(p.std_error));
  if (p.fixed) {
    table.cell(format_significant(shown(p.value), 3));
    table.cell("fixed");
    return;
  }
  table.cell(p.identified ? format(shown(p.value)) : fmt::format("({})", format(shown(p.value))));
  table.cell(p.std_error ? format(shown(p.std_error)) : std::string(kNoValue));
}

/// The largest strain that a component is known for.
std::optional<double> end_of(const MaterialComponent& component) {
  if (component.range) return component.range->second;
  const std::vector<double>& knots = component.stiffness->knots();
  return knots.empty() ? std::nullopt : std::optional(knots.back());
}

void add_stiffness(HtmlTable& table, const Material& material, const std::string& component,
                   const Results& results) {
  const Parameters parameters = stiffness_of(results, component);
  if (parameters.empty()) return;
  const bool known = std::ranges::any_of(
      parameters, [](const ResultParameter* p) { return p->fixed || p->identified; });
  const double unit = is_bending(component) ? kMicro : 1;
  const ShownStrain shown(component, results.membrane);
  const std::optional<double> end = end_of(material.components.at(component));
  table.begin_row(known ? "" : "undetermined");
  table.cell(component_title(component));
  add_value(table, *parameters.front(), unit);
  if (parameters.size() > 1) {
    add_value(table, *parameters.back(), unit);
    table.cell(end ? format_significant(shown(*end), 2) + " " + shown.label().unit
                   : std::string(kNoValue));
  } else {
    for (const char* cell : {"the same", kNoValue, kNoValue}) table.cell(cell);
  }
  table.cell(is_bending(component) ? "µN m" : "N/m");
}

const ResultParameter* friction_parameter(const Results& results, std::string_view component,
                                          std::string_view part) {
  const auto found = std::ranges::find_if(results.parameters, [&](const ResultParameter& p) {
    return p.component == component && p.name.ends_with(part) &&
           p.name.find(".friction.") != std::string::npos;
  });
  return found == results.parameters.end() ? nullptr : &*found;
}

/// `2.234 ± 0.037` in the shown unit; in brackets where the data do not determine it.
std::string with_error(const ResultParameter& p, double unit) {
  const auto shown = [&](std::optional<double> value) {
    return value ? std::optional(*value / unit) : std::nullopt;
  };
  if (p.fixed) return format_significant(shown(p.value), 3) + ", fixed";
  const UncertainFormat format(shown(p.value), shown(p.std_error));
  const std::string text =
      p.std_error ? fmt::format("{} ± {}", format(shown(p.value)), format(shown(p.std_error)))
                  : format(shown(p.value));
  return p.identified ? text : "(" + text + ")";
}

/// `0.10 N`, `0.10 to 0.15 N`
std::string range_text(double low, double high, std::string_view unit) {
  const std::string from = format_significant(low, 2), to = format_significant(high, 2);
  return from == to ? fmt::format("{} {}", from, unit) : fmt::format("{} to {} {}", from, to, unit);
}

/// What the cords of the fitted sessions were found to hold back.
std::string cord_sentence(const Results& results) {
  std::vector<std::string> found;
  for (const ResultExperiment& e : results.experiments) {
    double low = 0, high = 0;
    int cords = 0;
    for (const ResultParameter& p : results.nuisance) {
      if (p.experiment != e.name || !p.name.ends_with(".cord_friction") || !p.value) continue;
      low = cords == 0 ? *p.value : std::min(low, *p.value);
      high = std::max(high, *p.value);
      ++cords;
    }
    if (cords > 0) found.push_back(fmt::format("{} {}", e.name, range_text(low, high, "N")));
  }
  if (found.empty()) return {};
  return fmt::format(
      " Cords that rub on their pulleys go a loop, too; its width was estimated along: {}.",
      escape_html(fmt::format("{}", fmt::join(found, "; "))));
}

}  // namespace

std::string stiffness_table(const ReportData& data) {
  if (data.results.parameters.empty() || !data.material) return {};
  HtmlTable table({{"Stiffness"},
                   {"At zero strain", Align::number},
                   {"Standard error", Align::number},
                   {"At the end", Align::number},
                   {"Standard error", Align::number},
                   {"End of the range", Align::number},
                   {"Unit"}},
                  "compact");
  for (const std::string& component : cloth_component_names()) {
    if (data.material->components.contains(component) && !data.results.has_figures(component)) {
      add_stiffness(table, *data.material, component, data.results);
    }
  }
  if (table.empty()) return {};
  return "<section>\n" + table.html() +
         "<p class=\"small\">Bending: of the hinges of the mesh. Range: of the fitted sheets; few "
         "elements reach its end.</p></section>\n";
}

std::string friction_table(const ReportData& data) {
  HtmlTable table({{"Friction of the cloth"},
                   {"At zero strain", Align::number, "N/m"},
                   {"Growth with strain", Align::number, "N/m"},
                   {"Builds up over", Align::number, "% strain"}},
                  "compact");
  for (const std::string& component : cloth_component_names()) {
    const auto part = [&](std::string_view name) {
      return friction_parameter(data.results, component, name);
    };
    const ResultParameter *a = part(".a"), *b = part(".b"), *tau = part(".tau");
    if (!a || !b || !tau) continue;
    table.begin_row();
    table.cell(component_title(component));
    table.cell(with_error(*a, 1));
    table.cell(with_error(*b, 1));
    table.cell(with_error(*tau, 0.01));
  }
  const std::string cords = cord_sentence(data.results);
  if (table.empty()) return cords.empty() ? cords : "<p class=\"small\">" + cords + "</p>\n";
  return "<section>\n" + table.html() +
         "<p class=\"small\">A stress against the way the cloth is going: forces go a loop. After "
         "a "
         "turn it builds up anew over the strain in the last column." +
         cords + "</p></section>\n";
}

constexpr std::string_view kAboutFolds =
    " Folds: how far wrinkles differ in height, wherever they stand; one that is only shifted "
    "hardly counts.";

/// The errors that do not punish a wrinkle for being shifted ([T] 3.6).
void add_folds(const std::vector<ResultExperiment>& sessions, HtmlTable& table) {
  table.begin_row();
  table.cell("folds");
  for (const ResultExperiment& e : sessions) {
    table.cell(has_fold_error(e) ? format_significant(e.fold_height_error_mm, 3) + " mm"
                                 : kNoValue);
  }
}

/// Between nodes; nothing where none were seen.
void add_distances(const ReportData& data, HtmlTable& table) {
  table.begin_row();
  table.cell("free nodes");
  for (const auto& sheet : data.sheets) {
    table.cell(sheet->rms_distance ? format_significant(1e3 * *sheet->rms_distance, 3) + " mm"
                                   : kNoValue);
  }
}

std::string residual_table(const ReportData& data) {
  std::vector<HtmlTable::Column> columns = {{"RMS residual"}};
  for (std::size_t i = 0; i < data.sheets.size(); ++i) {
    const SheetSession& sheet = data.sheets[i]->session;
    const std::string_view test = sheet.is_seen() ? name_in_thesis(sheet.measured.test)
                                                  : data.results.experiments[i].direction;
    columns.push_back(
        {data.results.experiments[i].name, Align::number,
         fmt::format("{}, {}", escape_html(test), is_fitted(data, i) ? "fitted" : "predicted")});
  }
  HtmlTable table(std::move(columns), "compact");
  table.begin_row();
  table.cell("as compared");
  for (const auto& sheet : data.sheets) table.cell(as_compared(*sheet));
  const bool strips = data.is_of_strips();
  if (!strips) add_distances(data, table);
  const bool folds = std::ranges::any_of(data.results.experiments, has_fold_error);
  if (folds) add_folds(data.results.experiments, table);
  constexpr std::string_view kAboutSheets =
      "As compared: of bends the distance of all free nodes, of others the difference of the "
      "clips' "
      "forces, of shear along the clips. Free nodes: the distance between measured and predicted "
      "nodes of all frames.";
  return "<section><h2>Residuals</h2>\n" + table.html() + "<p class=\"small\">" +
         std::string(strips ? "The difference of the forces." : kAboutSheets) +
         std::string(folds ? kAboutFolds : "") + "</p></section>\n";
}

std::string sheet_search(const Results& results) {
  if (results.evaluation) return {};
  std::vector<std::string> lines;
  for (const std::string& text : results.assumptions) {
    if (text.starts_with("search: ")) lines.push_back(text.substr(8));
  }
  if (!results.stages.empty()) {
    const auto kept = std::ranges::count_if(results.stages, &FitStage::accepted);
    lines.push_back(fmt::format("{} stages, {} of them kept", results.stages.size(), kept));
  }
  if (results.work) lines.push_back(fmt::format("{} equilibria", results.work->counts.equilibria));
  if (results.seconds) lines.push_back(format_significant(results.seconds, 3) + " s");
  if (lines.empty()) return {};
  return fmt::format("<p class=\"small\">Search: {}.</p>\n",
                     escape_html(fmt::format("{}", fmt::join(lines, "; "))));
}

std::vector<std::string> sheet_tables(const ReportData& data) {
  std::vector<std::string> tables{stiffness_table(data), friction_table(data),
                                  residual_table(data)};
  std::erase(tables, "");
  return tables;
}

}  // namespace pliant::report
