#include "pliant/report/material_table.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "pliant/report/html.h"
#include "pliant/report/labels.h"
#include "pliant/report/number_format.h"
#include "pliant/report/readable_unit.h"

namespace pliant::report {
namespace {

using Align = HtmlTable::Align;

struct StrainRange {
  std::string component;
  double low, high;
};

/// The strains that the data of each component cover; in an evaluation nothing is fitted, so all
/// experiments count. Somewhere along it a bent strip is straight. Of sheets the material tells.
std::vector<StrainRange> strain_ranges(const Results& results,
                                       const std::optional<Material>& material) {
  std::vector<StrainRange> ranges;
  for (const ResultExperiment& e : results.experiments) {
    if (!e.strain_range || e.measures_sheets() || (e.validation && !results.evaluation)) continue;
    const auto [least, high] = *e.strain_range;
    const double low = is_bending(e.component) ? std::min(least, 0.0) : least;
    const auto known = std::ranges::find(ranges, e.component, &StrainRange::component);
    if (known == ranges.end()) {
      ranges.push_back({e.component, low, high});
    } else {
      known->low = std::min(known->low, low);
      known->high = std::max(known->high, high);
    }
  }
  if (!material) return ranges;
  for (const auto& [name, component] : material->components) {
    const bool known = std::ranges::find(ranges, name, &StrainRange::component) != ranges.end();
    if (known || !component.range || !results.has_figures(name)) continue;
    ranges.push_back({name, component.range->first, component.range->second});
  }
  return ranges;
}

bool is_membrane(std::string_view component) {
  return !is_bending(component) && !is_contraction(component);
}

/// The components of one kind that have figures or data, in the order of a cloth's components.
std::vector<std::string> components_of(const Results& results,
                                       const std::vector<StrainRange>& ranges,
                                       bool (*is_of_kind)(std::string_view component)) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (is_of_kind(name) && std::ranges::find(names, name) == names.end()) {
      names.push_back(name);
    }
  };
  for (const ResultFigure& figure : results.figures) add(figure.component);
  for (const StrainRange& range : ranges) add(range.component);
  return names;
}

/// Laboratories count rigidities in µN m, moments per width in mN and lengths in mm.
ReadableUnit lab_unit(std::string_view unit, double largest) {
  const auto starting_with = [&](std::string_view lab, double factor) {
    const ReadableUnit readable = readable_unit(lab, factor * largest);
    return ReadableUnit{readable.name, factor * readable.factor};
  };
  if (unit == "N m") return starting_with("µN m", 1e6);
  if (unit == "N") return starting_with("mN", 1e3);
  if (unit == "m") return {"mm", 1e3};
  return readable_unit(unit, largest);
}

/// A column of figures that have one name and one unit.
class FigureColumn {
 public:
  FigureColumn(const Results& results, std::string_view name, bool last_of_name = false)
      : results_(results), name_(name), last_(last_of_name) {
    double largest = 0;
    std::string_view si;
    for (const ResultFigure& figure : results.figures) {
      if (figure.name != name_) continue;
      largest = std::max(largest, std::abs(figure.value.value_or(0)));
      si = figure.unit;
    }
    unit_ = lab_unit(si, largest);
  }

  const std::string& unit() const { return unit_.name; }

  /// `93.4 ± 2.0`; in brackets what is not determined; nothing of a component without the figure.
  std::string cell(const std::string& component) const {
    const ResultFigure* figure = find(component);
    if (!figure || !figure->value) return {};
    return number(*figure) + (figure->beyond_range ? "*" : "") + place(*figure);
  }

 private:
  const ResultFigure* find(const std::string& component) const {
    const ResultFigure* found = nullptr;
    for (const ResultFigure& figure : results_.figures) {
      if (figure.component != component || figure.name != name_) continue;
      if (!found || last_) found = &figure;
    }
    return found;
  }

  std::string number(const ResultFigure& figure) const {
    const double value = unit_.factor * *figure.value;
    const double error = unit_.factor * figure.std_error.value_or(0);
    if (results_.evaluation || (figure.std_error && error == 0)) {
      return format_significant(value, 3);
    }
    if (results_.differs_in(figure.component)) return format_significant(value, 3);
    if (!is_determined(figure)) return fmt::format("({})", format_significant(value, 2));
    const UncertainFormat format(value, error);
    return fmt::format("{} ± {}", format(value), format(error));
  }

