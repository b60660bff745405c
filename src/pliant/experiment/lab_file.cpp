#include <set>

#include "pliant/experiment/experiment_name.h"
#include "pliant/experiment/virtual_lab.h"
#include "pliant/io/document.h"
#include "pliant/io/fields.h"
#include "pliant/material/material_file.h"

namespace pliant {
namespace {

struct InstrumentPart {
  double force = 0;
  double length = 0;
};

InstrumentPart read_part(Fields& fields, std::string_view key, bool shear) {
  InstrumentPart part;
  const auto node = fields.optional(key);
  if (!node) return part;
  Fields inner = node->fields();
  const Dimension force = shear ? Dimension::force_per_length : Dimension::force;
  if (auto v = inner.optional("force")) part.force = v->quantity_from_zero(force);
  if (auto v = inner.optional("length")) part.length = v->quantity_from_zero(Dimension::length);
  inner.finish();
  return part;
}

Dimension peak_dimension(const std::string& type) {
  if (type == "hanging-weights") return Dimension::force;
  return type == "tensile-cycles" ? Dimension::fraction : Dimension::angle;
}

LabExperiment read_experiment(const Value& node, std::set<std::string>& names) {
  Fields fields = node.fields();
  LabExperiment experiment;
  experiment.where = node.location();
  experiment.name = read_experiment_name(fields.require("name"), names);
  experiment.type =
      fields.require("type").choice({"hanging-weights", "tensile-cycles", "shear-cycles"});
  const bool shear = experiment.type == "shear-cycles";
  if (!shear) {
    experiment.direction = fields.require("direction").choice({"warp", "weft", "bias"});
    if (auto v = fields.optional("length"))
      experiment.length = v->positive_quantity(Dimension::length);
    if (auto v = fields.optional("width"))
      experiment.width = v->positive_quantity(Dimension::length);
  }
  if (experiment.type == "hanging-weights") {
    if (auto v = fields.optional("clip_mass")) {
      experiment.clip_mass = v->quantity_from_zero(Dimension::mass);
    }
    if (auto v = fields.optional("step")) experiment.step = v->positive_quantity(Dimension::force);
  } else {
    if (auto v = fields.optional("samples")) experiment.samples = v->integer(3, 1000000);
  }
  if (experiment.type == "tensile-cycles") {
    if (auto v = fields.optional("slack"))
      experiment.slack = v->quantity_from_zero(Dimension::length);
  }
  if (shear) {
    if (auto v = fields.optional("transverse_tension")) {
      experiment.transverse_tension = v->quantity_from_zero(Dimension::force_per_length);
    }
  }
  const Value peaks = fields.require("peaks");
  for (const Value& peak : peaks.items()) {
    experiment.peaks.push_back(peak.positive_quantity(peak_dimension(experiment.type)));
  }
  if (experiment.peaks.empty()) peaks.fail("is empty", "at least one peak");
  if (auto v = fields.optional("repeats")) experiment.repeats = v->integer(1, 1000);
  const InstrumentPart noise = read_part(fields, "noise", shear);
  const InstrumentPart resolution = read_part(fields, "resolution", shear);
  experiment.instrument = {noise.force, noise.length, resolution.force, resolution.length};
  fields.finish();
  return experiment;
}

}  // namespace

VirtualLab read_lab(const std::filesystem::path& path) {
  const Document document = read_yaml(path);
  Fields fields = Value(document).fields();
  require_document(fields, "lab", 1);
  VirtualLab lab;
  const Value material = fields.require("material");
  lab.material = read_material(path.parent_path() / material.text());
  lab.name = lab.material.name;
  if (auto v = fields.optional("name")) lab.name = v->text();
  if (auto v = fields.optional("specimens")) lab.specimens = v->integer(1, 1000);
  if (auto v = fields.optional("specimen_variation")) {
    lab.specimen_variation = v->quantity_from_zero(Dimension::fraction);
  }
  std::set<std::string> names;
  const Value list = fields.require("experiments");
  for (const Value& node : list.items()) {
    LabExperiment experiment = read_experiment(node, names);
    if (!law_of(lab.material,
                experiment.type == "shear-cycles" ? "shear" : "stretch." + experiment.direction)) {
      node.fail("needs a component that the material " + quoted_value(lab.material.name) +
                    " does not have",
                "a direction that was measured or assumed");
    }
    lab.experiments.push_back(std::move(experiment));
  }
  if (lab.experiments.empty()) list.fail("has no experiment", "at least one");
  if (auto v = fields.optional("validate")) {
    for (const Value& pattern : v->items()) lab.validate.push_back(pattern.text());
  }
  fields.finish();
  return lab;
}

}  // namespace pliant
