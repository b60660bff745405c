#include "pliant/material/material_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "pliant/io/document.h"
#include "pliant/io/fields.h"
#include "pliant/material/addend/addend_registry.h"
#include "pliant/material/green_strain_check.h"
#include "pliant/material/limit_fields.h"
#include "pliant/material/material_samples.h"
#include "pliant/material/sample_place.h"
#include "pliant/material/solid/principal_metric.h"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

double not_negative(const Value& value) {
  const double number = value.number();
  if (number < 0) value.fail("is negative", "a number of at least 0");
  return number;
}

double positive(const Value& value) {
  const double number = value.number();
  if (number <= 0) value.fail("is not positive", "a number above 0");
  return number;
}

ScalarCurve read_control_points(const std::string& kind, Fields& fields, bool even_component) {
  Value strain = fields.require("strain");
  Value value = fields.require("value");
  std::vector<double> knots = strain.numbers();
  std::vector<double> values = value.numbers();
  if (knots.empty()) strain.fail("is empty", "at least one strain");
  if (knots.size() != values.size()) {
    value.fail("has " + std::to_string(values.size()) + " values",
               "as many as `strain` (" + std::to_string(knots.size()) + ")");
  }
  for (size_t i = 1; i < knots.size(); ++i) {
    if (knots[i] <= knots[i - 1]) strain.fail("does not increase", "strictly increasing strains");
  }
  // FORMATS: for shear and bending a list that starts at 0 is mirrored.
  const bool even = even_component && knots.front() >= 0;
  if (kind == "energy") {
    if (std::ranges::find(knots, 0.0) != knots.end()) {
      strain.fail("has a control point at rest, where an energy is 0", "strains other than 0");
    }
    return ScalarCurve::energy(std::move(knots), std::move(values), even);
  }
  const auto make = kind == "spline" ? ScalarCurve::spline : ScalarCurve::hermite;
  return make(std::move(knots), std::move(values), even);
}

ScalarCurve read_curve(const Value& node, bool even_component) {
  Fields fields = node.fields();
  const std::string kind =
      fields.require("curve").choice({"constant", "affine", "hermite", "spline", "energy"});
  const auto read = [&]() -> ScalarCurve {
    if (kind == "constant") return ScalarCurve::constant(fields.require("value").number());
    if (kind == "affine") {
      const double k1 = fields.require("k1").number();
      return ScalarCurve::affine(k1, fields.require("k2").number());
    }
    return read_control_points(kind, fields, even_component);
  };
  ScalarCurve curve = read();
  fields.finish();
  return curve;
}

DahlParameters read_dahl(Fields& fields) {
  DahlParameters dahl;
  dahl.a = not_negative(fields.require("a"));
  dahl.b = not_negative(fields.require("b"));
  dahl.tau = positive(fields.require("tau"));
  return dahl;
}

ComponentFriction read_friction(const Value& node) {
  Fields fields = node.fields();
  fields.require("law").choice({"dahl"});
  ComponentFriction friction;
  if (std::optional<Value> side = fields.optional("positive")) {
    Fields positive_side = side->fields();
    friction.positive = read_dahl(positive_side);
    positive_side.finish();
    Fields negative_side = fields.require("negative").fields();
    friction.negative = read_dahl(negative_side);
    negative_side.finish();
  } else {
    friction.positive = read_dahl(fields);
  }
  fields.finish();
  return friction;
}

Addend read_addend(const Value& node) {
  Fields fields = node.fields();
  const AddendKind& kind = read_addend_kind(fields.require("law"));
  Eigen::VectorXd values(std::ssize(kind.parameters));
  for (std::size_t i = 0; i < kind.parameters.size(); ++i) {
    const AddendParameter& parameter = kind.parameters[i];
    const Value value = fields.require(parameter.name);
    values(static_cast<Eigen::Index>(i)) = parameter.smallest > 0   ? positive(value)
                                           : parameter.smallest < 0 ? value.number()
                                                                    : not_negative(value);
  }
  fields.finish();
  return {kind, values};
}

