#include "pliant/experiment/study.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/experiment/data_source.h"
#include "pliant/io/document.h"
#include "pliant/io/fields.h"

namespace pliant {
namespace {

// Defaults of `defaults:`; zero where nothing was said.
struct Defaults {
  double length = 0;
  double width = 0;
};

double positive_quantity(const Value& value, Dimension dimension) {
  const double number = value.quantity(dimension);
  if (number <= 0) value.fail("is not positive", "a value above 0");
  return number;
}

double quantity_from_zero(const Value& value, Dimension dimension) {
  const double number = value.quantity(dimension);
  if (number < 0) value.fail("is negative", "a value of at least 0");
  return number;
}

std::map<std::string, std::string> read_texts(Fields& fields, std::string_view key) {
  std::map<std::string, std::string> texts;
  if (auto node = fields.optional(key)) {
    Fields inner = node->fields();
    for (auto& [name, value] : inner.all()) texts[name] = value.text();
  }
  return texts;
}

// Free texts, but temperature and humidity are quantities that name their unit.
std::map<std::string, std::string> read_conditions(Fields& fields) {
  std::map<std::string, std::string> conditions;
  if (auto node = fields.optional("conditions")) {
    Fields inner = node->fields();
    for (auto& [name, value] : inner.all()) {
      if (name == "temperature") value.quantity(Dimension::temperature);
      if (name == "humidity") value.quantity(Dimension::fraction);
      conditions[name] = value.text();
    }
  }
  return conditions;
}

Defaults read_defaults(Fields& fields) {
  Defaults defaults;
  const auto node = fields.optional("defaults");
  if (!node) return defaults;
  Fields inner = node->fields();
  if (auto v = inner.optional("length")) defaults.length = positive_quantity(*v, Dimension::length);
  if (auto v = inner.optional("width")) defaults.width = positive_quantity(*v, Dimension::length);
  inner.finish();
  return defaults;
}

ExcludedRows read_excluded_rows(const Value& node) {
  Fields fields = node.fields();
  ExcludedRows rows;
  const Value range = fields.require("rows");
  const std::string text = range.text();
  const size_t dash = text.find('-');
  try {
    rows.first = std::stoi(text);
    rows.last = dash == std::string::npos ? rows.first : std::stoi(text.substr(dash + 1));
  } catch (const std::exception&) {
    range.fail(quoted_value(text) + " is no range of rows",
               "FIRST-LAST, counted from 1, e.g. 12-18");
  }
  if (rows.first < 1 || rows.last < rows.first) {
    range.fail(quoted_value(text) + " is no range of rows",
               "FIRST-LAST, counted from 1, e.g. 12-18");
  }
  rows.reason = fields.require("reason").text();
  fields.finish();
  return rows;
}

StatedNoise read_noise(const Value& node, const std::string& type) {
  Fields fields = node.fields();
  StatedNoise noise;
  const Dimension force = type == "shear-cycles" ? Dimension::force_per_length : Dimension::force;
  if (auto v = fields.optional("force")) noise.force = positive_quantity(*v, force);
  if (auto v = fields.optional("length")) noise.length = positive_quantity(*v, Dimension::length);
  fields.finish();
  return noise;
}

const std::vector<std::string>& known_types() {
  static const std::vector<std::string> types{
      "hanging-weights", "tensile-cycles", "shear-cycles",  "pure-bending", "bending-length",
      "cantilever",      "rolled-strip",   "buckling-bend", "session",      "homogeneous",
      "press",           "indentation",    "image-poses"};
  return types;
}

std::string read_type(const Value& value) {
  const std::vector<std::string>& types = known_types();
  const std::vector<std::string_view> views(types.begin(), types.end());
  return value.choice(views);
}

bool is_stretch_type(const std::string& type) {
  return type == "hanging-weights" || type == "tensile-cycles";
}

void read_geometry(Fields& fields, const Defaults& defaults, ExperimentSpec& spec) {
  const auto read = [&](std::string_view key, double fallback) {
    if (auto v = fields.optional(key)) return positive_quantity(*v, Dimension::length);
    if (fallback == 0 && is_stretch_type(spec.type)) fields.require(key);
    return fallback;
  };
  spec.length = read("length", defaults.length);
  spec.width = read("width", defaults.width);
}

void read_stretch_fields(Fields& fields, ExperimentSpec& spec) {
  if (auto v = fields.optional("clip_mass")) {
    spec.clip_mass = quantity_from_zero(*v, Dimension::mass);
  }
  if (auto v = fields.optional("pretension")) {
    spec.pretension = quantity_from_zero(*v, Dimension::force);
  }
  if (auto v = fields.optional("apparatus_friction")) {
    spec.apparatus_friction = quantity_from_zero(*v, Dimension::force);
  }
  if (auto v = fields.optional("precondition_cycles")) {
    spec.precondition_cycles = v->integer(0, 1000);
  }
}

InitialFriction read_initial_friction(Fields& fields, const std::string& type) {
  const bool unknown_by_default = type == "tensile-cycles" || type == "shear-cycles";
  if (auto v = fields.optional("initial_friction")) {
    return v->choice({"unknown", "rest"}) == "rest" ? InitialFriction::rest
                                                    : InitialFriction::unknown;
  }
  return unknown_by_default ? InitialFriction::unknown : InitialFriction::rest;
}

RestLength read_rest_length(Fields& fields, double pretension) {
  if (auto v = fields.optional("rest_length")) {
    return v->choice({"known", "unknown"}) == "known" ? RestLength::known : RestLength::unknown;
  }
  return pretension > 0 ? RestLength::unknown : RestLength::known;
}

std::string read_direction(Fields& fields, const std::string& type) {
  if (is_stretch_type(type)) return fields.require("direction").choice({"warp", "weft", "bias"});
  if (auto v = fields.optional("direction")) return v->choice({"warp", "weft", "bias"});
  return "";
}

ExperimentSpec read_experiment(const Value& node, const Defaults& defaults) {
  Fields fields = node.fields();
  ExperimentSpec spec;
  spec.where = node.location();
  spec.name = fields.require("name").text();
  spec.type = read_type(fields.require("type"));
  spec.direction = read_direction(fields, spec.type);
  if (auto v = fields.optional("standard")) spec.standard = v->text();
  if (auto v = fields.optional("side")) spec.side = v->choice({"up", "down"});
  spec.data = read_data_source(fields.require("data"));
  read_geometry(fields, defaults, spec);
  read_stretch_fields(fields, spec);
  if (auto v = fields.optional("transverse_tension")) {
    spec.transverse_tension = quantity_from_zero(*v, Dimension::force_per_length);
  }
  if (auto v = fields.optional("rested")) spec.rested = v->flag();
  spec.initial_friction = read_initial_friction(fields, spec.type);
  if (spec.type == "tensile-cycles") spec.rest_length = read_rest_length(fields, spec.pretension);
  if (auto v = fields.optional("noise")) spec.noise = read_noise(*v, spec.type);
  if (auto v = fields.optional("exclude")) {
    for (const Value& rows : v->items()) spec.excluded.push_back(read_excluded_rows(rows));
  }
  fields.finish();
  return spec;
}

void refuse_unsafe_name(const Value& node, const std::string& name) {
  const bool safe =
      !name.empty() && name[0] != '.' && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) || c == '-' || c == '_' || c == '.' || c >= 128;
      });
  if (!safe) {
    node.fail(quoted_value(name) + " is no name for an experiment",
              "letters, digits, `-`, `_` and `.`: results are files of that name");
  }
}

