#include <set>

#include "pliant/experiment/overhang/bending_length.h"
#include "pliant/experiment/session/virtual/fields.h"
#include "pliant/io/document.h"
#include "pliant/io/fields.h"
#include "pliant/io/result_name.h"
#include "pliant/material/material_file.h"
#include "pliant/study/study.h"
#include "pliant/study/virtual_lab.h"

namespace pliant {
namespace {

// buckling-bend, shares of the length: where the clamps start, and how far they may come.
constexpr double kBucklingSlack = 0.02;
constexpr double kNearest = 0.9;

struct InstrumentPart {
  double force = 0;
  double length = 0;
};

InstrumentPart read_part(Fields& fields, std::string_view key, const std::string& type) {
  InstrumentPart part;
  const auto node = fields.optional(key);
  if (!node) return part;
  Fields inner = node->fields();
  if (type == "pure-bending") {
    if (auto v = inner.optional("moment")) part.force = v->quantity_from_zero(Dimension::force);
    inner.finish();
    return part;
  }
  const Dimension force = type == "shear-cycles" ? Dimension::force_per_length : Dimension::force;
  if (auto v = inner.optional("force")) part.force = v->quantity_from_zero(force);
  if (auto v = inner.optional("length")) part.length = v->quantity_from_zero(Dimension::length);
  inner.finish();
  return part;
}

Dimension peak_dimension(const std::string& type) {
  if (type == "hanging-weights") return Dimension::force;
  if (type == "pure-bending") return Dimension::curvature;
  const bool share = type == "tensile-cycles" || type == "buckling-bend";
  return share ? Dimension::fraction : Dimension::angle;
}

// [P] 4.3.
const std::vector<double>& published_radii() {
  static const std::vector<double> radii{0.003, 0.004, 0.005, 0.006,  0.007,  0.0075,
                                         0.010, 0.016, 0.023, 0.0275, 0.0315, 0.050};
  return radii;
}

// A length among the instrument's numbers, e.g. `noise: {position: 0.1 mm}`.
double read_channel(Fields& fields, std::string_view key, std::string_view channel) {
  const auto node = fields.optional(key);
  if (!node) return 0;
  Fields inner = node->fields();
  double length = 0;
  if (auto v = inner.optional(channel)) length = v->quantity_from_zero(Dimension::length);
  inner.finish();
  return length;
}

void read_overhangs(Fields& fields, LabExperiment& experiment) {
  const Value list = fields.require("overhangs");
  for (const Value& overhang : list.items()) {
    experiment.settings.push_back(overhang.positive_quantity(Dimension::length));
  }
  if (experiment.settings.empty()) list.fail("is empty", "at least one overhang");
}

void read_radii(Fields& fields, LabExperiment& experiment) {
  experiment.settings = published_radii();
  const auto list = fields.optional("radii");
  if (!list) return;
  experiment.settings.clear();
  for (const Value& radius : list->items()) {
    experiment.settings.push_back(radius.quantity(Dimension::length));
    if (experiment.settings.back() == 0) radius.fail("is zero", "the radius of a cylinder");
  }
  if (experiment.settings.empty()) list->fail("is empty", "at least one radius");
}

void read_profiles(Fields& fields, LabExperiment& experiment) {
  if (auto v = fields.optional("width")) experiment.width = v->positive_quantity(Dimension::length);
  if (experiment.type == "rolled-strip") {
    if (auto v = fields.optional("length")) {
      experiment.length = v->positive_quantity(Dimension::length);
    }
    experiment.repeats = 3;
    read_radii(fields, experiment);
  } else {
    read_overhangs(fields, experiment);
  }
  if (auto v = fields.optional("points")) experiment.points = v->integer(5, 1000);
  if (auto v = fields.optional("repeats")) experiment.repeats = v->integer(1, 1000);
  experiment.instrument.length_noise = read_channel(fields, "noise", "position");
  experiment.instrument.length_resolution = read_channel(fields, "resolution", "position");
}

void read_bending_length(Fields& fields, LabExperiment& experiment) {
  if (auto v = fields.optional("width")) experiment.width = v->positive_quantity(Dimension::length);
  experiment.angle = read_overhang_angle(fields);
  experiment.repeats = 2;
  if (auto v = fields.optional("repeats")) experiment.repeats = v->integer(1, 1000);
  experiment.instrument.length_noise = read_channel(fields, "noise", "overhang");
  experiment.instrument.length_resolution = read_channel(fields, "resolution", "overhang");
}

void read_buckling(Fields& fields, LabExperiment& experiment) {
  const bool up = fields.require("side").choice({"down", "up"}) == "up";
  experiment.side = up ? BucklingSide::up : BucklingSide::down;
  experiment.slack = kBucklingSlack * experiment.length;
  if (auto v = fields.optional("slack")) experiment.slack = v->positive_quantity(Dimension::length);
  experiment.strip_length = experiment.length;
  if (const auto v = fields.optional("strip_length")) {
    experiment.strip_length = v->positive_quantity(Dimension::length);
    if (experiment.strip_length <= experiment.length - experiment.slack) {
      v->fail("is not above the distance at which the clamps start", "a strip that buckles there");
    }
  }
  if (auto v = fields.optional("force_offset")) {
    experiment.force_offset = v->quantity(Dimension::force);
  }
  if (auto v = fields.optional("force_drift")) {
    experiment.force_drift = v->quantity(Dimension::force);
  }
}

// What the type has beside peaks, repeats and the instrument.
void read_type_fields(Fields& fields, LabExperiment& experiment) {
  const bool shear = experiment.type == "shear-cycles";
  if (!shear) experiment.direction = fields.require("direction").choice({"warp", "weft", "bias"});
  if (!shear && experiment.type != "pure-bending") {
    if (auto v = fields.optional("length"))
      experiment.length = v->positive_quantity(Dimension::length);
    if (auto v = fields.optional("width"))
      experiment.width = v->positive_quantity(Dimension::length);
  }
  if (experiment.type == "buckling-bend") fields.require("length");
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
  if (experiment.type == "buckling-bend") read_buckling(fields, experiment);
}

void read_peaks(Fields& fields, LabExperiment& experiment) {
  const Value peaks = fields.require("peaks");
  for (const Value& peak : peaks.items()) {
    experiment.peaks.push_back(peak.positive_quantity(peak_dimension(experiment.type)));
    if (experiment.type != "buckling-bend") continue;
    const double value = experiment.peaks.back();
    if (value >= kNearest || value * experiment.length <= experiment.slack) {
      peak.fail("is no approach of the clamps from where they start",
                "a share of the length above `slack` and below 90 %");
    }
  }
  if (experiment.peaks.empty()) peaks.fail("is empty", "at least one peak");
}

/// A session is a folder of its name, beside the lab's files.
void require_folder_name(const std::string& name, const Value& node) {
  const std::string extension = std::filesystem::path(name).extension().string();
  if (extension != ".csv" && extension != ".yaml" && extension != ".json") return;
  node.fail("is the name of a file", "the name of a folder for the session");
}

LabExperiment read_experiment(const Value& node, std::set<std::string>& names) {
  Fields fields = node.fields();
  LabExperiment experiment;
  experiment.where = node.location();
  experiment.name = read_experiment_name(fields.require("name"), names);
  experiment.type = fields.require("type").choice(
      {"hanging-weights", "tensile-cycles", "shear-cycles", "pure-bending", "cantilever",
       "rolled-strip", "bending-length", "buckling-bend", "session"});
  if (experiment.type == "session") {
    require_folder_name(experiment.name, fields.require("name"));
    experiment.session = read_virtual_session(fields);
    fields.finish();
    return experiment;
  }
  if (bends_by_weight(experiment.type)) {
    experiment.direction = fields.require("direction").choice({"warp", "weft", "bias"});
    if (measures_profiles(experiment.type)) {
      read_profiles(fields, experiment);
    } else {
      read_bending_length(fields, experiment);
    }
    fields.finish();
    return experiment;
  }
  read_type_fields(fields, experiment);
  read_peaks(fields, experiment);
  if (auto v = fields.optional("repeats")) experiment.repeats = v->integer(1, 1000);
  const InstrumentPart noise = read_part(fields, "noise", experiment.type);
  const InstrumentPart resolution = read_part(fields, "resolution", experiment.type);
  experiment.instrument = {noise.force, noise.length, resolution.force, resolution.length};
  fields.finish();
  return experiment;
}

void require_material(const Material& material, const LabExperiment& experiment,
                      const Value& node) {
  if (experiment.type == "session") {
    require_sheet_material(material, experiment.session, node.location());
    return;
  }
  if (!law_of(material, component_of_test(experiment.type, experiment.direction))) {
    node.fail(
        "needs a component that the material " + quoted_value(material.name) + " does not have",
        "a direction that was measured or assumed");
  }
  if (needs_density(experiment.type) && !(material.density > 0)) {
    node.fail("needs the density of the material " + quoted_value(material.name) +
                  ", which does not say it",
              "a material with `density`: its own weight bends the strip");
  }
}

}  // namespace

VirtualLab read_lab(const std::filesystem::path& path) {
  const Document document = read_yaml(path);
  Fields fields = Value(document).fields();
  require_document(fields, "lab", 1);
  VirtualLab lab;
  const Value material = fields.require("material");
  lab.material = read_material(path.parent_path() / material.text("a material file"));
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
    require_material(lab.material, experiment, node);
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