ComponentStatus read_status(const Value& value) {
  const std::string name = value.choice({"measured", "assumed", "unmeasured"});
  for (const ComponentStatus status :
       {ComponentStatus::measured, ComponentStatus::assumed, ComponentStatus::unmeasured}) {
    if (name == name_of(status)) return status;
  }
  return ComponentStatus::measured;
}

std::pair<double, double> read_range(const Value& value) {
  const std::vector<double> ends = value.numbers();
  if (ends.size() != 2 || ends[0] > ends[1])
    value.fail("is no range", "[smallest, largest] strain");
  return {ends[0], ends[1]};
}

/// @param law  of the component, whose numbers they are of
std::map<std::string, NumberError> read_errors(const Value& node, const ComponentLaw& law) {
  std::vector<std::string> names = parameter_names(law, "");
  for (std::string& name : names) name.erase(0, 1);  // the dot after the component
  std::map<std::string, NumberError> errors;
  for (const auto& [name, value] : node.fields().all()) {
    if (std::ranges::find(names, name) == names.end()) {
      value.fail("is no number of this component",
                 fmt::format("one of {}", fmt::join(names, ", ")));
    }
    errors[name] = read_number_error(value);
  }
  return errors;
}

MaterialComponent read_component(const Value& node, bool even) {
  Fields fields = node.fields();
  MaterialComponent component;
  if (auto stiffness = fields.optional("stiffness")) {
    component.stiffness = read_curve(*stiffness, even);
  }
  if (auto addends = fields.optional("addends")) {
    for (const Value& addend : addends->items()) component.addends.push_back(read_addend(addend));
  }
  if (!component.addends.empty() && !component.stiffness) {
    component.stiffness = ScalarCurve::none();
  }
  const bool has_law = component.stiffness.has_value();
  if (auto friction = fields.optional("friction")) component.friction = read_friction(*friction);
  if (auto range = fields.optional("range")) component.range = read_range(*range);
  component.status = has_law ? ComponentStatus::measured : ComponentStatus::unmeasured;
  if (auto status = fields.optional("status")) {
    component.status = read_status(*status);
    if (component.status != ComponentStatus::unmeasured && !has_law) {
      status->fail("is `" + std::string(name_of(component.status)) + "` without a stiffness",
                   "`unmeasured`, or a stiffness");
    }
  }
  if (auto errors = fields.optional("errors")) {
    if (!has_law) errors->fail("stands beside no numbers", "a stiffness or addends");
    component.errors = read_errors(*errors, law_of(component));
  }
  fields.finish();
  return component;
}

/// What cloth has beside its components.
void read_sheet(Fields& fields, Material& material) {
  if (auto membrane = fields.optional("membrane"))
    material.membrane = membrane_measure(membrane->choice({"stvk", "soft-constraint", "spring"}));
  if (auto bending = fields.optional("bending")) {
    material.bending = bending->choice({"discrete-shells", "spring"});
  }
  if (auto of = fields.optional("bending_of")) {
    material.bending_of = of->choice({"sheet", "hinges"});
  }
  if (auto mesh = fields.optional("bending_mesh")) material.bending_mesh = mesh->text();
}

/// Principal stretches change places where two of them pass each other: nothing can remember which
/// was which.
void require_no_memory(const std::string& name, const Value& node,
                       const MaterialComponent& component) {
  if (!find_principal_metric(solid_metric_of(name).value_or(name))) return;
  if (!component.stiffness) return;
  if (!law_of(component).remembers()) return;
  node.fail("has friction or another law that remembers, on principal stretches",
            "such laws on another strain");
}

/// Terms of two strains, whose names are formulas.
void read_pair_terms(Fields& fields, MaterialKind kind,
                     std::map<std::string, MaterialComponent>& components) {
  for (const std::string& name : fields.keys()) {
    if (!is_pair_term(name, kind)) continue;
    const auto component = fields.optional(name);
    if (!component) continue;
    if (const std::string usual = *pair_term_name(name, kind); usual != name) {
      component->fail("has its numbers written in another way", "the name " + usual);
    }
    components[name] = read_component(*component, /*even=*/false);
  }
}

