#include "pliant/study/model_file.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/estimation/solid/solid_laws.h"
#include "pliant/material/addend/addend_registry.h"
#include "pliant/material/green_strain_check.h"
#include "pliant/material/limit_fields.h"
#include "pliant/material/sample_place.h"

namespace pliant {
namespace {

CurveKind curve_kind(const std::string& kind) {
  if (kind == "none") return CurveKind::none;
  if (kind == "constant") return CurveKind::constant;
  if (kind == "spline") return CurveKind::spline;
  if (kind == "energy") return CurveKind::energy;
  return kind == "affine" ? CurveKind::affine : CurveKind::hermite;
}

FrictionModel read_friction(const Value& value) {
  const std::string name =
      value.choice({"auto", "dahl", "dahl-2", "dahl-3", "dahl-4", "dahl-n", "none"});
  if (name == "auto") return FrictionChoice::automatic;
  if (name == "none") return FrictionChoice::none;
  if (name == "dahl") return FrictionChoice::dahl;
  return {FrictionChoice::dahl, name.back() == 'n' ? 0 : name.back() - '0'};
}

std::vector<const AddendKind*> read_addends(const Value& list) {
  std::vector<const AddendKind*> addends;
  for (const Value& item : list.items()) addends.push_back(&read_addend_kind(item));
  return addends;
}

/// Of a term of two strains: addends of their product, or Gaussians.
ComponentModel read_pair_model(const Value& node) {
  Fields fields = node.fields();
  ComponentModel model;
  if (auto v = fields.optional("addends")) model.addends = read_addends(*v);
  if (auto v = fields.optional("gaussians")) model.gaussians = v->integer(1, 5);
  fields.finish();
  if (model.addends.empty() == (model.gaussians == 0)) {
    node.fail("says what it is in no way, or in two",
              "`addends: [linear]`, which is bilinear, or `gaussians: 3` (three by three)");
  }
  return model;
}

/// @param curves  that its stiffness may have
ComponentModel read_component_model(const Value& node,
                                    const std::vector<std::string_view>& curves) {
  Fields fields = node.fields();
  ComponentModel model;
  if (auto v = fields.optional("addends")) model.addends = read_addends(*v);
  if (auto v = fields.optional("stiffness")) {
    model.stiffness = curve_kind(v->choice(curves));
    if (model.stiffness == CurveKind::none && model.addends.empty()) {
      v->fail("is `none`, and no addends are there to carry anything",
              "another stiffness, or `addends`");
    }
  }
  if (auto v = fields.optional("friction")) model.friction = read_friction(*v);
  fields.finish();
  return model;
}

void read_sheet_mesh(const Value& node, ModelOptions& model) {
  if (!node.is_mapping()) {
    model.measured_mesh = node.choice({"measured"}) == "measured";
    return;
  }
  Fields fields = node.fields();
  model.mesh_edge = fields.require("edge").positive_quantity(Dimension::length);
  fields.finish();
}

std::vector<std::vector<std::string>> read_model_limits(const Value& list, MaterialKind kind) {
  std::vector<std::vector<std::string>> limits;
  std::vector<std::string> taken;
  for (const Value& item : list.items()) {
    Fields fields = item.fields();
    limits.push_back(read_limited_components(fields.require("of"), kind, taken));
    fields.finish();
  }
  return limits;
}

/// Cells of a body along x, y and z, of a sheet along weft and warp.
Eigen::Vector3i read_grid(const Value& node, MaterialKind kind) {
  const bool solid = kind == MaterialKind::solid;
  const std::vector<Value> counts = node.items();
  if (counts.size() != (solid ? 3 : 2)) {
    node.fail(fmt::format("has {} numbers", counts.size()),
              solid ? "cells along x, y and z: [4, 2, 2]" : "cells along weft and warp: [4, 2]");
  }
  Eigen::Vector3i cells(1, 1, 1);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    cells(static_cast<Eigen::Index>(i)) = counts[i].integer(1, 100);
  }
  return cells;
}

/// `{at, grid, spread, grown, width, of}`, one of the first four; of cloth one of the first two.
SampleOptions read_samples(const Value& node, MaterialKind kind) {
  Fields fields = node.fields();
  SampleOptions samples;
  samples.where = node.location();
  int ways = 0;
  if (auto v = fields.optional("at")) {
    ++ways;
    for (const Value& place : v->items()) {
      samples.places.push_back(read_sample_place(place, kind));
    }
    if (samples.places.empty()) v->fail("is empty", "at least one place in metres");
  }
  if (auto v = fields.optional("grid")) {
    ++ways;
    samples.grid = read_grid(*v, kind);
  }
  if (auto v = fields.optional("spread")) {
    ++ways;
    samples.spread = v->integer(1, 10000);
  }
  if (auto v = fields.optional("grown")) {
    ++ways;
    samples.grown = v->integer(2, 100);
  }
  if (ways != 1)
    node.fail("says where the samples are in no way, or in several",
              "one of `at`, `grid`, `spread` and `grown`");
  if (kind == MaterialKind::cloth && samples.spread + samples.grown > 0) {
    node.fail("asks for places that are found in solids alone", "`at` or `grid`");
  }
  if (auto v = fields.optional("width")) samples.width = v->positive_quantity(Dimension::length);
  if (auto v = fields.optional("of")) {
    const std::vector<std::string_view> names(component_names(kind).begin(),
                                              component_names(kind).end());
    for (const Value& component : v->items()) samples.of.push_back(component.choice(names));
    if (samples.of.empty()) v->fail("is empty", "at least one component");
  }
  fields.finish();
  return samples;
}

/// @param curves  that stiffnesses may have
std::map<std::string, ComponentModel> read_components(const Value& node, MaterialKind kind,
                                                      const std::vector<std::string_view>& curves) {
  Fields fields = node.fields();
  std::map<std::string, ComponentModel> components;
  for (const std::string& name : component_names(kind)) {
    if (auto c = fields.optional(name)) components[name] = read_component_model(*c, curves);
  }
  for (const std::string& name : fields.keys()) {
    // Places of Gaussians come from the data.
    if (!is_pair_term(name, kind) || name.find('@') != std::string::npos) continue;
    if (auto c = fields.optional(name)) components[name] = read_pair_model(*c);
  }
  fields.finish();
  return components;
}

/// The model of a solid: a law by its name, or components with theirs.
ModelOptions read_solid_model(Fields& fields) {
  ModelOptions model;
  model.kind = MaterialKind::solid;
  if (auto v = fields.optional("law")) model.solid_law = v->choice(solid_laws());
  if (auto v = fields.optional("components")) {
    model.components =
        read_components(*v, model.kind, {"none", "constant", "affine", "spline", "energy"});
    if (model.components.empty()) v->fail("is empty", "at least one component");
    if (fields.optional("law")) {
      v->fail("stands beside `law`, which names components itself", "one of both");
    }
  }
  if (auto v = fields.optional("limits")) model.limits = read_model_limits(*v, model.kind);
  if (auto v = fields.optional("samples")) {
    model.samples = read_samples(*v, model.kind);
    if (!model.limits.empty()) v->fail("stands beside `limits`", "one of both");
    const auto is_pair = [](const auto& component) {
      return is_pair_term(component.first, MaterialKind::solid);
    };
    if (std::ranges::any_of(model.components, is_pair)) {
      v->fail("stands beside a term of two strains", "one of both");
    }
  }
  fields.finish();
  return model;
}

void read_samples_of_sheet(const Value& node, ModelOptions& model) {
  model.samples = read_samples(node, model.kind);
  if (!model.limits.empty()) node.fail("stands beside `limits`", "one of both");
  if (needs_grid(model)) {
    node.fail("stands beside springs", "a membrane of triangles and bending of discrete shells");
  }
}

}  // namespace

