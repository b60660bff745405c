#include "pliant/estimation/sheet/first_laws.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "pliant/estimation/addend_starts.h"
#include "pliant/estimation/sheet/sheet_options.h"
#include "pliant/estimation/solid/pair_terms.h"

namespace pliant {
namespace {

/// What an addend answers on the first way to a strain.
double stress_at(const Addend& addend, double strain) {
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(addend.history_size());
  return std::max(addend.at(strain, 0, rest).stress, 1e-12);
}

}  // namespace

Material first_sheet_material(const FitSettings& settings, const KnownComponents& known) {
  Material material;
  material.name = settings.name;
  material.density = settings.density;
  material.membrane = settings.model.membrane;
  material.bending = settings.model.bending;
  const bool bends =
      std::ranges::any_of(known, [](const auto& component) { return is_bending(component.first); });
  material.bending_of = bends ? "sheet" : "hinges";
  const bool springs = material.bending == "spring";
  const auto give = [&](const std::string& component, double stiffness) {
    material.components[component].stiffness = ScalarCurve::hermite(
        {0.0}, {fixed_stiffness(settings.fit, {component}).value_or(stiffness)},
        is_even(component));
  };
  for (const char* component : {"stretch.weft", "stretch.warp"}) give(component, 100);
  give("shear", 20);
  for (const std::string& component : asked_metrics(settings)) {
    if (is_sheet_pair(component)) {
      set_law(material.components[component],
              first_pair_law(model_of(settings, {component}).addends));
    } else {
      give(component, 1);
    }
  }
  for (const char* component : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    give(component, springs ? 0.1 : 3e-6);
  }
  for (const auto& [component, law] : known) material.components[component] = law;
  return material;
}

bool asks_for(const FitSettings& settings, const std::string& component) {
  return settings.model.components.contains(component) ||
         std::ranges::any_of(settings.fit.plan, [&](const PlanStage& stage) {
           return std::ranges::find(stage.components, component) != stage.components.end();
         });
}

std::vector<std::string> asked_metrics(const FitSettings& settings) {
  std::vector<std::string> names;
  for (const SheetMetric& metric : sheet_metrics()) {
    if (asks_for(settings, std::string(metric.name))) names.emplace_back(metric.name);
  }
  for (const auto& [name, model] : settings.model.components) {
    if (is_sheet_pair(name)) names.push_back(name);
  }
  return names;
}

ComponentLaw first_pair_law(const std::vector<const AddendKind*>& addends) {
  ComponentLaw law{ScalarCurve::none()};
  for (const AddendKind* kind : addends) {
    law.addends.emplace_back(*kind, Eigen::VectorXd::Zero(std::ssize(kind->parameters)));
  }
  return law;
}

std::vector<std::string> sheet_gaussians(const std::string& pair, int count,
                                         const std::array<double, 2>& strains) {
  const PairMetric metric = *find_pair_metric(*solid_metric_of(pair));
  std::array<std::vector<double>, 2> places;
  std::array<double, 2> width{};
  for (std::size_t side = 0; side < 2; ++side) {
    const bool signs = metric.of()[side] == "green.xy";  // sheets are sheared both ways
    const double low = signs ? -strains[side] : 0;
    width[side] = (strains[side] - low) / count;
    for (int i = 0; i < count; ++i) places[side].push_back(low + (i + 0.5) * width[side]);
  }
  std::vector<std::string> names;
  for (const PairMetric& term : gaussians_at(metric, places, width)) {
    names.push_back(sheet_term_of(term));
  }
  return names;
}

std::vector<ComponentLaw> first_bending(const Material& material, const ComponentGroup& group) {
  const auto known = [&](const char* component) {
    return law_of(material.components.at(component)).elastic_secant(0);
  };
  std::vector<ComponentLaw> laws;
  const auto add = [&](double stiffness) {
    laws.push_back({ScalarCurve::hermite({0.0}, {stiffness}, is_even(group.front()))});
  };
  if (group.front() == "bend.diagonal") {
    const double mean = (known("bend.weft") + known("bend.warp")) / 2;
    for (const double share : {2.0, 1.0, 0.5, 0.25}) add(share * mean);
    return laws;
  }
  const bool springs = material.bending == "spring";
  for (double value = springs ? 0.1 : 1e-3; value > (springs ? 1e-4 : 3e-8); value *= 0.4) {
    add(value);
  }
  return laws;
}

CurveKind grown_kind(const FitSettings& settings, const ComponentGroup& group) {
  const std::optional<CurveKind> own = model_of(settings, group).stiffness;
  return own == CurveKind::spline || own == CurveKind::energy ? *own : CurveKind::hermite;
}

ScalarCurve with_points(const ScalarCurve& curve, CurveKind kind, int points, double strain,
                        int power) {
  const bool of_energies = kind == CurveKind::energy;  // rest is no point of theirs
  std::vector<double> knots, values;
  for (int i = 0; i < points; ++i) {
    const double share = of_energies ? (i + 1.0) / points : i / std::max(points - 1.0, 1.0);
    const double at = knots.emplace_back(strain * std::pow(share, power));
    switch (kind) {
      case CurveKind::energy:
        values.push_back(curve.first_moment(at));
        break;
      case CurveKind::spline:
        values.push_back(curve.value(at) + at * curve.slope(at));
        break;
      default:
        values.push_back(curve.value(at));
    }
  }
  switch (kind) {
    case CurveKind::energy:
      return ScalarCurve::energy(knots, values, curve.even());
    case CurveKind::spline:
      return ScalarCurve::spline(knots, values, curve.even());
    default:
      return ScalarCurve::hermite(knots, values, curve.even());
  }
}

ComponentModel model_of(const FitSettings& settings, const ComponentGroup& group) {
  ComponentModel model;
  for (const std::string& component : group) {
    const auto own = settings.model.components.find(component);
    if (own == settings.model.components.end()) continue;
    model = own->second;
    break;
  }
  model.friction = model.friction.value_or(settings.model.friction);
  if (!is_bending(group.front()) && !is_sheet_pair(group.front())) {
    model.addends = addends_with_branches(model, *model.friction);
  }
  return model;
}

bool asks_for_friction(const FitSettings& settings, const ComponentGroup& group) {
  return model_of(settings, group).friction->choice != FrictionChoice::none;
}

bool states_friction(const FitSettings& settings, const ComponentGroup& group) {
  return std::ranges::any_of(group, [&](const std::string& component) {
    const auto own = settings.model.components.find(component);
    return own != settings.model.components.end() && own->second.friction &&
           own->second.friction->choice != FrictionChoice::none;
  });
}

std::vector<ComponentLaw> first_friction(const ComponentLaw& elastic, double strain) {
  std::vector<ComponentLaw> laws;
  for (const double share : {0.02, 0.06, 0.2}) {
    laws.push_back(elastic);
    laws.back().friction_law = FrictionLaw::dahl;
    laws.back().friction = {0.1 * elastic.elastic_stress(strain), 0, share * strain};
  }
  return laws;
}

std::vector<ComponentLaw> first_addends(const ComponentLaw& law, const ComponentModel& model,
                                        double strain, bool remembering) {
  ComponentLaw asked{ScalarCurve::none()};
  for (const AddendKind* kind : model.addends) {
    if (remembers(*kind) != remembering) continue;
    asked.addends.emplace_back(*kind, Eigen::VectorXd::Ones(std::ssize(kind->parameters)));
  }
  if (asked.addends.empty()) return {};
  ComponentLaw beside = law;
  double share = 0.1;
  if (model.stiffness == CurveKind::none && !remembering) {
    beside.stiffness = ScalarCurve::none();
    share = 1.0 / static_cast<double>(asked.addends.size());
  }
  const double stress = law.elastic_stress(strain);
  std::vector<ComponentLaw> laws;
  for (const ComponentLaw& start : addend_starts(asked, {stress, strain})) {
    laws.push_back(beside);
    for (const Addend& addend : start.addends) {
      laws.back().addends.push_back(addend.scaled(share * stress / stress_at(addend, strain)));
    }
  }
  return laws;
}

std::string missing_addends(const FitSettings& settings, const ComponentGroup& group,
                            const ComponentLaw& law) {
  const std::size_t asked = model_of(settings, group).addends.size();
  if (law.addends.size() >= asked) return {};
  return fmt::format(
      "{} of {} addends of {} were not fitted: no stage of the fit tells them, or no loop shows "
      "those "
      "that remember",
      asked - law.addends.size(), asked, group.front());
}

}  // namespace pliant
