#include "pliant/estimation/unknown.h"

#include <algorithm>
#include <cstddef>

#include "pliant/estimation/parameter_option.h"
#include "pliant/material/material.h"

namespace pliant {
namespace {

constexpr double kAlike = 0.02;  // N, of the cords of a clip

void limit_stiffness(const ComponentLaw& law, const DataScale& data,
                     std::vector<Unknown>& unknowns) {
  const double stiffness = data.stress / data.strain;
  for (int i = 0; i < law.stiffness.size(); ++i) {
    Unknown& unknown = unknowns[static_cast<std::size_t>(i)];
    unknown.scale = stiffness;
    if (law.stiffness.has_knots()) {
      unknown.strain = law.stiffness.knots()[static_cast<std::size_t>(i)];
    }
    if (law.stiffness.kind() == CurveKind::energy) {
      unknown.scale *= *unknown.strain * *unknown.strain / 2;
    }
  }
  // k2 of an affine stiffness multiplies the strain once more.
  if (law.stiffness.kind() == CurveKind::affine) unknowns[1].scale = stiffness / data.strain;
}

void limit_friction(const ComponentLaw& law, const DataScale& data,
                    std::vector<Unknown>& unknowns) {
  const double stiffness = data.stress / data.strain;
  const auto first = static_cast<std::size_t>(law.stiffness.size());
  Unknown &a = unknowns[first], &b = unknowns[first + 1], &third = unknowns[first + 2];
  a.scale = 0.2 * data.stress;
  b.scale = 0.2 * stiffness;
  if (law.friction_law == FrictionLaw::dahl) {
    third.lower = 1e-3 * data.strain;
    third.upper = 3 * data.strain;
    third.scale = 0.1 * data.strain;
  } else {
    a.lower = 1e-9 * data.stress;
    third.lower = 1e-3 * stiffness;
    third.upper = 1e4 * stiffness;
    third.scale = stiffness;
  }
  for (std::size_t i = first; i < first + 3; ++i) unknowns[i].of_friction = true;
}

void limit_addends(const ComponentLaw& law, const DataScale& data, std::vector<Unknown>& unknowns) {
  auto next = static_cast<std::size_t>(law.first_addend_parameter());
  for (const Addend& addend : law.addends) {
    for (const AddendParameter& parameter : addend.kind().parameters) {
      Unknown& unknown = unknowns[next++];
      const double unit = data_unit(parameter, data.stress, data.strain, data.seconds);
      unknown.lower = parameter.smallest * unit;
      if (parameter.largest > 0) unknown.upper = parameter.largest * unit;
      unknown.scale = parameter.step * unit;
      unknown.of_friction = !addend.is_elastic();
    }
  }
}

/// What a study calls a parameter that is a control value: COMPONENT.k.
std::string without_number(const std::string& parameter) {
  return parameter.ends_with(']') ? parameter.substr(0, parameter.rfind('[')) : parameter;
}

template <class T>
std::optional<T> option_of(const Unknown& unknown, const std::map<std::string, T>& options) {
  for (const std::string& parameter : unknown.parameters) {
    if (auto value = option_for(parameter, options)) return value;
    if (auto value = option_for(without_number(parameter), options)) return value;
  }
  return std::nullopt;
}

}  // namespace

void Unknown::hold(double value) {
  start = lower = upper = value;
  prior.reset();
  fixed = true;
}

std::vector<Unknown> unknowns_of(const ComponentLaw& law, const ComponentGroup& group,
                                 const DataScale& data) {
  const std::vector<std::string> names = parameter_names(law, group.front());
  const std::vector<std::string> units = parameter_units(law, units_of(group.front()));
  const Eigen::VectorXd values = law.parameters();
  std::vector<Unknown> unknowns(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    unknowns[i].name = names[i];
    unknowns[i].owner = group.front();
    unknowns[i].unit = units[i];
    unknowns[i].start = values(static_cast<Eigen::Index>(i));
    for (const std::string& component : group) {
      unknowns[i].parameters.push_back(component + names[i].substr(group.front().size()));
    }
  }
  limit_stiffness(law, data, unknowns);
  if (law.friction_law != FrictionLaw::none) limit_friction(law, data, unknowns);
  limit_addends(law, data, unknowns);
  return unknowns;
}

Unknown unknown_of(const EnergyLimit& limit, MaterialKind kind) {
  constexpr double kLeast = 1e-6, kStep = 0.1;  // of where it begins
  Unknown unknown;
  unknown.name = unknown.owner = limit_name(limit.of);
  unknown.unit = kind == MaterialKind::solid ? "Pa" : "J/m^2";
  unknown.parameters = {unknown.name};
  unknown.start = limit.energy;
  unknown.lower = kLeast * limit.energy;
  unknown.scale = kStep * limit.energy;
  return unknown;
}

std::vector<Unknown> unknowns_of(const Experiment& experiment) {
  std::vector<Unknown> unknowns;
  for (const NuisanceParameter& own : experiment.nuisance()) {
    Unknown unknown;
    unknown.name = own.name;
    unknown.owner = experiment.info().name;
    unknown.unit = own.unit;
    unknown.parameters = {own.name};
    unknown.start = own.start;
    unknown.lower = own.lower;
    unknown.upper = own.upper;
    unknown.scale = own.scale;
    unknown.prior = own.prior;
    unknown.together = own.together;
    unknown.of_material = false;
    unknown.of_friction = own.of_friction;
    unknowns.push_back(std::move(unknown));
  }
  return unknowns;
}

void apply_options(const FitOptions& options, std::vector<Unknown>& unknowns) {
  for (Unknown& unknown : unknowns) {
    if (const auto bounds = option_of(unknown, options.bounds)) {
      unknown.lower = bounds->first;
      unknown.upper = bounds->second;
    }
    if (const auto prior = option_of(unknown, options.priors)) unknown.prior = prior;
    if (const auto value = option_of(unknown, options.fix)) unknown.hold(*value);
  }
}

double SumPrior::miss(const Eigen::VectorXd& values) const {
  double off = -mean;
  for (const auto& [unknown, factor] : sum) off += factor * values(unknown);
  return off / sd;
}

std::vector<SumPrior> priors_of(const std::vector<Unknown>& unknowns) {
  std::vector<SumPrior> priors;
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    const Unknown& own = unknowns[u];
    if (own.fixed) continue;
    const auto place = static_cast<Eigen::Index>(u);
    if (own.prior) priors.push_back({{{place, 1.0}}, own.prior->mean, own.prior->sd});
    const bool alike = u > 0 && !own.together.empty() && unknowns[u - 1].together == own.together;
    if (alike && !unknowns[u - 1].fixed) {
      priors.push_back({{{place - 1, -1.0}, {place, 1.0}}, 0, kAlike});
    }
  }
  return priors;
}

int free_count(const std::vector<Unknown>& unknowns) {
  return static_cast<int>(std::ranges::count_if(
      unknowns, [](const Unknown& unknown) { return unknown.lower < unknown.upper; }));
}

Eigen::VectorXd starts_of(const std::vector<Unknown>& unknowns) {
  Eigen::VectorXd starts(static_cast<Eigen::Index>(unknowns.size()));
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    starts(static_cast<Eigen::Index>(u)) =
        std::clamp(unknowns[u].start, unknowns[u].lower, unknowns[u].upper);
  }
  return starts;
}

}  // namespace pliant
