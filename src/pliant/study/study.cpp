#include "pliant/study/study.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/base/name_pattern.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/registry.h"
#include "pliant/experiment/specimen_fields.h"
#include "pliant/io/document.h"
#include "pliant/io/fields.h"
#include "pliant/io/result_name.h"
#include "pliant/measurement/data_source.h"
#include "pliant/study/blank_fields.h"
#include "pliant/study/model_file.h"
#include "pliant/study/solid_study.h"
#include "pliant/study/told_sizes.h"

namespace pliant {
namespace {

// Rubber is measured far into compression and tension.
constexpr int kSolidControlPoints = 10;

constexpr long kMostRows = 1'000'000'000;

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

SpecimenDefaults read_defaults(Fields& fields) {
  SpecimenDefaults defaults;
  const auto node = fields.optional("defaults");
  if (!node) return defaults;
  Fields inner = node->fields();
  if (auto v = inner.optional("length")) defaults.length = v->positive_quantity(Dimension::length);
  if (auto v = inner.optional("width")) defaults.width = v->positive_quantity(Dimension::length);
  defaults.clamps = read_clamps(inner, {});
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

StatedNoise read_noise(const Value& node, const std::vector<Channel>& channels) {
  Fields fields = node.fields();
  StatedNoise noise;
  for (const Channel& channel : channels) {
    if (auto v = fields.optional(channel.key)) {
      noise.*channel.stated = v->positive_quantity(channel.dimension);
    }
  }
  fields.finish();
  return noise;
}

ExperimentSpec read_experiment(const Value& node, const SpecimenDefaults& defaults,
                               std::set<std::string>& names) {
  Fields fields = node.fields();
  ExperimentSpec spec;
  spec.where = node.location();
  spec.name = read_experiment_name(fields.require("name"), names);
  const TestType& type = read_test_type(fields.require("type"));
  spec.type = type.name;
  spec.data = read_data_source(fields.require("data"));
  spec.test = type.read(fields, with_told_sizes(defaults, fields, type, spec), spec);
  doubt_stated_sizes(spec);
  if (type.facts.only_predicted) spec.role = ExperimentRole::validate;
  if (auto v = fields.optional("standard")) spec.standard = v->text();
  if (auto v = type.facts.only_predicted ? std::nullopt : fields.optional("weight")) {
    spec.weight = v->number();
    if (!(spec.weight > 0)) v->fail("is not positive", "a weight above 0; 1 counts as usual");
  }
  // Of sheets noise is estimated, and a frame is not a row.
  const bool in_rows = !type.channels.empty();
  if (auto v = in_rows ? fields.optional("noise") : std::nullopt) {
    spec.noise = read_noise(*v, type.channels);
  }
  if (auto v = in_rows ? fields.optional("exclude") : std::nullopt) {
    for (const Value& rows : v->items()) spec.excluded.push_back(read_excluded_rows(rows));
  }
  fields.finish();
  return spec;
}

/// A specimen is followed from one test to the next of its kind.
void require_earlier(const ExperimentSpec& spec, const std::vector<ExperimentSpec>& earlier) {
  if (spec.after.empty()) return;
  const auto before = std::ranges::find(earlier, spec.after, &ExperimentSpec::name);
  const bool fits =
      before != earlier.end() && before->type == spec.type && before->direction == spec.direction;
  if (fits) return;
  throw InputError(
      after_location(spec),
      before == earlier.end()
          ? quoted_value(spec.after) + " names no experiment that stands before it"
          : quoted_value(spec.after) + " is of another type or direction",
      fmt::format("an earlier experiment of the list, {} along {}", spec.type, spec.direction));
}

std::vector<ExperimentSpec> read_experiments(const Value& list, const SpecimenDefaults& defaults) {
  std::vector<ExperimentSpec> specs;
  std::set<std::string> names;
  for (const Value& node : list.items()) {
    ExperimentSpec spec = read_experiment(node, defaults, names);
    require_earlier(spec, specs);
    specs.push_back(std::move(spec));
  }
  if (specs.empty()) list.fail("has no experiment", "at least one");
  return specs;
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

PlanStage read_plan_stage(const Value& node, MaterialKind kind) {
  Fields fields = node.fields();
  PlanStage stage;
  stage.where = node.location();
  std::vector<std::string_view> known(cloth_component_names().begin(),
                                      cloth_component_names().end());
  // Of strips alone.
  std::erase_if(
      known, [](std::string_view name) { return name == "stretch.bias" || is_contraction(name); });
  const Value components = fields.require("components");
  for (const Value& item : components.items()) {
    const bool any = kind == MaterialKind::solid || is_sheet_pair(item.text());
    stage.components.push_back(any ? item.text() : item.choice(known));
  }
  if (stage.components.empty()) components.fail("is empty", "at least one component");
  stage.experiments = read_texts(fields.require("experiments"));
  fields.finish();
  return stage;
}

Convexity read_convexity(const Value& value, MaterialKind kind) {
  if (kind != MaterialKind::solid) {
    value.fail("is of solids", "`monotone_stress`, which keeps energies of cloth convex");
  }
  const std::string convexity = value.choice({"within", "projected", "free"});
  if (convexity == "free") return Convexity::free;
  return convexity == "within" ? Convexity::within : Convexity::projected;
}

FitOptions read_fit(Fields& study, MaterialKind kind) {
  FitOptions fit;
  if (kind == MaterialKind::solid) fit.control_points = kSolidControlPoints;
  const auto node = study.optional("fit");
  if (!node) return fit;
  Fields fields = node->fields();
  if (auto v = fields.optional("estimator")) {
    fit.estimator =
        v->choice({"path", "anchor"}) == "path" ? EstimatorKind::path : EstimatorKind::anchor;
  }
  if (auto v = fields.optional("control_points")) fit.control_points = v->integer(1, 20);
  if (auto v = fields.optional("loss")) {
    fit.loss = *robust_loss_named(v->choice({"none", "huber", "cauchy"}));
  }
  if (auto v = fields.optional("monotone_stress")) fit.monotone_stress = v->flag();
  if (auto v = fields.optional("convexity")) fit.convexity = read_convexity(*v, kind);
  if (auto v = fields.optional("plan")) {
    for (const Value& stage : v->items()) fit.plan.push_back(read_plan_stage(stage, kind));
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
    if (!spec.test->is_only_sheet()) continue;
    throw InputError({spec.where.file, spec.where.line, spec.where.field + ".direction"},
                     quoted_value(spec.direction) + " has no component of its own in one dimension",
                     "`model: {strips: sheet}`, or warp, weft or bias");
  }
}

Acceptance read_acceptance(const Value& node) {
  Fields fields = node.fields();
  Acceptance accept;
  const auto read = [&](const char* key, double& share) {
    if (auto v = fields.optional(key)) share = v->positive_quantity(Dimension::fraction);
  };
  read("rms", accept.rms);
  read("span", accept.span);
  read("loop", accept.loop);
  read("unexplained", accept.unexplained);
  fields.finish();
  return accept;
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

std::unique_ptr<ComponentExperiment> read_experiment(const ExperimentSpec& spec,
                                                     const Study& study) {
  const TestType& type = spec.test->type();
  PLIANT_ASSERT(type.make, "sheets are read as sessions");
  return type.make(spec, DataRows(spec.data), {study.density, study.model.membrane});
}

Study read_study(const std::filesystem::path& path) { return study_of(read_yaml(path)); }

Study study_of(const Document& document) {
  refuse_blanks(document);
  Fields fields = Value(document).fields();
  require_document(fields, "study", 1);

  Study study;
  study.file = document.file;
  study.name = fields.require("name").text();
  const auto density = fields.optional("density");
  study.info = fields.texts("info");
  study.conditions = read_conditions(fields);
  const SpecimenDefaults defaults = read_defaults(fields);
  study.experiments = read_experiments(fields.require("experiments"), defaults);
  const MaterialKind kind = measures_solids(study) ? MaterialKind::solid : MaterialKind::cloth;
  if (density) {
    study.density = density->positive_quantity(
        kind == MaterialKind::solid ? Dimension::volume_density : Dimension::area_density);
  }
  study.model = read_model(fields, kind);
  refuse_oblique_strips_in_one_dimension(study);
  study.fit = read_fit(fields, kind);
  if (auto v = fields.optional("validate")) apply_validate(*v, study);
  if (auto v = fields.optional("accept")) study.accept = read_acceptance(*v);
  fields.finish();
  return study;
}

}  // namespace pliant
