#include <yaml-cpp/yaml.h>

#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/body_fields.h"
#include "pliant/experiment/test_type.h"
#include "pliant/study/study.h"

namespace pliant {
namespace {

std::string written(const FrictionModel& friction) {
  switch (friction.choice) {
    case FrictionChoice::automatic:
      return "auto";
    case FrictionChoice::none:
      return "none";
    case FrictionChoice::dahl:
      if (friction.branches == 0) return "dahl-n";
      return friction.branches == 1 ? "dahl" : "dahl-" + std::to_string(friction.branches);
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
  if (data.csv.columns.empty() && data.csv.encoding.empty() && data.csv.skip_rows == 0 &&
      data.csv.sheet.empty()) {
    return YAML::Node(relative.generic_string());
  }
  YAML::Node node;
  node["file"] = relative.generic_string();
  if (!data.csv.columns.empty()) node["columns"] = texts_node(data.csv.columns);
  if (!data.csv.encoding.empty()) node["encoding"] = data.csv.encoding;
  if (data.csv.skip_rows > 0) node["skip_rows"] = data.csv.skip_rows;
  if (!data.csv.sheet.empty()) node["sheet"] = data.csv.sheet;
  return node;
}

YAML::Node noise_node(const StatedNoise& noise, const std::vector<Channel>& channels) {
  YAML::Node node;
  for (const Channel& channel : channels) {
    const std::optional<double>& value = noise.*channel.stated;
    if (value) node[std::string(channel.key)] = exact_quantity(*value, channel.dimension);
  }
  return node;
}

YAML::Node experiment_node(const ExperimentSpec& spec, const std::filesystem::path& directory) {
  YAML::Node node;
  node["name"] = spec.name;
  node["type"] = spec.type;
  node["data"] = data_node(spec.data, directory);
  if (!spec.direction.empty()) node["direction"] = spec.direction;
  for (const auto& [key, value] : spec.test->fields()) {
    const bool list = value.starts_with('[');
    node[key] = list ? YAML::Load(value) : YAML::Node(value);
  }
  if (!spec.after.empty()) node["after"] = spec.after;
  if (!spec.standard.empty()) node["standard"] = spec.standard;
  if (spec.noise.force || spec.noise.length) {
    node["noise"] = noise_node(spec.noise, spec.test->type().channels);
  }
  if (spec.weight != 1) node["weight"] = spec.weight;
  for (const ExcludedRows& rows : spec.excluded) {
    YAML::Node excluded;
    excluded["rows"] = std::to_string(rows.first) + "-" + std::to_string(rows.last);
    excluded["reason"] = rows.reason;
    node["exclude"].push_back(excluded);
  }
  return node;
}

void write_components(const ModelOptions& model, YAML::Node& node) {
  for (const auto& [name, component] : model.components) {
    YAML::Node inner;
    if (component.stiffness) inner["stiffness"] = std::string(name_of(*component.stiffness));
    if (component.friction) inner["friction"] = written(*component.friction);
    for (const AddendKind* kind : component.addends) {
      inner["addends"].push_back(std::string(kind->name));
    }
    if (component.gaussians > 0) inner["gaussians"] = component.gaussians;
    node["components"][name] = inner;
  }
}

void write_limits(const ModelOptions& model, YAML::Node& node) {
  for (const std::vector<std::string>& limit : model.limits) {
    YAML::Node inner;
    inner["of"] = limit;
    node["limits"].push_back(inner);
  }
}

YAML::Node samples_node(const SampleOptions& samples, MaterialKind kind) {
  YAML::Node node;
  const int axes = kind == MaterialKind::solid ? 3 : 2;
  for (const Eigen::Vector3d& place : samples.places) {
    node["at"].push_back(std::vector<double>(place.begin(), place.begin() + axes));
  }
  if (samples.grid.x() > 0) {
    node["grid"] = std::vector<int>(samples.grid.begin(), samples.grid.begin() + axes);
  }
  if (samples.spread > 0) node["spread"] = samples.spread;
  if (samples.grown > 0) node["grown"] = samples.grown;
  if (samples.width) node["width"] = exact_quantity(*samples.width, Dimension::length);
  if (!samples.of.empty()) node["of"] = samples.of;
  return node;
}

YAML::Node model_node(const ModelOptions& model) {
  YAML::Node node;
  node["kind"] = std::string(name_of(model.kind));
  if (model.kind == MaterialKind::solid) {
    if (model.components.empty()) node["law"] = model.solid_law;
    write_components(model, node);
    write_limits(model, node);
    if (model.samples) node["samples"] = samples_node(*model.samples, model.kind);
    return node;
  }
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
  node["friction"] = written(model.friction);
  write_components(model, node);
  write_limits(model, node);
  if (model.samples) node["samples"] = samples_node(*model.samples, model.kind);
  return node;
}

YAML::Node fit_node(const FitOptions& fit) {
  YAML::Node node;
  node["estimator"] = fit.estimator == EstimatorKind::path ? "path" : "anchor";
  node["control_points"] = fit.control_points;
  if (fit.loss != RobustLoss::none) node["loss"] = std::string(name_of(fit.loss));
  if (fit.monotone_stress) node["monotone_stress"] = true;
  if (fit.convexity != Convexity::within) node["convexity"] = std::string(name_of(fit.convexity));
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
  if (study.density > 0)
    node["density"] = exact_quantity(study.density, study.model.kind == MaterialKind::solid
                                                        ? Dimension::volume_density
                                                        : Dimension::area_density);
  if (!study.info.empty()) node["info"] = texts_node(study.info);
  if (!study.conditions.empty()) node["conditions"] = texts_node(study.conditions);
  for (const ExperimentSpec& spec : study.experiments) {
    node["experiments"].push_back(experiment_node(spec, directory));
  }
  node["model"] = model_node(study.model);
  node["fit"] = fit_node(study.fit);
  for (const std::string& pattern : study.validate) node["validate"].push_back(pattern);
  for (const auto& [key, share] : limits_of(study.accept)) {
    node["accept"][std::string(key)] = format_number(100 * share, 15) + " %";
  }

  YAML::Emitter emitter;
  emitter.SetDoublePrecision(17);
  emitter << node;
  return std::string(emitter.c_str()) + "\n";
}

}  // namespace pliant