  /// A bending length is a length of some rigidity, and no better known to be one.
  bool is_determined(const ResultFigure& figure) const {
    if (figure.name != "bending_length") return figure.is_determined();
    return std::ranges::any_of(results_.figures, [&](const ResultFigure& other) {
      const bool rigidity = other.name == "rigidity_at_rest" || other.name == "kes_B";
      return rigidity && other.component == figure.component && other.is_determined();
    });
  }

  static std::string place(const ResultFigure& figure) {
    if (!figure.at || figure.name == "secant_rigidity") return {};
    if (figure.component == "shear") {
      return fmt::format(" at {}°", format_significant(*figure.at * 180 / std::numbers::pi, 2));
    }
    return fmt::format(" at {} %", format_significant(100 * *figure.at, 2));
  }

  const Results& results_;
  std::string name_;
  bool last_;
  ReadableUnit unit_;
};

/// What stands where a component has no friction.
std::string without_friction(const Results& results, const std::string& component) {
  const bool wanted = std::ranges::any_of(
      results.judgement.undetermined,
      [&](const std::string& item) { return item.starts_with("friction of " + component); });
  return wanted ? "not determined" : kNoValue;
}

std::string or_none(std::string cell) { return cell.empty() ? std::string(kNoValue) : cell; }

/// The range of the data as its column says it, and that of the Green strain in a column of its
/// own.
void add_range(const Results& results, const std::vector<StrainRange>& ranges,
               const std::string& component, HtmlTable& table) {
  const auto range = std::ranges::find(ranges, component, &StrainRange::component);
  if (range == ranges.end()) {
    for (int i = 0; i < (is_bending(component) ? 1 : 2); ++i) table.cell(kNoValue);
    return;
  }
  const auto [text, green] =
      strain_range_texts(component, results.membrane, range->low, range->high);
  table.cell(component == "shear" ? "shear strain " + text : text);
  if (!is_bending(component)) table.cell(green.empty() ? kNoValue : green);
}

/// A row with the title of a component and its figures.
void begin_row(const std::string& component, std::initializer_list<const FigureColumn*> figures,
               HtmlTable& table) {
  table.begin_row();
  table.cell(component_title(component));
  for (const FigureColumn* figure : figures) table.cell(or_none(figure->cell(component)));
}

std::string elastic(const FigureColumn& at_rest) { return at_rest.unit() + ", without friction"; }

std::string membranes(const Results& results, const std::vector<StrainRange>& ranges) {
  const std::vector<std::string> components = components_of(results, ranges, is_membrane);
  if (components.empty()) return {};
  const FigureColumn rest(results, "stiffness_at_rest"), secant(results, "secant_modulus"),
      end(results, "secant_modulus", /*last_of_name=*/true), loop(results, "loop_width");
  HtmlTable table({{"Stretch, shear"},
                   {"At rest", Align::number, elastic(rest)},
                   {"Secant modulus", Align::number, secant.unit()},
                   {"At the end", Align::number, end.unit()},
                   {"Loop width", Align::number, loop.unit()},
                   {"Range", Align::unit, strain_name("stretch", results.membrane)},
                   {"Green strain", Align::unit}},
                  "compact");
  for (const std::string& component : components) {
    begin_row(component, {&rest, &secant, &end}, table);
    const std::string friction = loop.cell(component);
    table.cell(friction.empty() ? without_friction(results, component) : friction);
    add_range(results, ranges, component, table);
  }
  return table.html();
}

std::string bends(const Results& results, const std::vector<StrainRange>& ranges) {
  const std::vector<std::string> components = components_of(results, ranges, is_bending);
  if (components.empty()) return {};
  const FigureColumn rest(results, "rigidity_at_rest"), end(results, "secant_rigidity"),
      b(results, "kes_B"), loop(results, "kes_2HB"), length(results, "bending_length");
  HtmlTable table({{"Bending"},
                   {"At rest", Align::number, elastic(rest)},
                   {"At the end", Align::number, end.unit()},
                   {"B", Align::number, b.unit()},
                   {"2HB", Align::number, loop.unit()},
                   {"Bending length", Align::number, length.unit()},
                   {"Range", Align::unit, "curvature"}},
                  "compact");
  for (const std::string& component : components) {
    begin_row(component, {&rest, &end, &b}, table);
    const std::string friction = loop.cell(component);
    table.cell(friction.empty() ? without_friction(results, component) : friction);
    table.cell(or_none(length.cell(component)));
    add_range(results, ranges, component, table);
  }
  return table.html();
}