ModelOptions read_model(Fields& study, MaterialKind kind) {
  ModelOptions model;
  model.kind = kind;
  const auto node = study.optional("model");
  if (!node) return model;
  Fields fields = node->fields();
  if (auto v = fields.optional("kind")) v->choice({name_of(kind)});
  if (kind == MaterialKind::solid) return read_solid_model(fields);
  if (auto v = fields.optional("membrane")) {
    model.membrane = membrane_measure(v->choice({"stvk", "soft-constraint", "spring"}));
  }
  if (auto v = fields.optional("bending")) model.bending = v->choice({"discrete-shells", "spring"});
  if (auto v = fields.optional("variant")) {
    const std::string variant = v->choice(
        {"nonlinear-orthotropic", "linear-orthotropic", "nonlinear-isotropic", "linear-isotropic"});
    if (variant.starts_with("linear")) model.stiffness = CurveKind::constant;
    model.isotropic = variant.ends_with("-isotropic");
  }
  if (auto v = fields.optional("mesh")) read_sheet_mesh(*v, model);
  if (auto v = fields.optional("strips")) {
    model.strips_as_sheets = v->choice({"one-dimensional", "sheet"}) == "sheet";
  }
  if (auto v = fields.optional("stiffness")) {
    model.stiffness = curve_kind(v->choice({"constant", "affine", "hermite"}));
  }
  if (auto v = fields.optional("friction")) model.friction = read_friction(*v);
  if (auto v = fields.optional("components")) {
    model.components =
        read_components(*v, kind, {"none", "constant", "affine", "hermite", "spline", "energy"});
    for (const auto& [name, component] : model.components) {
      require_green_strain(name, model.membrane, *v);
    }
  }
  if (auto v = fields.optional("limits")) model.limits = read_model_limits(*v, kind);
  if (auto v = fields.optional("samples")) read_samples_of_sheet(*v, model);
  fields.finish();
  return model;
}

}  // namespace pliant