/// @param material  its kind and membrane
std::map<std::string, MaterialComponent> read_components(const Value& node,
                                                         const Material& material) {
  const MaterialKind kind = material.kind;
  Fields fields = node.fields();
  std::map<std::string, MaterialComponent> components;
  for (const std::string& name : component_names(kind)) {
    if (auto component = fields.optional(name)) {
      components[name] = read_component(*component, is_even(name));
      require_no_memory(name, *component, components[name]);
    }
  }
  read_pair_terms(fields, kind, components);
  fields.finish();
  for (const auto& [name, component] : components) {
    if (kind == MaterialKind::cloth) require_green_strain(name, material.membrane, node);
  }
  return components;
}

void require_alike(const Value& node, const SampledComponents& sample,
                   const SampledComponents& first) {
  for (const auto& [name, component] : sample.components) {
    if (!component.stiffness) node.fail(quoted_value(name) + " has no numbers", "a stiffness");
    if (law_of(component).remembers()) {
      node.fail(quoted_value(name) + " has friction or another law that remembers",
                "samples of elastic components");
    }
  }
  const bool alike = std::ranges::equal(
      sample.components, first.components, [](const auto& one, const auto& other) {
        return one.first == other.first && are_alike(one.second, other.second);
      });
  if (!alike) {
    node.fail("differs from the first sample in more than numbers",
              "samples of the same components, curves and addends");
  }
}

/// The samples of a material, and the means of what they differ in.
void read_samples(const Value& node, Material& material) {
  Fields fields = node.fields();
  material.samples.width = positive(fields.require("width"));
  const Value list = fields.require("at");
  for (const Value& item : list.items()) {
    Fields sample = item.fields();
    SampledComponents& own = material.samples.at.emplace_back();
    own.place = read_sample_place(sample.require("place"), material.kind);
    const Value components = sample.require("components");
    own.components = read_components(components, material);
    require_alike(components, own, material.samples.at.front());
    sample.finish();
  }
  fields.finish();
  if (material.samples.at.empty()) list.fail("is empty", "at least one sample");
  for (const auto& [name, component] : material.samples.at.front().components) {
    if (!material.components.contains(name)) continue;
    list.fail("has " + quoted_value(name) + ", which stands under `components` too",
              "each component once: under `components` where it is the same everywhere");
  }
  if (!material.limits.empty()) node.fail("stands beside `limits`", "one of them");
  if (material.membrane == MembraneMeasure::spring || material.bending == "spring") {
    node.fail("stands beside springs", "a membrane of triangles and bending of discrete shells");
  }
  take_means(material);
}

/// The tree of a material file; a file that is no JSON at all may be a scene named by mistake.
Document read_material_document(const std::filesystem::path& path) {
  try {
    return read_json(path);
  } catch (const InputError& error) {
    if (!error.expected().empty()) throw;
    throw InputError(error.where(), error.problem(),
                     "a material file: JSON with \"pliant\": \"material/1\"");
  }
}

Json curve_json(const ScalarCurve& curve) {
  Json json{{"curve", name_of(curve.kind())}};
  switch (curve.kind()) {
    case CurveKind::none:
      break;
    case CurveKind::constant:
      json["value"] = curve.values()[0];
      break;
    case CurveKind::affine:
      json["k1"] = curve.values()[0];
      json["k2"] = curve.values()[1];
      break;
    case CurveKind::hermite:
    case CurveKind::spline:
    case CurveKind::energy:
      json["strain"] = curve.knots();
      json["value"] = curve.values();
      break;
  }
  return json;
}

Json dahl_json(const DahlParameters& dahl) {
  return Json{{"a", dahl.a}, {"b", dahl.b}, {"tau", dahl.tau}};
}

Json friction_json(const ComponentFriction& friction) {
  Json json{{"law", "dahl"}};
  if (friction.negative) {
    json["positive"] = dahl_json(friction.positive);
    json["negative"] = dahl_json(*friction.negative);
  } else {
    json.update(dahl_json(friction.positive));
  }
  return json;
}