std::string contractions(const Results& results, const std::vector<StrainRange>& ranges) {
  const std::vector<std::string> components = components_of(results, ranges, is_contraction);
  if (components.empty()) return {};
  const FigureColumn half(results, "poisson_ratio"),
      end(results, "poisson_ratio", /*last_of_name=*/true), coupling(results, "coupling");
  HtmlTable table({{"Contraction"},
                   {"Poisson's ratio", Align::number, "half way"},
                   {"At the end", Align::number},
                   {"Coupling", Align::number, coupling.unit()},
                   {"Range", Align::unit, strain_name("stretch", results.membrane)},
                   {"Green strain", Align::unit}},
                  "compact");
  for (const std::string& component : components) {
    begin_row(component, {&half, &end, &coupling}, table);
    add_range(results, ranges, component, table);
  }
  return table.html();
}

std::string notes(const Results& results, bool membranes, bool bending, bool contractions) {
  std::string text = results.evaluation
                         ? "Of the material; its errors stand in the report of its fit."
                         : "± standard error; in brackets: not determined by the data.";
  if (membranes) {
    text +=
        " Stiffness: force per width over extension (N/m = cN/cm), of shear stress over strain; "
        "secants while first loaded; loop width: friction, at half of the range.";
  }
  if (bending) {
    text +=
        " Bending: moment per width over curvature; B and 2HB (friction) as the Kawabata tester "
        "prints them: 1 µN m = 0.0102 gf cm²/cm, 1 mN = 0.102 gf cm/cm.";
  }
  if (contractions) {
    text +=
        " Contraction: Poisson's ratio of engineering strains, on the first way out; coupling: "
        "that "
        "of an elastic sheet whose strips stretch and narrow so.";
  }
  if (results.has_samples()) {
    text +=
        " Without an error: the mean of samples, whose numbers stand below, from place to place.";
  }
  const bool beyond = std::ranges::any_of(
      results.figures, [](const ResultFigure& figure) { return figure.beyond_range; });
  return text + (beyond ? " * read off the law where there are no data." : "");
}

/// The numbers of a solid's laws, whose components all show together.
std::string solid_numbers(const Results& results) {
  if (results.parameters.empty()) return {};
  HtmlTable table({{"Number"},
                   {"Value", Align::number},
                   {"Standard error", Align::number},
                   {"Unit", Align::unit}},
                  "compact");
  for (const ResultParameter& p : results.parameters) {
    const ReadableUnit unit = readable_unit(p.unit, std::abs(p.value.value_or(0)));
    const auto shown = [&](const std::optional<double>& number, int digits) {
      return number ? format_significant(unit.factor * *number, digits) : std::string(kNoValue);
    };
    table.begin_row();
    table.cell(p.name);
    table.cell(p.identified ? shown(p.value, 4) : "(" + shown(p.value, 4) + ")");
    table.cell(shown(p.std_error, 2));
    table.cell(unit.name);
  }
  return "<section><h2>Material</h2>\n" + table.html() +
         "<p class=\"small\">In brackets: not determined by the data.</p></section>\n";
}

}  // namespace

std::string material_table(const Results& results, const std::optional<Material>& material) {
  if (results.is_of_solid()) return solid_numbers(results);
  const std::vector<StrainRange> ranges = strain_ranges(results, material);
  const std::string stretch = membranes(results, ranges), bending = bends(results, ranges),
                    contraction = contractions(results, ranges);
  if (stretch.empty() && bending.empty() && contraction.empty()) return {};
  return "<section><h2>Material</h2>\n" + stretch + bending + contraction + "<p class=\"small\">" +
         notes(results, !stretch.empty(), !bending.empty(), !contraction.empty()) +
         "</p></section>\n";
}

}  // namespace pliant::report