std::vector<ExperimentSpec> read_experiments(const Value& list, const Defaults& defaults) {
  std::vector<ExperimentSpec> specs;
  std::set<std::string> names;
  for (const Value& node : list.items()) {
    ExperimentSpec spec = read_experiment(node, defaults);
    refuse_unsafe_name(node, spec.name);
    if (!names.insert(spec.name).second) {
      node.fail("a second experiment is called " + quoted_value(spec.name), "a name of its own");
    }
    specs.push_back(std::move(spec));
  }
  if (specs.empty()) list.fail("has no experiment", "at least one");
  return specs;
}

CurveKind read_curve_kind(const Value& value) {
  const std::string kind = value.choice({"constant", "affine", "hermite"});
  if (kind == "constant") return CurveKind::constant;
  return kind == "affine" ? CurveKind::affine : CurveKind::hermite;
}

FrictionChoice read_friction_choice(const Value& value) {
  const std::string choice = value.choice({"auto", "dahl", "none"});
  if (choice == "auto") return FrictionChoice::automatic;
  return choice == "dahl" ? FrictionChoice::dahl : FrictionChoice::none;
}

ComponentModel read_component_model(const Value& node) {
  Fields fields = node.fields();
  ComponentModel model;
  if (auto v = fields.optional("stiffness")) model.stiffness = read_curve_kind(*v);
  if (auto v = fields.optional("friction")) model.friction = read_friction_choice(*v);
  fields.finish();
  return model;
}

