#include "pliant/report/page_one_loops.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "pliant/report/html.h"
#include "pliant/report/labels.h"
#include "pliant/report/loop_figure.h"
#include "pliant/report/shape_figures.h"
#include "pliant/report/sheet_figures.h"

namespace pliant::report {
namespace {

constexpr std::size_t kMaxLoops = 4;
constexpr std::size_t kLoopBudget = 200;
constexpr int kPrintWidth = 703;  // A4 less its margins, at 96 px an inch
constexpr int kGap = 12;
constexpr int kCaption = 20;

std::vector<std::string> components_of(const Results& results) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  if (const auto& misses = results.judgement.misses; !misses.empty()) {
    const auto worst =
        std::ranges::find(results.experiments, misses.front(), &ResultExperiment::name);
    if (worst != results.experiments.end()) add(worst->component);
  }
  for (const ResultExperiment& e : results.experiments) add(e.component);
  return names;
}

/// The experiment of a component and a role that is missed most, or else has the most points.
std::optional<std::size_t> representative(const Results& results, const std::string& component,
                                          bool validation) {
  std::optional<std::size_t> best;
  const auto rank = [&](const ResultExperiment& e) {
    const auto& misses = results.judgement.misses;
    const auto miss = std::ranges::find(misses, e.name);
    return std::pair(misses.end() - miss, e.points);
  };
  for (std::size_t i = 0; i < results.experiments.size(); ++i) {
    const ResultExperiment& e = results.experiments[i];
    if (e.component != component || e.validation != validation) continue;
    if (!best || rank(e) > rank(results.experiments[*best])) best = i;
  }
  return best;
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
    return loop_figure(e, data.predictions[i],
                       {.budget = kLoopBudget, .compact = true, .membrane = data.results.membrane});
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
    const bool known = std::ranges::any_of(legend, [&](const SeriesStyle& other) {
      return std::string_view(other.group) == style.group;
    });
    if (!known) legend.push_back(style);
  }
}

/// Up to three stand in a row; of four each fit has its validation beside it.
int columns_of(std::size_t count) { return count < 4 ? static_cast<int>(count) : 2; }

PrintSize print_size(std::size_t count, int height) {
  const int columns = columns_of(count);
  const int rows = static_cast<int>(count) / columns;
  return {(kPrintWidth - (columns - 1) * kGap) / columns,
          (height - (rows - 1) * kGap) / rows - kCaption};
}

std::string_view role_of(const Results& results, const ResultExperiment& e) {
  return results.evaluation || e.validation ? "predicted" : "fitted";
}

std::string points_drawn(const LoopFigure& loop) {
  if (loop.drawn >= loop.total) return {};
  return fmt::format(", {} of {} points", loop.drawn, loop.total);
}

}  // namespace

std::vector<std::size_t> experiments_on_page_one(const Results& results) {
  std::vector<std::size_t> chosen;
  for (const std::string& component : components_of(results)) {
    for (const bool validation : {false, true}) {
      const auto one = representative(results, component, validation);
      if (one && chosen.size() < kMaxLoops) chosen.push_back(*one);
    }
  }
  return chosen;
}

std::string page_one_loops(const ReportData& data, std::size_t count, int height,
                           FigureSheet& figures) {
  const Results& results = data.results;
  std::vector<std::size_t> chosen = experiments_on_page_one(results);
  chosen.resize(std::min(chosen.size(), count));
  if (chosen.empty()) return {};
  std::set<std::string> shown;
  std::string cells;
  std::vector<SeriesStyle> legend;
  for (const std::size_t i : chosen) {
    const ResultExperiment& e = results.experiments[i];
    LoopFigure loop = small_figure(data, i);
    loop.figure.print_size = print_size(chosen.size(), height);
    add_to_legend(loop.legend, legend);
    shown.insert(e.component);
    cells += fmt::format(
        "<figure><figcaption><strong>{}</strong> {}: {}{}</figcaption>\n{}</figure>\n",
        escape_html(component_title(e.component)), escape_html(e.name), role_of(results, e),
        points_drawn(loop), figures.add(loop.figure, "figure-small"));
  }
  const std::size_t more = components_of(results).size() - shown.size();
  return fmt::format(
      "<section class=\"figure-block\"><h2>Measured and predicted{}</h2>\n{}"
      "<div class=\"loops loops-{}\">\n{}</div></section>\n",
      more > 0 ? fmt::format(" <small>{} more component{} below</small>", more, more > 1 ? "s" : "")
               : std::string(),
      figures.can_draw() ? legend_html(legend) : std::string(), columns_of(chosen.size()), cells);
}

}  // namespace pliant::report
