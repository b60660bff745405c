#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "pliant/report/html.h"
#include "pliant/report/labels.h"
#include "pliant/report/number_format.h"
#include "pliant/report/readable_unit.h"
#include "pliant/report/sections.h"

namespace pliant::report {
namespace {

using Align = HtmlTable::Align;

/// The strain over which friction builds up, of a stretch or shear.
bool is_membrane_strain(const ResultParameter& p) {
  return p.unit == "1" && p.name.ends_with(".tau") && !is_bending(p.component);
}

/// The strain over which friction builds up, as a tester knows it: extension or curvature.
std::string as_shown(const ResultParameter& p, std::optional<MembraneMeasure> membrane) {
  if (is_bending(p.component) && p.value && p.name.ends_with(".tau")) {
    return fmt::format("of three times the curvature; curvature {} 1/m",
                       format_significant(ShownStrain(p.component, membrane)(*p.value), 2));
  }
  const bool green = membrane == MembraneMeasure::stvk && p.component.starts_with("stretch");
  if (!green || !p.value || !is_membrane_strain(p)) return {};
  return fmt::format("Green strain; {} % extension",
                     format_significant(ShownStrain(p.component, membrane)(*p.value), 2));
}

std::string flags(const ResultParameter& p, std::optional<MembraneMeasure> membrane = {}) {
  std::vector<std::string> words;
  if (std::string shown = as_shown(p, membrane); !shown.empty()) words.push_back(shown);
  if (p.fixed) words.push_back("fixed, not estimated");
  if (!p.fixed && !p.identified) words.push_back("not determined");
  if (p.at_bound) words.push_back("at its bound");
  if (!p.note.empty()) words.push_back(p.note);
  return fmt::format("{}", fmt::join(words, "; "));
}

/// The same number in a unit in which it reads well; strains in per cent.
ResultParameter in_readable_unit(ResultParameter p) {
  ReadableUnit unit{"%", 100};
  if (!is_membrane_strain(p)) {
    unit = readable_unit(p.unit, std::max(std::abs(p.value.value_or(0)), p.std_error.value_or(0)));
  }
  for (auto* number : {&p.value, &p.std_error, &p.lower, &p.upper, &p.between_specimen_sd}) {
    if (*number) **number *= unit.factor;
  }
  p.unit = unit.name;
  return p;
}

/// Name, value, standard error and interval; a value that the data does not determine is greyed and
/// stands without an uncertainty that would make it look known.
void add_estimate(HtmlTable& table, const ResultParameter& stated) {
  const ResultParameter p = in_readable_unit(stated);
  const bool known = p.fixed || p.identified;
  const bool uncertain = known && !p.fixed;
  const UncertainFormat format(p.value, uncertain ? p.std_error : std::nullopt);
  table.cell(known ? format(p.value) : fmt::format("({})", format_significant(p.value, 2)));
  table.cell(uncertain ? format(p.std_error) : kNoValue);
  table.cell(uncertain && p.lower && p.upper
                 ? fmt::format("{} to {}", format(p.lower), format(p.upper))
                 : std::string(kNoValue));
  table.cell(shown_unit(p.unit));
}

std::string_view row_class(const ResultParameter& p) {
  return !p.fixed && !p.identified ? "undetermined" : "";
}

bool any_spread(const std::vector<ResultParameter>& parameters) {
  return std::any_of(parameters.begin(), parameters.end(),
                     [](const ResultParameter& p) { return p.between_specimen_sd.has_value(); });
}

std::string parameter_table(const std::vector<ResultParameter>& parameters,
                            std::optional<MembraneMeasure> membrane) {
  const bool spread = any_spread(parameters);
  std::vector<HtmlTable::Column> columns = {{"Parameter"},
                                            {"Value", Align::number},
                                            {"Standard error", Align::number},
                                            {"95 % interval", Align::number},
                                            {"Unit", Align::unit}};
  if (spread) columns.push_back({"Between specimens", Align::number, "standard deviation"});
  columns.push_back({"Remarks"});
  HtmlTable table(std::move(columns));
  for (const ResultParameter& p : parameters) {
    table.begin_row(row_class(p));
    const std::string meaning = parameter_meaning(p.name);
    table.html_cell(fmt::format("<code>{}</code>{}", escape_html(p.name),
                                meaning.empty() ? "" : "<small>" + meaning + "</small>"));
    add_estimate(table, p);
    if (spread) table.cell(format_significant(in_readable_unit(p).between_specimen_sd, 2));
    table.cell(flags(p, membrane));
  }
  return table.html();
}

std::string nuisance_table(const std::vector<ResultParameter>& nuisance) {
  if (nuisance.empty()) return {};
  HtmlTable table({{"Nuisance parameter"},
                   {"Experiment"},
                   {"Value", Align::number},
                   {"Standard error", Align::number},
                   {"95 % interval", Align::number},
                   {"Unit", Align::unit},
                   {"Remarks"}});
  for (const ResultParameter& p : nuisance) {
    table.begin_row(row_class(p));
    const std::string meaning = parameter_meaning(p.name);
    table.html_cell(fmt::format("<code>{}</code>{}", escape_html(p.name),
                                meaning.empty() ? "" : "<small>" + meaning + "</small>"));
    table.cell(p.experiment);
    add_estimate(table, p);
    table.cell(flags(p));
  }
  const bool cords = std::ranges::any_of(
      nuisance, [](const ResultParameter& p) { return p.name.ends_with(".cord_friction"); });
  std::string html =
      "<h3>Nuisance parameters</h3>\n"
      "<p>Belong to one test, not to the fabric: estimated so that they do not spoil the "
      "material.</p>\n";
  if (cords) {
    html +=
        "<p>Pulleys hold cords back: a load cell shows half of a loop more while the cord pulls "
        "and half of it less while it gives way. Cords of a clip that move alike are known "
        "together only, each alone by what was expected beforehand; the remark states their "
        "sum.</p>\n";
  }
  return html + table.html();
}

std::string singular_value_table(const std::map<std::string, std::vector<double>>& all) {
  if (all.empty()) return {};
  HtmlTable table(
      {{"Component"}, {"Smallest / largest", Align::number}, {"Singular values, largest first"}});
  for (auto [component, values] : all) {
    std::sort(values.rbegin(), values.rend());
    std::vector<std::string> texts;
    for (const double value : values) texts.push_back(format_significant(value, 2));
    table.begin_row();
    table.cell(component);
    table.cell(values.empty() || values.front() <= 0.0
                   ? std::string(kNoValue)
                   : format_significant(values.back() / values.front(), 2));
    table.cell(fmt::format("{}", fmt::join(texts, ", ")));
  }
  return "<h3>How well the data determine the parameters</h3>\n"
         "<p>Singular values of the scaled sensitivities. One that is many powers of ten below the "
         "largest is a combination of parameters that the data hardly see.</p>\n" +
         table.html();
}

}  // namespace

std::string parameter_section(const ReportData& data) {
  const Results& results = data.results;
  if (results.parameters.empty()) return {};
  std::string html = "<section id=\"parameters\"><h2>Parameters</h2>\n";
  html +=
      results.evaluation
          ? "<p>Taken from the material file.</p>\n"
          : "<p>The standard error is what the noise of these data leaves uncertain, under the "
            "assumptions listed below. The spread between specimens, where several were tested, "
            "is the difference from one piece of fabric to the next. Greyed values in brackets "
            "are where the search stopped: the data do not determine them.</p>\n";
  if (results.work) {
    html += fmt::format(
        "<p>Remarks: where a control point of a stiffness curve lies, and which {} tell the "
        "number, each with its share of what is known.</p>\n",
        data.is_of_strips() ? "strips" : "sessions");
  }
  return html + parameter_table(results.parameters, results.membrane) +
         nuisance_table(results.nuisance) + singular_value_table(results.singular_values) +
         "</section>\n";
}

}  // namespace pliant::report
