#include "pliant/estimation/solid/solid_starts.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/solid/energy_growth.h"
#include "pliant/estimation/solid/pair_terms.h"
#include "pliant/material/addend/rubber_addends.h"
#include "pliant/material/solid/pair_metric.h"
#include "pliant/material/solid/principal_metric.h"
#include "pliant/material/solid/solid_density.h"

namespace pliant {
namespace {

constexpr std::size_t kMostStarts = 64;

/// Where friction begins: shares of the largest stress and strain.
constexpr double kFriction = 0.05;

ScalarCurve first_curve(CurveKind kind, const MetricData& seen, const DataScale& data, bool even) {
  const double stiffness = data.stress / data.strain;
  switch (kind) {
    case CurveKind::none:
      return ScalarCurve::none();
    case CurveKind::constant:
      return ScalarCurve::constant(stiffness);
    case CurveKind::affine:
      return ScalarCurve::affine(stiffness, 0);
    case CurveKind::hermite:
    case CurveKind::spline:
      return ScalarCurve::spline({0}, {stiffness}, even);
    case CurveKind::energy:
      return quadratic_energy(stiffness, energy_places(seen, even, 1), even);
  }
  return ScalarCurve::none();
}

std::vector<Addend> more_addends(const std::vector<Addend>& before, const AddendKind& kind,
                                 const std::vector<double>& start, const DataScale& data) {
  Eigen::VectorXd values(std::ssize(start));
  for (std::size_t i = 0; i < start.size(); ++i) {
    values(static_cast<Eigen::Index>(i)) =
        start[i] * data_unit(kind.parameters[i], data.stress, data.strain, data.seconds);
  }
  std::vector<Addend> addends = before;
  addends.emplace_back(kind, values);
  return addends;
}

/// The addends of a component at all combinations; of two of a kind the second begins no earlier in
/// the kind's list than the first, as they may change places.
std::vector<std::vector<Addend>> combinations(const std::vector<const AddendKind*>& kinds,
                                              const DataScale& data) {
  struct Choice {
    std::vector<Addend> addends;
    std::size_t last = 0;
  };
  std::vector<Choice> choices{{}};
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const bool again = k > 0 && kinds[k] == kinds[k - 1];
    std::vector<Choice> more;
    for (const Choice& choice : choices) {
      for (std::size_t s = again ? choice.last : 0; s < kinds[k]->starts.size(); ++s) {
        more.push_back({more_addends(choice.addends, *kinds[k], kinds[k]->starts[s], data), s});
      }
    }
    choices = std::move(more);
  }
  std::vector<std::vector<Addend>> result;
  for (Choice& choice : choices) result.push_back(std::move(choice.addends));
  return result;
}

MaterialComponent first_component(const std::string& name, const ComponentModel& model,
                                  const MetricData& seen, const DataScale& data) {
  MaterialComponent component;
  const CurveKind kind =
      model.stiffness.value_or(model.addends.empty() ? CurveKind::spline : CurveKind::none);
  component.stiffness = first_curve(kind, seen, data, is_even(name));
  if (model.friction && model.friction->choice == FrictionChoice::dahl) {
    component.friction = ComponentFriction{
        {kFriction * data.stress, kFriction * data.stress / data.strain, 0.1 * data.strain}, {}};
  }
  return component;
}

/// Where the stiffness of a component begins: that of the volume, which data of any solid tells
/// little of, at several places above that of what is pulled.
std::vector<DataScale> first_scales(const std::string& component, SolidProblem& problem) {
  if (!is_of_volume(component)) return {problem.data_of(component).scale};
  const DataScale pulled = problem.data_of("fibre.x").scale;
  std::vector<DataScale> scales;
  for (const double times : {3.0, 30.0}) {
    scales.push_back({.stress = times * pulled.stress, .strain = pulled.strain});
  }
  return scales;
}

void refuse(const FitSettings& settings, const std::string& component, std::string problem,
            std::string expected) {
  throw InputError({settings.file, 0, "model.components." + component}, std::move(problem),
                   std::move(expected));
}

/// The choices of where the addends of a component begin. The lines of terms of two strains begin
/// at zero: those add to an energy that has a start without them.
std::vector<std::vector<Addend>> first_addends(const std::string& name, const ComponentModel& model,
                                               const DataScale& scale) {
  const bool is_line = model.addends.size() == 1 && model.addends.front() == &linear_addend();
  if (!is_line || !find_pair_metric(name)) return combinations(model.addends, scale);
  return {{Addend(linear_addend(), Eigen::VectorXd::Zero(1))}};
}

/// Components by their names in materials: Gaussians stand for as many terms as they have places.
std::map<std::string, ComponentModel> terms_of(
    const std::map<std::string, ComponentModel>& components, SolidProblem& problem) {
  std::map<std::string, ComponentModel> terms;
  for (const auto& [name, model] : components) {
    if (model.gaussians == 0 || !problem.data_of(name).is_seen()) {
      terms[name] = model;
      continue;
    }
    for (const std::string& term : gaussian_terms(name, model.gaussians, problem)) {
      terms[term] = {CurveKind::none, FrictionChoice::none, {&linear_addend()}};
    }
  }
  return terms;
}

/// Appends starts that have a component too, with each choice of its addends.
void add_component(const std::string& name, const MaterialComponent& component,
                   const std::vector<std::vector<Addend>>& choices,
                   const std::vector<Material>& starts, std::vector<Material>& more) {
  for (const std::vector<Addend>& addends : choices) {
    for (const Material& start : starts) {
      if (more.size() >= kMostStarts) return;
      Material& own = more.emplace_back(start);
      own.components[name] = component;
      own.components[name].addends = addends;
    }
  }
}

/// Convexity in two strains is told by conditions that are linear in the numbers.
void refuse_nonlinear(const FitSettings& settings, const Material& material) {
  const auto is_pair = [](const auto& component) {
    return find_pair_metric(component.first).has_value();
  };
  const auto pair = std::ranges::find_if(material.components, is_pair);
  if (pair == material.components.end() || settings.fit.convexity == Convexity::free) return;
  if (solid_density(by_green_strains(material), {.friction = false}).law->is_linear()) return;
  refuse(settings, pair->first,
         "cannot be kept convex beside laws of Green strains that are not linear in their numbers",
         "splines, energies, constants and lines beside it, or `fit: {convexity: free}`");
}

void refuse_memory(const FitSettings& settings, const std::string& name,
                   const MaterialComponent& component) {
  if (!law_of(component).remembers()) return;
  if (settings.model.samples) {
    refuse(settings, name, "has friction or another law that remembers, and the model has samples",
           "elastic components, or a model without samples");
  }
  if (!find_principal_metric(name)) return;
  refuse(settings, name, "has friction or another law that remembers",
         "such laws on another metric than principal stretches: green.xx, I1-bar, ...");
}

}  // namespace

std::vector<Material> solid_starts(const FitSettings& settings,
                                   const std::map<std::string, ComponentModel>& components,
                                   SolidProblem& problem) {
  Material first;
  first.name = settings.name;
  first.density = settings.density;
  first.kind = MaterialKind::solid;
  std::vector<Material> starts{first};
  for (const auto& [name, model] : terms_of(components, problem)) {
    const MetricData& data = problem.data_of(name);
    if (!data.is_seen()) {
      refuse(settings, name, "changes in no experiment: the data cannot tell it",
             "components that the experiments strain (an incompressible test shows no J)");
    }
    std::vector<Material> more;
    for (const DataScale& scale : first_scales(name, problem)) {
      add_component(name, first_component(name, model, data, scale),
                    first_addends(name, model, scale), starts, more);
    }
    refuse_memory(settings, name, more.front().components.at(name));
    starts = std::move(more);
  }
  refuse_nonlinear(settings, starts.front());
  return starts;
}

}  // namespace pliant
