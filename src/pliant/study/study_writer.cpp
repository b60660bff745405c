#include <yaml-cpp/yaml.h>

#include "pliant/base/quantity.h"
#include "pliant/study/study.h"

namespace pliant {
namespace {

std::string_view name_of(FrictionChoice choice) {
  switch (choice) {
    case FrictionChoice::automatic:
      return "auto";
    case FrictionChoice::dahl:
      return "dahl";
    case FrictionChoice::none:
      return "none";
  }
  return "";
}

YAML::Node texts_node(const std::map<std::string, std::string>& texts) {
  YAML::Node node(YAML::NodeType::Map);
  for (const auto& [key, value] : texts) node[key] = value;
  return node;
}

YAML::Node data_node(const DataSource& data, const std::filesystem::path& directory) {
  // A pattern stays one: the folder of its first file, made relative to where the text will stand.
  const std::filesystem::path folder = data.files.front().parent_path();
  const std::filesystem::path written =
      (folder / std::filesystem::path(data.written).filename()).lexically_normal();
  std::error_code error;
  // The folder of a study that was named without one is empty: the working directory.
  std::filesystem::path relative = std::filesystem::proximate(
      std::filesystem::absolute(written), std::filesystem::absolute(directory / "."), error);
  if (error) relative = written;
  if (data.csv.columns.empty() && data.csv.encoding.empty() && data.csv.skip_rows == 0) {
    return YAML::Node(relative.generic_string());
  }
  YAML::Node node;
  node["file"] = relative.generic_string();
  if (!data.csv.columns.empty()) node["columns"] = texts_node(data.csv.columns);
  if (!data.csv.encoding.empty()) node["encoding"] = data.csv.encoding;
  if (data.csv.skip_rows > 0) node["skip_rows"] = data.csv.skip_rows;
  return node;
}

YAML::Node noise_node(const StatedNoise& noise, const std::string& type) {
  YAML::Node node;
  if (measures_profiles(type)) {
    node["position"] = exact_quantity(*noise.length, Dimension::length);
    return node;
  }
  if (type == "bending-length") {
    node["overhang"] = exact_quantity(*noise.length, Dimension::length);
    return node;
  }
  if (type == "pure-bending") {
    node["moment"] = exact_quantity(*noise.force, Dimension::force);
    return node;
  }
  const bool shear = type == "shear-cycles";
  if (noise.force) {
    node["force"] =
        exact_quantity(*noise.force, shear ? Dimension::force_per_length : Dimension::force);
  }
  if (noise.length) node["length"] = exact_quantity(*noise.length, Dimension::length);
  return node;
}

void add_strip(const ExperimentSpec& spec, YAML::Node& node) {
  node["direction"] = spec.direction;
  node["length"] = exact_quantity(spec.length, Dimension::length);
  node["width"] = exact_quantity(spec.width, Dimension::length);
}

void add_bent_strip(const ExperimentSpec& spec, YAML::Node& node) {
  node["direction"] = spec.direction;
  if (spec.length > 0) node["length"] = exact_quantity(spec.length, Dimension::length);
  if (spec.width > 0) node["width"] = exact_quantity(spec.width, Dimension::length);
}

void add_initial_friction(const ExperimentSpec& spec, YAML::Node& node) {
  const bool rest = spec.initial_friction == InitialFriction::rest;
  node["initial_friction"] = rest ? "rest" : "unknown";
}

void add_rest_length(const ExperimentSpec& spec, YAML::Node& node) {
  node["rest_length"] = spec.rest_length == RestLength::known ? "known" : "unknown";
}

void add_type_fields(const ExperimentSpec& spec, YAML::Node& node) {
  if (spec.type == "hanging-weights") {
    add_strip(spec, node);
    node["clip_mass"] = exact_quantity(spec.clip_mass, Dimension::mass);
    node["rested"] = spec.rested;
  } else if (spec.type == "tensile-cycles") {
    add_strip(spec, node);
    node["pretension"] = exact_quantity(spec.pretension, Dimension::force);
    node["apparatus_friction"] = exact_quantity(spec.apparatus_friction, Dimension::force);
    node["precondition_cycles"] = spec.precondition_cycles;
    add_rest_length(spec, node);
    add_initial_friction(spec, node);
  } else if (spec.type == "shear-cycles") {
    node["transverse_tension"] =
        exact_quantity(spec.transverse_tension, Dimension::force_per_length);
    add_initial_friction(spec, node);
  } else if (spec.type == "pure-bending") {
    add_bent_strip(spec, node);
    add_initial_friction(spec, node);
  } else if (spec.type == "buckling-bend") {
    add_strip(spec, node);
    node["side"] = std::string(name_of(spec.side));
    add_rest_length(spec, node);
  } else if (bends_by_weight(spec.type)) {
    add_bent_strip(spec, node);
    if (!spec.density_is_known) node["density"] = "unknown";
    if (spec.angle > 0) node["angle"] = exact_quantity(spec.angle, Dimension::angle);
  } else if (measures_sheets(spec.type)) {
    if (spec.objective) node["objective"] = std::string(name_of(*spec.objective));
    if (spec.cord_friction.unknown) {
      node["cord_friction"] = "unknown";
    } else if (spec.cord_friction.width > 0) {
      node["cord_friction"] = exact_quantity(spec.cord_friction.width, Dimension::force);
    }
  } else {
    for (const auto& [key, value] : spec.other_fields) node[key] = value;
  }
}

YAML::Node experiment_node(const ExperimentSpec& spec, const std::filesystem::path& directory) {
  YAML::Node node;
  node["name"] = spec.name;
  node["type"] = spec.type;
  node["data"] = data_node(spec.data, directory);
  add_type_fields(spec, node);
  if (!spec.standard.empty()) node["standard"] = spec.standard;
  if (spec.noise.force || spec.noise.length) {
    node["noise"] = noise_node(spec.noise, spec.type);
  }
  for (const ExcludedRows& rows : spec.excluded) {
    YAML::Node excluded;
    excluded["rows"] = std::to_string(rows.first) + "-" + std::to_string(rows.last);
    excluded["reason"] = rows.reason;
    node["exclude"].push_back(excluded);
  }
  return node;
}

YAML::Node model_node(const ModelOptions& model) {
  YAML::Node node;
  node["kind"] = "cloth";
  node["membrane"] = std::string(name_of(model.membrane));
  node["bending"] = model.bending;
  if (model.isotropic) {
    const bool linear = model.stiffness == CurveKind::constant;
    node["variant"] = linear ? "linear-isotropic" : "nonlinear-isotropic";
  }
  if (model.measured_mesh) node["mesh"] = "measured";
  if (model.mesh_edge) node["mesh"]["edge"] = exact_quantity(*model.mesh_edge, Dimension::length);
  node["strips"] = model.strips_as_sheets ? "sheet" : "one-dimensional";
  if (model.stiffness) node["stiffness"] = std::string(name_of(*model.stiffness));
  node["friction"] = std::string(name_of(model.friction));
  for (const auto& [name, component] : model.components) {
    YAML::Node inner;
    if (component.stiffness) inner["stiffness"] = std::string(name_of(*component.stiffness));
    if (component.friction) inner["friction"] = std::string(name_of(*component.friction));
    node["components"][name] = inner;
  }
  return node;
}

YAML::Node fit_node(const FitOptions& fit) {
  YAML::Node node;
  node["estimator"] = fit.estimator == EstimatorKind::path ? "path" : "anchor";
  node["control_points"] = fit.control_points;
  if (fit.monotone_stress) node["monotone_stress"] = true;
  for (const auto& [name, bounds] : fit.bounds) {
    node["bounds"][name] = std::vector<double>{bounds.first, bounds.second};
  }
  for (const auto& [name, value] : fit.fix) node["fix"][name] = value;
  for (const auto& [name, prior] : fit.priors) {
    node["priors"][name]["mean"] = prior.mean;
    node["priors"][name]["sd"] = prior.sd;
  }
  for (const PlanStage& stage : fit.plan) {
    YAML::Node inner;
    inner["components"] = stage.components;
    inner["experiments"] = stage.experiments;
    node["plan"].push_back(inner);
  }
  return node;
}

}  // namespace

std::string resolved_study_text(const Study& study, const std::filesystem::path& directory) {
  YAML::Node node;
  node["pliant"] = "study/1";
  node["name"] = study.name;
  if (study.density > 0) node["density"] = exact_quantity(study.density, Dimension::area_density);
  if (!study.info.empty()) node["info"] = texts_node(study.info);
  if (!study.conditions.empty()) node["conditions"] = texts_node(study.conditions);
  for (const ExperimentSpec& spec : study.experiments) {
    node["experiments"].push_back(experiment_node(spec, directory));
  }
  node["model"] = model_node(study.model);
  node["fit"] = fit_node(study.fit);
  for (const std::string& pattern : study.validate) node["validate"].push_back(pattern);

  YAML::Emitter emitter;
  emitter.SetDoublePrecision(17);
  emitter << node;
  return std::string(emitter.c_str()) + "\n";
}

}  // namespace pliant
