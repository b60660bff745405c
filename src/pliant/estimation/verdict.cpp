#include "pliant/estimation/verdict.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/estimation/fit_result.h"
#include "pliant/experiment/registry.h"

namespace pliant {
namespace {

/// The parameters of one component that describe one thing: its stiffness or its friction.
struct ParameterGroup {
  std::string title;  ///< `friction of stretch.bias`
  std::vector<std::string> undetermined;
  std::size_t free = 0;
};

std::vector<ParameterGroup> group_parameters(const std::vector<ParameterEstimate>& parameters) {
  std::vector<ParameterGroup> groups;
  for (const ParameterEstimate& p : parameters) {
    const std::string title =
        fmt::format("{} of {}", p.of_friction ? "friction" : "stiffness", p.owner);
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

using Experiments = std::vector<const ExperimentResult*>;

/// Whether an error is told in per cent: a distance has no peak, but a size of its own.
bool has_percent(const ExperimentResult& e) {
  return e.quantity.kind != "distance" && std::isfinite(e.rms_percent);
}

/// The experiments of a role, or all of an evaluation: there nothing is fitted.
Experiments with_percent(const StudyResult& result, ExperimentRole role, bool evaluation) {
  Experiments chosen;
  for (const ExperimentResult& e : result.experiments) {
    if ((evaluation || e.role == role) && has_percent(e)) chosen.push_back(&e);
  }
  return chosen;
}

double largest_share(const Experiments& experiments) {
  double largest = 0;
  for (const ExperimentResult* e : experiments) largest = std::max(largest, e->rms_percent / 100);
  return largest;
}

/// What the percentages are of.
std::string_view reference(const Experiments& experiments) {
  const auto count = [&](const auto& is) { return std::ranges::count_if(experiments, is); };
  const auto all = std::ssize(experiments);
  const auto overhangs =
      count([](const auto* e) { return e->quantity.name.starts_with("overhang"); });
  if (overhangs == all) return "the mean overhang";
  if (overhangs > 0) return "peak force, range of lengths or overhang";
  const auto readings = count([](const auto* e) { return e->quantity.kind == "reading"; });
  if (readings == all) return "the largest reading";
  const auto lengths = count([](const auto* e) { return e->quantity.kind == "length"; });
  const auto spans = count([](const auto* e) { return facts_of_test(e->type).has_unknown_zero; });
  if (spans == all) return "the span of the force";
  if (lengths == 0) return spans == 0 ? "peak force" : "the peak or span of force";
  return lengths == all ? "the range of the lengths" : "peak force or range of lengths";
}

std::string fit_sentence(const Experiments& fitted, double accepted) {
  if (fitted.empty()) return {};
  Experiments reproduced;
  std::vector<std::string> missed;
  for (const ExperimentResult* e : fitted) {
    if (e->rms_percent / 100 <= accepted) {
      reproduced.push_back(e);
    } else {
      missed.push_back(fmt::format("{} ({})", e->name, in_percent(e->rms_percent / 100)));
    }
  }
  if (reproduced.empty()) {
    return fmt::format(
        "The material reproduces none of {} within {} of {}; the RMS error reaches {}. ",
        counted(fitted.size(), "fitted experiment"), in_percent(accepted), reference(fitted),
        in_percent(largest_share(fitted)));
  }
  std::string sentence = fmt::format("The material reproduces {} of {} within {} of {}",
                                     reproduced.size(), counted(fitted.size(), "fitted experiment"),
                                     in_percent(largest_share(reproduced)), reference(fitted));
  if (!missed.empty()) sentence += fmt::format(", but not {}", joined(missed));
  return sentence + ". ";
}

std::string prediction_sentence(const Experiments& predicted, bool evaluation) {
  if (predicted.empty()) return {};
  return fmt::format("{} {} predicted within {} of {}. ",
                     counted(predicted.size(), evaluation ? "experiment" : "validation experiment"),
                     predicted.size() == 1 ? "is" : "are", in_percent(largest_share(predicted)),
                     reference(predicted));
}

/// Where only positions are compared there is no force to take a percentage of.
std::string position_sentence(const std::vector<ExperimentResult>& experiments) {
  struct Compared {
    std::size_t count = 0;
    double largest = 0;  // m
  };
  Compared lengths, profiles, sheets;
  for (const ExperimentResult& e : experiments) {
    const bool distance = e.quantity.kind == "distance";
    const bool position = distance || e.quantity.kind == "length";
    if (!position || has_percent(e) || !std::isfinite(e.rms)) continue;
    Compared& own = e.sheet ? sheets : distance ? profiles : lengths;
    ++own.count;
    own.largest = std::max(own.largest, e.rms);
  }
  std::string text;
  if (lengths.count > 0) {
    text += fmt::format("In {} the RMS error of the lengths is at most {:.2g} mm. ",
                        counted(lengths.count, "experiment"), 1e3 * lengths.largest);
  }
  if (profiles.count > 0) {
    text += fmt::format("In {} the strips lie within {:.2g} mm (RMS) of the predicted profiles. ",
                        counted(profiles.count, "experiment"), 1e3 * profiles.largest);
  }
  if (sheets.count > 0) {
    text += fmt::format("In {} the sheets lie within {:.2g} mm (RMS) of the predicted ones. ",
                        counted(sheets.count, "experiment"), 1e3 * sheets.largest);
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
bool is_undetermined_parameter(const StudyResult& result, std::string_view name) {
  return std::ranges::any_of(result.parameters, [&](const ParameterEstimate& p) {
    return p.name == name && !p.fixed && !p.identified;
  });
}

/// Components none of whose fitted (in an evaluation: compared) data ever unload: they say nothing
/// about friction.
std::vector<std::string> loading_only_components(const StudyResult& result, bool evaluation) {
  std::vector<std::pair<std::string, bool>> unloads;  // in the order of the experiments
  for (const ExperimentResult& e : result.experiments) {
    if (e.role == ExperimentRole::validate && !evaluation) continue;
    // The stages of sheets say themselves what friction they tell; a solid's components have their
    // experiments together.
    if (e.sheet || e.component.empty()) continue;
    auto known = std::ranges::find(unloads, e.component, &std::pair<std::string, bool>::first);
    if (known == unloads.end()) known = unloads.insert(known, {e.component, false});
    known->second = known->second || e.unloads || e.measured_loop.has_value();
  }
  std::vector<std::string> components;
  for (const auto& [component, yes] : unloads) {
    if (!yes) components.push_back(component);
  }
  return components;
}

}  // namespace

std::vector<std::string> undetermined(const StudyResult& result, bool evaluation) {
  std::vector<std::string> items;
  for (const ParameterGroup& group : group_parameters(result.parameters)) {
    if (group.undetermined.empty()) continue;
    if (group.undetermined.size() == group.free) {
      items.push_back(group.title);
    } else {
      items.insert(items.end(), group.undetermined.begin(), group.undetermined.end());
    }
  }
  for (const std::string& component : loading_only_components(result, evaluation)) {
    const std::string friction = "friction of " + component;
    if (std::ranges::find(items, friction) == items.end()) items.push_back(friction);
  }
  return items;
}

std::vector<std::string> undetermined_with_reasons(const StudyResult& result, bool evaluation) {
  const std::vector<std::string> loading_only = loading_only_components(result, evaluation);
  std::vector<std::string> items = undetermined(result, evaluation);
  std::vector<std::string> unused = result.undetermined;
  for (std::string& item : items) {
    const auto stated = std::ranges::find_if(
        unused, [&](const std::string& text) { return subject(text) == item; });
    if (stated != unused.end()) {
      item = *stated;
      unused.erase(stated);
    } else if (is_friction_of_any(item, loading_only)) {
      item += ": its data never unload";
    }
  }
  for (const std::string& text : unused) {
    if (!is_undetermined_parameter(result, subject(text))) items.push_back(text);
  }
  return items;
}

std::string verdict(const StudyResult& result, const Acceptance& accept, bool evaluation) {
  std::string text;
  if (!result.converged) {
    text += "The fit did not converge: its numbers are where it stopped, not an optimum. ";
  }
  if (!evaluation) {
    text += fit_sentence(with_percent(result, ExperimentRole::fit, false), accept.rms);
  }
  text +=
      prediction_sentence(with_percent(result, ExperimentRole::validate, evaluation), evaluation);
  text += position_sentence(result.experiments);
  if (!evaluation) text += undetermined_sentence(undetermined(result, evaluation));
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace pliant