ModelOptions read_model(Fields& study) {
  ModelOptions model;
  const auto node = study.optional("model");
  if (!node) return model;
  Fields fields = node->fields();
  if (auto v = fields.optional("kind")) v->choice({"cloth"});
  if (auto v = fields.optional("membrane")) {
    model.membrane = v->choice({"stvk", "soft-constraint"}) == "stvk"
                         ? MembraneMeasure::stvk
                         : MembraneMeasure::soft_constraint;
  }
  if (auto v = fields.optional("bending")) model.bending = v->choice({"discrete-shells"});
  if (auto v = fields.optional("variant")) v->choice({"nonlinear-orthotropic"});
  if (auto v = fields.optional("stiffness")) model.stiffness = read_curve_kind(*v);
  if (auto v = fields.optional("friction")) model.friction = read_friction_choice(*v);
  if (auto v = fields.optional("components")) {
    Fields components = v->fields();
    for (const std::string& name : cloth_component_names()) {
      if (auto c = components.optional(name)) model.components[name] = read_component_model(*c);
    }
    components.finish();
  }
  fields.finish();
  return model;
}

template <class Read>
auto read_map(Fields& fields, std::string_view key, Read read) {
  std::map<std::string, decltype(read(std::declval<Value>()))> result;
  if (auto node = fields.optional(key)) {
    Fields inner = node->fields();
    for (auto& [name, value] : inner.all()) result[name] = read(value);
  }
  return result;
}

std::pair<double, double> read_bounds(const Value& value) {
  const std::vector<double> ends = value.numbers();
  if (ends.size() != 2 || ends[0] >= ends[1]) value.fail("is no interval", "[lower, upper] in SI");
  return {ends[0], ends[1]};
}

GaussianPrior read_prior(const Value& value) {
  Fields fields = value.fields();
  GaussianPrior prior;
  prior.mean = fields.require("mean").number();
  const Value sd = fields.require("sd");
  prior.sd = sd.number();
  if (prior.sd <= 0) sd.fail("is not positive", "a standard deviation above 0");
  fields.finish();
  return prior;
}

FitOptions read_fit(Fields& study) {
  FitOptions fit;
  const auto node = study.optional("fit");
  if (!node) return fit;
  Fields fields = node->fields();
  if (auto v = fields.optional("estimator")) {
    fit.estimator =
        v->choice({"path", "anchor"}) == "path" ? EstimatorKind::path : EstimatorKind::anchor;
  }
  if (auto v = fields.optional("control_points")) fit.control_points = v->integer(1, 20);
  fit.bounds = read_map(fields, "bounds", read_bounds);
  fit.fix = read_map(fields, "fix", [](const Value& v) { return v.number(); });
  fit.priors = read_map(fields, "priors", read_prior);
  fields.finish();
  return fit;
}

void apply_validate(const Value& list, Study& study) {
  for (const Value& item : list.items()) {
    const std::string pattern = item.text();
    bool found = false;
    for (ExperimentSpec& spec : study.experiments) {
      if (!matches(pattern, spec.name)) continue;
      spec.role = ExperimentRole::validate;
      found = true;
    }
    if (!found)
      item.fail(quoted_value(pattern) + " matches no experiment", "a name or a pattern with *");
    study.validate.push_back(pattern);
  }
}

}  // namespace

bool is_supported_type(std::string_view type) {
  return type == "hanging-weights" || type == "tensile-cycles" || type == "shear-cycles";
}

bool matches(std::string_view pattern, std::string_view name) {
  if (pattern.empty()) return name.empty();
  if (pattern.front() == '*') {
    for (size_t skip = 0; skip <= name.size(); ++skip) {
      if (matches(pattern.substr(1), name.substr(skip))) return true;
    }
    return false;
  }
  return !name.empty() && pattern.front() == name.front() &&
         matches(pattern.substr(1), name.substr(1));
}

Study read_study(const std::filesystem::path& path) {
  const Document document = read_yaml(path);
  Fields fields = Value(document).fields();
  require_document(fields, "study", 1);

  Study study;
  study.file = path.string();
  study.name = fields.require("name").text();
  if (auto v = fields.optional("density")) {
    study.density = positive_quantity(*v, Dimension::area_density);
  }
  study.info = read_texts(fields, "info");
  study.conditions = read_conditions(fields);
  const Defaults defaults = read_defaults(fields);
  study.experiments = read_experiments(fields.require("experiments"), defaults);
  study.model = read_model(fields);
  study.fit = read_fit(fields);
  if (auto v = fields.optional("validate")) apply_validate(*v, study);
  fields.finish();
  return study;
}

}  // namespace pliant
