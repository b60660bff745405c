#include "pliant/report/verdict.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "pliant/experiment/registry.h"
#include "pliant/report/labels.h"
#include "pliant/report/number_format.h"

namespace pliant::report {
namespace {

/// The parameters of one component that describe one thing: its stiffness or its friction.
struct ParameterGroup {
  std::string title;  ///< `friction of stretch.bias`
  std::vector<std::string> undetermined;
  std::size_t free = 0;
};

std::vector<ParameterGroup> group_parameters(const std::vector<ResultParameter>& parameters) {
  std::vector<ParameterGroup> groups;
  for (const ResultParameter& p : parameters) {
    const bool friction = is_of_friction(p.name);
    const std::string title =
        fmt::format("{} of {}", friction ? "friction" : "stiffness", p.component);
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const ParameterGroup& g) { return g.title == title; });
    if (group == groups.end()) group = groups.insert(groups.end(), {title, {}, 0});
    if (p.fixed) continue;
    ++group->free;
    if (!p.identified) group->undetermined.push_back(p.name);
  }
  return groups;
}

/// `a, b and c`, or `a, b, c and 5 more` of a long list.
std::string joined(std::vector<std::string> items) {
  constexpr std::size_t kMost = 4;
  if (items.empty()) return {};
  if (items.size() > kMost) {
    const std::size_t more = items.size() - (kMost - 1);
    items.resize(kMost - 1);
    items.push_back(fmt::format("{} more", more));
  }
  if (items.size() == 1) return items.front();
  const auto last = items.end() - 1;
  return fmt::format("{} and {}", fmt::join(items.begin(), last, ", "), *last);
}

std::string counted(std::size_t count, std::string_view singular) {
  return fmt::format("{} {}{}", count, singular, count == 1 ? "" : "s");
}

using Experiments = std::vector<const ResultExperiment*>;

/// The experiments of a role, or all of an evaluation: there nothing is fitted.
Experiments experiments_of(const Results& results, bool validation) {
  Experiments chosen;
  for (const ResultExperiment& e : results.experiments) {
    if ((results.evaluation || e.validation) == validation) chosen.push_back(&e);
  }
  return chosen;
}

Experiments with_percent(const Experiments& experiments) {
  Experiments chosen;
  std::copy_if(experiments.begin(), experiments.end(), std::back_inserter(chosen),
               [](const ResultExperiment* e) { return e->rms_percent_of_peak.has_value(); });
  return chosen;
}

double largest_percent(const Experiments& experiments) {
  double largest = 0.0;
  for (const ResultExperiment* e : experiments) {
    largest = std::max(largest, *e->rms_percent_of_peak);
  }
  return largest;
}

/// What the percentages are of.
std::string_view reference(const Experiments& experiments) {
  const auto overhangs = std::count_if(experiments.begin(), experiments.end(),
                                       [](const auto* e) { return e->measures_overhangs(); });
  if (overhangs == std::ssize(experiments)) return "the mean overhang";
  if (overhangs > 0) return "peak force, range of lengths or overhang";
  const auto lengths = std::count_if(experiments.begin(), experiments.end(),
                                     [](const auto* e) { return e->measures_lengths(); });
  const auto spans = std::count_if(experiments.begin(), experiments.end(), [](const auto* e) {
    return facts_of_test(e->type).has_unknown_zero;
  });
  if (spans == std::ssize(experiments)) return "the span of the force";
  if (lengths == 0) return spans == 0 ? "peak force" : "the peak or span of force";
  return lengths == std::ssize(experiments) ? "the range of the lengths"
                                            : "peak force or range of lengths";
}

std::string fit_sentence(const Experiments& all) {
  const Experiments fitted = with_percent(all);
  if (fitted.empty()) return {};
  Experiments reproduced;
  std::vector<std::string> missed;
  for (const ResultExperiment* e : fitted) {
    if (*e->rms_percent_of_peak <= kReproducedPercent) {
      reproduced.push_back(e);
    } else {
      missed.push_back(fmt::format("{} ({})", e->name, format_percent(e->rms_percent_of_peak)));
    }
  }
  if (reproduced.empty()) {
    return fmt::format(
        "The material reproduces none of {} within {:.0f} % of {}; the RMS error reaches {}. ",
        counted(fitted.size(), "fitted experiment"), kReproducedPercent, reference(fitted),
        format_percent(largest_percent(fitted)));
  }
  std::string sentence =
      fmt::format("The material reproduces {} of {} within {} of {}", reproduced.size(),
                  counted(fitted.size(), "fitted experiment"),
                  format_percent(largest_percent(reproduced)), reference(fitted));
  if (!missed.empty()) sentence += fmt::format(", but not {}", joined(missed));
  return sentence + ". ";
}

std::string prediction_sentence(const Experiments& all, bool evaluation) {
  const Experiments predicted = with_percent(all);
  if (predicted.empty()) return {};
  return fmt::format("{} {} predicted within {} of {}. ",
                     counted(predicted.size(), evaluation ? "experiment" : "validation experiment"),
                     predicted.size() == 1 ? "is" : "are",
                     format_percent(largest_percent(predicted)), reference(predicted));
}

