#include "pliant/study/study.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "pliant/base/name_pattern.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/make_experiment.h"
#include "pliant/experiment/overhang/bending_length.h"
#include "pliant/io/document.h"
#include "pliant/io/fields.h"
#include "pliant/io/result_name.h"
#include "pliant/measurement/data_source.h"

namespace pliant {
namespace {

constexpr long kMostRows = 1'000'000'000;
constexpr double kSameAngle = 1e-6;  // rad, of the direction in which a strip is cut

// Defaults of `defaults:`; zero where nothing was said.
struct Defaults {
  double length = 0;
  double width = 0;
};

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
  if (auto v = inner.optional("length")) defaults.length = v->positive_quantity(Dimension::length);
  if (auto v = inner.optional("width")) defaults.width = v->positive_quantity(Dimension::length);
  inner.finish();
  return defaults;
}

ExcludedRows read_excluded_rows(const Value& node) {
  Fields fields = node.fields();
  ExcludedRows rows;
  const Value range = fields.require("rows");
  const std::string text = range.text();
  const size_t dash = std::min(text.find('-'), text.size());
  const auto first = parse_integer(text.substr(0, dash));
  const auto last = dash == text.size() ? first : parse_integer(text.substr(dash + 1));
  if (!first || !last || *first < 1 || *last < *first || *last > kMostRows) {
    range.fail(quoted_value(text) + " is no range of rows",
               "FIRST-LAST, counted from 1, e.g. 12-18");
  }
  rows.first = static_cast<int>(*first);
  rows.last = static_cast<int>(*last);
  rows.reason = fields.require("reason").text();
  fields.finish();
  return rows;
}

StatedNoise read_noise(const Value& node, const std::string& type) {
  Fields fields = node.fields();
  StatedNoise noise;
  if (measures_profiles(type)) {
    if (auto v = fields.optional("position")) {
      noise.length = v->positive_quantity(Dimension::length);
    }
    fields.finish();
    return noise;
  }
  if (type == "bending-length") {
    if (auto v = fields.optional("overhang")) {
      noise.length = v->positive_quantity(Dimension::length);
    }
    fields.finish();
    return noise;
  }
  if (type == "pure-bending") {
    if (auto v = fields.optional("moment")) noise.force = v->positive_quantity(Dimension::force);
    fields.finish();
    return noise;
  }
  const Dimension force = type == "shear-cycles" ? Dimension::force_per_length : Dimension::force;
  if (auto v = fields.optional("force")) noise.force = v->positive_quantity(force);
  if (auto v = fields.optional("length")) noise.length = v->positive_quantity(Dimension::length);
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

double read_length(Fields& fields, std::string_view key, double fallback) {
  if (fallback > 0 && !fields.optional(key)) return fallback;
  return fields.require(key).positive_quantity(Dimension::length);
}

// A strip may be cut at any angle; those of weft, bias and warp are these directions.
void read_cut(const Value& value, ExperimentSpec& spec) {
  const std::string text = value.text();
  if (text.find_first_of("0123456789") == std::string::npos) {
    spec.direction = value.choice({"warp", "weft", "bias"});
    return;
  }
  const double angle = value.quantity_from_zero(Dimension::angle);
  if (angle >= std::numbers::pi - kSameAngle) {
    value.fail(quoted_value(text) + " is no angle of a strip", "0 deg to less than 180 deg");
  }
  for (const auto& [name, eighths] : {std::pair{"weft", 0}, {"bias", 2}, {"warp", 4}}) {
    if (std::abs(angle - eighths * std::numbers::pi / 8) < kSameAngle) spec.direction = name;
  }
  if (!spec.direction.empty()) return;
  spec.direction = text;
  spec.oblique_angle = angle;
}

void read_strip(Fields& fields, const Defaults& defaults, ExperimentSpec& spec) {
  const Value direction = fields.require("direction");
  if (spec.type == "tensile-cycles") {
    read_cut(direction, spec);
  } else {
    spec.direction = direction.choice({"warp", "weft", "bias"});
  }
  spec.length = read_length(fields, "length", defaults.length);
  spec.width = read_length(fields, "width", defaults.width);
}

// Of a cantilever and an overhang the data tell the length; the width of a strip that only its
// weight bends says nothing, and is kept for the record.
void read_bent_strip(Fields& fields, const Defaults& defaults, ExperimentSpec& spec) {
  spec.direction = fields.require("direction").choice({"warp", "weft", "bias"});
  if (spec.type == "rolled-strip") spec.length = read_length(fields, "length", defaults.length);
  spec.width = defaults.width;
  if (auto v = fields.optional("width")) spec.width = v->positive_quantity(Dimension::length);
  if (spec.type == "bending-length") spec.angle = read_overhang_angle(fields);
  if (spec.type == "cantilever") {
    if (auto v = fields.optional("density")) {
      spec.density_is_known = v->choice({"known", "unknown"}) == "known";
    }
  }
}

InitialFriction read_initial_friction(Fields& fields) {
  const auto v = fields.optional("initial_friction");
  const bool rest = v && v->choice({"unknown", "rest"}) == "rest";
  return rest ? InitialFriction::rest : InitialFriction::unknown;
}

RestLength read_rest_length(Fields& fields, double pretension) {
  if (auto v = fields.optional("rest_length")) {
    return v->choice({"known", "unknown"}) == "known" ? RestLength::known : RestLength::unknown;
  }
  return pretension > 0 ? RestLength::unknown : RestLength::known;
}

void read_hanging_weights(Fields& fields, ExperimentSpec& spec) {
  if (auto v = fields.optional("clip_mass")) {
    spec.clip_mass = v->quantity_from_zero(Dimension::mass);
  }
  if (auto v = fields.optional("rested")) spec.rested = v->flag();
}

void read_tensile_cycles(Fields& fields, ExperimentSpec& spec) {
  if (auto v = fields.optional("pretension")) {
    spec.pretension = v->quantity_from_zero(Dimension::force);
  }
  if (auto v = fields.optional("apparatus_friction")) {
    spec.apparatus_friction = v->quantity_from_zero(Dimension::force);
  }
  if (auto v = fields.optional("precondition_cycles")) {
    spec.precondition_cycles = v->integer(0, 1000);
  }
  spec.initial_friction = read_initial_friction(fields);
  spec.rest_length = read_rest_length(fields, spec.pretension);
}

void read_shear_cycles(Fields& fields, ExperimentSpec& spec) {
  if (auto v = fields.optional("transverse_tension")) {
    spec.transverse_tension = v->quantity_from_zero(Dimension::force_per_length);
  }
  spec.initial_friction = read_initial_friction(fields);
}

// Moments are per width: the size of the specimen is kept for the record.
void read_pure_bending(Fields& fields, ExperimentSpec& spec) {
  spec.direction = fields.require("direction").choice({"warp", "weft", "bias"});
  if (auto v = fields.optional("length")) spec.length = v->positive_quantity(Dimension::length);
  if (auto v = fields.optional("width")) spec.width = v->positive_quantity(Dimension::length);
  spec.initial_friction = read_initial_friction(fields);
}

void read_buckling_bend(Fields& fields, ExperimentSpec& spec) {
  const bool up = fields.require("side").choice({"down", "up"}) == "up";
  spec.side = up ? BucklingSide::up : BucklingSide::down;
  spec.rest_length = read_rest_length(fields, 0);
}

void read_session_fields(Fields& fields, ExperimentSpec& spec) {
  if (auto v = fields.optional("objective")) {
    spec.objective = sheet_objective(
        v->choice({"clip-forces", "parallel-clip-forces", "axial-clip-forces", "positions"}));
  }
  if (auto v = fields.optional("cord_friction")) {
    spec.cord_friction.unknown = v->text() == "unknown";
    if (!spec.cord_friction.unknown) {
      spec.cord_friction.width = v->quantity_from_zero(Dimension::force);
    }
  }
}

// The fields that belong to the type; those of types for later are kept as they are.
void read_type_fields(Fields& fields, const Defaults& defaults, ExperimentSpec& spec) {
  if (spec.type == "hanging-weights") {
    read_strip(fields, defaults, spec);
    read_hanging_weights(fields, spec);
  } else if (spec.type == "tensile-cycles") {
    read_strip(fields, defaults, spec);
    read_tensile_cycles(fields, spec);
  } else if (spec.type == "shear-cycles") {
    read_shear_cycles(fields, spec);
  } else if (spec.type == "pure-bending") {
    read_pure_bending(fields, spec);
  } else if (spec.type == "buckling-bend") {
    read_strip(fields, defaults, spec);
    read_buckling_bend(fields, spec);
  } else if (bends_by_weight(spec.type)) {
    read_bent_strip(fields, defaults, spec);
  } else if (measures_sheets(spec.type)) {
    read_session_fields(fields, spec);
  } else {
    for (auto& [key, value] : fields.all()) {
      if (!value.is_scalar()) continue;
      if (key != "name" && key != "type" && key != "data") spec.other_fields[key] = value.text();
    }
  }
}

ExperimentSpec read_experiment(const Value& node, const Defaults& defaults,
                               std::set<std::string>& names) {
  Fields fields = node.fields();
  ExperimentSpec spec;
  spec.where = node.location();
  spec.name = read_experiment_name(fields.require("name"), names);
  spec.type = read_type(fields.require("type"));
  spec.data = read_data_source(fields.require("data"));
  read_type_fields(fields, defaults, spec);
  if (auto v = fields.optional("standard")) spec.standard = v->text();
  // Of sessions noise is estimated, and a frame is not a row.
  const bool in_rows = !measures_sheets(spec.type);
  if (auto v = in_rows ? fields.optional("noise") : std::nullopt) {
    spec.noise = read_noise(*v, spec.type);
  }
  if (auto v = in_rows ? fields.optional("exclude") : std::nullopt) {
    for (const Value& rows : v->items()) spec.excluded.push_back(read_excluded_rows(rows));
  }
  fields.finish();
  return spec;
}

std::vector<ExperimentSpec> read_experiments(const Value& list, const Defaults& defaults) {
  std::vector<ExperimentSpec> specs;
  std::set<std::string> names;
  for (const Value& node : list.items()) specs.push_back(read_experiment(node, defaults, names));
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

void read_sheet_mesh(const Value& node, ModelOptions& model) {
  if (!node.is_mapping()) {
    model.measured_mesh = node.choice({"measured"}) == "measured";
    return;
  }
  Fields fields = node.fields();
  model.mesh_edge = fields.require("edge").positive_quantity(Dimension::length);
  fields.finish();
}

ModelOptions read_model(Fields& study) {
  ModelOptions model;
  const auto node = study.optional("model");
  if (!node) return model;
  Fields fields = node->fields();
  if (auto v = fields.optional("kind")) v->choice({"cloth"});
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

std::vector<std::string> read_texts(const Value& list) {
  std::vector<std::string> texts;
  for (const Value& item : list.items()) texts.push_back(item.text());
  if (texts.empty()) list.fail("is empty", "at least one name");
  return texts;
}

PlanStage read_plan_stage(const Value& node) {
  Fields fields = node.fields();
  PlanStage stage;
  stage.where = node.location();
  const std::vector<std::string_view> known{"stretch.weft", "stretch.warp", "shear",
                                            "bend.weft",    "bend.warp",    "bend.diagonal"};
  const Value components = fields.require("components");
  for (const Value& item : components.items()) stage.components.push_back(item.choice(known));
  if (stage.components.empty()) components.fail("is empty", "at least one component");
  stage.experiments = read_texts(fields.require("experiments"));
  fields.finish();
  return stage;
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
  if (auto v = fields.optional("monotone_stress")) fit.monotone_stress = v->flag();
  if (auto v = fields.optional("plan")) {
    for (const Value& stage : v->items()) fit.plan.push_back(read_plan_stage(stage));
  }
  fit.bounds = read_map(fields, "bounds", read_bounds);
  fit.fix = read_map(fields, "fix", [](const Value& v) { return v.number(); });
  fit.priors = read_map(fields, "priors", read_prior);
  fields.finish();
  return fit;
}

// In one dimension a strip tells a component of its own, and there is none at 30 degrees.
void refuse_oblique_strips_in_one_dimension(const Study& study) {
  if (study.model.strips_as_sheets) return;
  for (const ExperimentSpec& spec : study.experiments) {
    if (!spec.oblique_angle) continue;
    throw InputError({spec.where.file, spec.where.line, spec.where.field + ".direction"},
                     quoted_value(spec.direction) + " has no component of its own in one dimension",
                     "`model: {strips: sheet}`, or warp, weft or bias");
  }
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

std::unique_ptr<ComponentExperiment> read_experiment(const ExperimentSpec& spec, const Study& study) {
  return make_experiment(spec, DataRows(spec.data), study.density, study.model.membrane);
}

Study read_study(const std::filesystem::path& path) {
  const Document document = read_yaml(path);
  Fields fields = Value(document).fields();
  require_document(fields, "study", 1);

  Study study;
  study.file = path.string();
  study.name = fields.require("name").text();
  if (auto v = fields.optional("density")) {
    study.density = v->positive_quantity(Dimension::area_density);
  }
  study.info = fields.texts("info");
  study.conditions = read_conditions(fields);
  const Defaults defaults = read_defaults(fields);
  study.experiments = read_experiments(fields.require("experiments"), defaults);
  study.model = read_model(fields);
  refuse_oblique_strips_in_one_dimension(study);
  study.fit = read_fit(fields);
  if (auto v = fields.optional("validate")) apply_validate(*v, study);
  fields.finish();
  return study;
}

}  // namespace pliant
