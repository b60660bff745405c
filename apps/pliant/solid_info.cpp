#include "apps/pliant/solid_info.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/estimation/solid/solid_laws.h"
#include "pliant/experiment/homogeneous/elliptic_range.h"
#include "pliant/material/solid/pair_metric.h"
#include "pliant/material/solid/solid_density.h"
#include "pliant/study/body_samples.h"
#include "pliant/study/solid_study.h"

#include "apps/pliant/convexity_info.h"
#include "apps/pliant/limits_info.h"
#include "apps/pliant/samples_info.h"

namespace pliant {
namespace {

std::string numbers_text(const std::string& name, const MaterialComponent& component) {
  const ComponentLaw law = law_of(component);
  const std::vector<std::string> names = parameter_names(law, name);
  const std::vector<std::string> units = parameter_units(law, units_of(name));
  const Eigen::VectorXd values = law.parameters();
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < names.size(); ++i) {
    texts.push_back(fmt::format("{} = {}{}", names[i].substr(name.size() + 1),
                                format_number(values(static_cast<Eigen::Index>(i)), kInfoDigits),
                                units[i] == "1" ? "" : " " + units[i]));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

Json component_info(const Material& material, const std::string& name, FileInfo& info) {
  const MaterialComponent& component = material.components.at(name);
  Json json{{"status", name_of(component.status)}, {"range", nullptr}, {"convex", nullptr}};
  std::string text(name_of(component.status));
  if (component.range) {
    json["range"] = {component.range->first, component.range->second};
    text += fmt::format(", from {} to {}", format_number(component.range->first, kInfoDigits),
                        format_number(component.range->second, kInfoDigits));
  }
  info.lines.push_back(labelled(name, text));
  if (!component.stiffness) return json;
  info.lines.push_back(labelled("numbers", numbers_text(name, component), 1));
  add_convexity(material, name, info, json);
  return json;
}

/// Smallest second derivative of the energy by the Green strain at rest; a change of shape alone
/// where nothing resists one of the volume.
double least_curvature_at_rest(const Material& material) {
  const NamedLaw density = solid_density(material, {.friction = false});
  Eigen::Array<double, kLanes, Eigen::Dynamic> rest =
      Eigen::Array<double, kLanes, Eigen::Dynamic>::Zero(kLanes, 6);
  const Eigen::Array<double, kLanes, Eigen::Dynamic> history =
      Eigen::Array<double, kLanes, Eigen::Dynamic>::Zero(kLanes, density.law->history_size());
  const LaneView strain(rest.data(), kLanes, 6);
  Response response(6);
  density.law->add({strain, strain, strain, LaneView(history.data(), kLanes, history.cols())}, {},
                   response);
  Eigen::MatrixXd tangent(6, 6);
  for (int k = 0; k < 36; ++k) tangent(k / 6, k % 6) = response.tangent(0, k);
  const bool isochoric = std::ranges::all_of(material.components, [](const auto& component) {
    return !component.second.stiffness || component.first.ends_with("-bar");
  });
  if (isochoric) tangent.topLeftCorner(3, 3).array() += tangent.cwiseAbs().maxCoeff();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(tangent).eigenvalues()(0);
}

std::string size_text(const EllipticRange& range, double size) {
  return range.way == "shear" ? "a shear of " + format_number(size, kInfoDigits)
                              : "a stretch of " + format_number(size, kInfoDigits);
}

/// Where strong ellipticity is lost, way by way; what was looked at otherwise.
void add_ellipticity(const Material& material, FileInfo& info) {
  Json json = Json::array();
  std::vector<std::string> lost;
  for (const EllipticRange& range : elliptic_ranges(material)) {
    Json& own = json.emplace_back(Json{{"way", range.way},
                                       {"compressed", range.compressed},
                                       {"looked_at_to", range.reach},
                                       {"lost_at", nullptr},
                                       {"limit_reached", range.limited}});
    if (range.limited) {
      info.lines.push_back(labelled(range.way,
                                    "no further than " + size_text(range, range.reach) +
                                        ": a limit, or no equilibrium across",
                                    1));
    }
    if (!range.lost) continue;
    own["lost_at"] = range.at;
    lost.push_back(range.way + " from " + size_text(range, range.at) + " on");
  }
  info.json["strong_ellipticity"] = std::move(json);
  info.lines.push_back(
      labelled("elliptic",
               lost.empty() ? "wherever it was looked at (stretches of 0.25 to 4, shears to 3)"
                            : fmt::format("not {}", fmt::join(lost, "; ")),
               1));
  if (lost.empty()) return;
  info.warnings.push_back(fmt::format(
      "strong ellipticity is lost, {}: deformation may concentrate in bands as thin as the mesh",
      fmt::join(lost, "; ")));
}

}  // namespace

void add_solid(const Material& material, FileInfo& info) {
  info.lines.push_back(labelled(
      "density", material.density > 0
                     ? format_quantity(material.density, Dimension::volume_density, kInfoDigits)
                     : "not stated"));
  Json components = Json::object();
  for (const std::string& name : ordered_components(material.components, material.kind)) {
    components[name] = component_info(material, name, info);
  }
  info.json["components"] = std::move(components);
  add_samples(material, info);
  add_limits(material, info);
  const double least = least_curvature_at_rest(material);
  info.json["least_curvature_at_rest_Pa"] = least;
  info.lines.push_back(
      labelled("at rest", fmt::format("the energy curves by {} or more in every strain",
                                      format_quantity(least, Dimension::stress, kInfoDigits))));
  if (least >= 0) {
    add_ellipticity(material, info);
    return;
  }
  info.warnings.push_back(fmt::format(
      "the material is not stable at rest: its energy falls in some strain (curvature {}), so that "
      "a body flies apart instead of coming back",
      format_quantity(least, Dimension::stress, kInfoDigits)));
}

void add_solid_experiments(const Study& study, FileInfo& info) {
  info.json["experiments"] = Json::array();
  for (const ExperimentSpec& spec : study.experiments) {
    const auto experiment = spec.test->type().make_solid(spec, DataRows(spec.data));
    const ExperimentInfo& about = experiment->info();
    info.lines.push_back(labelled(
        spec.name,
        fmt::format("{}, {}", spec.type,
                    spec.role == ExperimentRole::fit ? "fitted" : "predicted, not fitted")));
    for (const auto& [key, value] : spec.test->fields()) {
      info.lines.push_back(labelled(key, value, 1));
    }
    const bool stress = about.quantity.kind == "stress";
    const Dimension measured = stress ? Dimension::stress : Dimension::force;
    const std::string reach =
        about.measures_readings()
            ? "in units of their noise"
            : "up to " + format_quantity(experiment->reference(), measured, kInfoDigits);
    info.lines.push_back(
        labelled("data", fmt::format("{} rows, {}", experiment->rows(), reach), 1));
    for (const std::string& text : about.handled) {
      info.lines.push_back(labelled("handled", text, 1));
    }
    for (const std::string& text : about.warnings) info.warnings.push_back(spec.name + ": " + text);
    info.json["experiments"].push_back({{"name", spec.name},
                                        {"type", spec.type},
                                        {"rows", experiment->rows()},
                                        {"handled", about.handled}});
    if (!about.measures_readings()) {
      info.json["experiments"].back()[stress ? "peak_stress_Pa" : "peak_force_N"] =
          experiment->reference();
    }
  }
  std::vector<std::string> components;
  for (const auto& [name, model] : solid_components(study.model, is_compressible(study))) {
    components.push_back(name);
  }
  const std::string law = study.model.components.empty() ? study.model.solid_law : "of its own";
  info.json["fit"] = {{"law", law}, {"components", components}};
  if (study.model.samples) {
    const MaterialSamples samples = body_samples(study);
    info.json["fit"]["samples"] = samples.at.size();
    info.lines.push_back(labelled(
        "samples", fmt::format("{} places with Gaussians of {}", samples.at.size(),
                               format_quantity(samples.width, Dimension::length, kInfoDigits))));
  }
  info.lines.push_back(
      labelled("fit", fmt::format("all together; law {}: {}", law, fmt::join(components, ", "))));
}

}  // namespace pliant