Json addend_json(const Addend& addend) {
  Json json{{"law", addend.kind().name}};
  for (std::size_t i = 0; i < addend.kind().parameters.size(); ++i) {
    json[std::string(addend.kind().parameters[i].name)] =
        addend.values()(static_cast<Eigen::Index>(i));
  }
  return json;
}

Json component_json(const MaterialComponent& component) {
  Json json = Json::object();
  if (component.stiffness && component.stiffness->kind() != CurveKind::none) {
    json["stiffness"] = curve_json(*component.stiffness);
  }
  if (component.friction) json["friction"] = friction_json(*component.friction);
  for (const Addend& addend : component.addends) json["addends"].push_back(addend_json(addend));
  json["status"] = name_of(component.status);
  if (component.range) json["range"] = {component.range->first, component.range->second};
  for (const auto& [name, error] : component.errors) {
    json["errors"][name] = number_error_json(error);
  }
  return json;
}

Json components_json(const std::map<std::string, MaterialComponent>& components,
                     const Material& material) {
  Json json = Json::object();
  for (const std::string& name : ordered_components(components, material.kind)) {
    json[name] = component_json(components.at(name));
  }
  return json;
}

Json samples_json(const Material& material) {
  Json json{{"width", material.samples.width}, {"at", Json::array()}};
  for (const SampledComponents& sample : material.samples.at) {
    Json place{sample.place.x(), sample.place.y()};
    if (material.kind == MaterialKind::solid) place.push_back(sample.place.z());
    json["at"].push_back(
        {{"place", place}, {"components", components_json(sample.components, material)}});
  }
  return json;
}

}  // namespace

Material read_material(const std::filesystem::path& path) {
  return material_of(read_material_document(path));
}

Material material_of(const Document& document) {
  Fields fields = Value(document).fields();
  require_document(fields, "material", 1);

  Material material;
  material.name = fields.require("name").text();
  const std::string kind = fields.require("kind").choice({"cloth", "solid"});
  if (kind == name_of(MaterialKind::solid)) material.kind = MaterialKind::solid;
  if (auto density = fields.optional("density")) material.density = positive(*density);
  if (material.kind == MaterialKind::cloth) read_sheet(fields, material);
  material.components = read_components(fields.require("components"), material);
  if (auto limits = fields.optional("limits")) material.limits = read_limits(*limits, material);
  if (auto samples = fields.optional("samples")) read_samples(*samples, material);
  if (auto damping = fields.optional("damping")) {
    Fields inner = damping->fields();
    material.damping_fraction = not_negative(inner.require("fraction"));
    inner.finish();
  }
  material.info = fields.texts("info");
  material.provenance = fields.texts("provenance");
  fields.finish();
  return material;
}

std::string material_text(const Material& material) {
  Json json{{"pliant", "material/1"},
            {"name", material.name},
            {"kind", name_of(material.kind)},
            {"density", material.density > 0 ? Json(material.density) : Json(nullptr)}};
  if (material.kind == MaterialKind::cloth) {
    json["membrane"] = name_of(material.membrane);
    json["bending"] = material.bending;
    json["bending_of"] = material.bending_of;
    if (!material.bending_mesh.empty()) json["bending_mesh"] = material.bending_mesh;
  }
  std::map<std::string, MaterialComponent> shared = material.components;
  std::erase_if(shared, [&](const auto& own) { return differs_in(material, own.first); });
  json["components"] = components_json(shared, material);
  if (is_heterogeneous(material)) json["samples"] = samples_json(material);
  if (!material.limits.empty()) json["limits"] = limits_json(material.limits);
  if (material.damping_fraction) json["damping"] = {{"fraction", *material.damping_fraction}};
  if (!material.info.empty()) json["info"] = material.info;
  if (!material.provenance.empty()) json["provenance"] = material.provenance;
  return json.dump(2) + "\n";
}

}  // namespace pliant