/// Where only positions are compared there is no force to take a percentage of.
std::string position_sentence(const std::vector<ResultExperiment>& experiments) {
  struct Compared {
    std::size_t count = 0;
    double largest = 0;  // mm
  };
  Compared lengths, profiles, sheets;
  for (const ResultExperiment& e : experiments) {
    if (e.rms_percent_of_peak || !e.rms_position_mm) continue;
    Compared& own = e.measures_sheets()                   ? sheets
                    : e.rms_percent_of_length.has_value() ? profiles
                                                          : lengths;
    ++own.count;
    own.largest = std::max(own.largest, *e.rms_position_mm);
  }
  std::string text;
  if (lengths.count > 0) {
    text +=
        fmt::format("In {} the RMS error of the lengths is at most {} mm. ",
                    counted(lengths.count, "experiment"), format_significant(lengths.largest, 2));
  }
  if (profiles.count > 0) {
    text +=
        fmt::format("In {} the strips lie within {} mm (RMS) of the predicted profiles. ",
                    counted(profiles.count, "experiment"), format_significant(profiles.largest, 2));
  }
  if (sheets.count > 0) {
    text += fmt::format("In {} the sheets lie within {} mm (RMS) of the predicted ones. ",
                        counted(sheets.count, "experiment"), format_significant(sheets.largest, 2));
  }
  return text;
}

std::string undetermined_sentence(const std::vector<std::string>& items) {
  if (items.empty()) return {};
  return fmt::format("The data do not determine {}. ", joined(items));
}

/// What a statement is about: `a.b` of `a.b (reason)` or `a.b: reason`.
std::string_view subject(std::string_view text) {
  return text.substr(0, std::min(text.find(" ("), text.find(": ")));
}

bool is_friction_of_any(const std::string& item, const std::vector<std::string>& components) {
  return std::any_of(components.begin(), components.end(), [&](const std::string& component) {
    return item == "friction of " + component;
  });
}

/// Such a parameter is named already, alone or within its group.
bool is_undetermined_parameter(const Results& results, std::string_view name) {
  return std::any_of(results.parameters.begin(), results.parameters.end(),
                     [&](const auto& p) { return p.name == name && !p.fixed && !p.identified; });
}

}  // namespace

std::vector<std::string> loading_only_components(const Results& results) {
  std::vector<std::pair<std::string, bool>> unloads;  // in the order of the experiments
  for (const ResultExperiment& e : results.experiments) {
    if (e.validation && !results.evaluation) continue;
    if (e.measures_sheets()) continue;  // fitted as elastic: friction is out of the question
    auto known = std::find_if(unloads.begin(), unloads.end(),
                              [&](const auto& entry) { return entry.first == e.component; });
    if (known == unloads.end()) known = unloads.insert(known, {e.component, false});
    known->second = known->second || e.unloads || e.measured_loop.has_value();
  }
  std::vector<std::string> components;
  for (const auto& [component, yes] : unloads) {
    if (!yes) components.push_back(component);
  }
  return components;
}

std::vector<std::string> undetermined(const Results& results) {
  std::vector<std::string> items;
  for (const ParameterGroup& group : group_parameters(results.parameters)) {
    if (group.undetermined.empty()) continue;
    if (group.undetermined.size() == group.free) {
      items.push_back(group.title);
    } else {
      items.insert(items.end(), group.undetermined.begin(), group.undetermined.end());
    }
  }
  for (const std::string& component : loading_only_components(results)) {
    const std::string friction = "friction of " + component;
    if (std::find(items.begin(), items.end(), friction) == items.end()) items.push_back(friction);
  }
  return items;
}

std::vector<std::string> undetermined_with_reasons(const Results& results) {
  const std::vector<std::string> loading_only = loading_only_components(results);
  std::vector<std::string> items = undetermined(results);
  std::vector<std::string> unused = results.undetermined;
  for (std::string& item : items) {
    const auto stated = std::find_if(unused.begin(), unused.end(), [&](const std::string& text) {
      return subject(text) == item;
    });
    if (stated != unused.end()) {
      item = *stated;
      unused.erase(stated);
    } else if (is_friction_of_any(item, loading_only)) {
      item += ": its data never unload";
    }
  }
  for (const std::string& text : unused) {
    if (!is_undetermined_parameter(results, subject(text))) items.push_back(text);
  }
  return items;
}

std::vector<std::string> warnings_of(const Results& results, bool on_page_one) {
  constexpr std::size_t kOnPageOne = 4;
  const std::size_t all = results.warnings.size();
  const std::size_t first = std::min(results.questions.size(), all);
  const std::size_t last = std::min(first + kOnPageOne, all);
  const auto at = [&](std::size_t i) {
    return results.warnings.begin() + static_cast<std::ptrdiff_t>(i);
  };
  return on_page_one ? std::vector(at(first), at(last)) : std::vector(at(last), at(all));
}

std::string verdict(const Results& results) {
  std::string text;
  if (!results.converged) {
    text += "The fit did not converge: its numbers are where it stopped, not an optimum. ";
  }
  if (!results.evaluation) text += fit_sentence(experiments_of(results, false));
  text += prediction_sentence(experiments_of(results, true), results.evaluation);
  text += position_sentence(results.experiments);
  if (!results.evaluation) text += undetermined_sentence(undetermined(results));
  if (text.empty()) return "There is no experiment to judge the material by.";
  text.pop_back();
  return text;
}

}  // namespace pliant::report
