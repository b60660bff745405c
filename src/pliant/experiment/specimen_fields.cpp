#include "pliant/experiment/specimen_fields.h"

#include "pliant/base/quantity.h"

namespace pliant {
namespace {

double read_size(Fields& fields, std::string_view key, double fallback) {
  if (fallback > 0 && !fields.optional(key)) return fallback;
  return fields.require(key).positive_quantity(Dimension::length);
}

/// A number of clamps, or that it is unknown; what it was where it is not given.
void read_clamp(Fields& fields, std::string_view key, double& value, bool& is_known) {
  const auto v = fields.optional(key);
  if (!v) return;
  is_known = v->text() != "unknown";
  value = is_known ? v->quantity_from_zero(Dimension::compliance) : 0;
}

}  // namespace

std::string read_direction(Fields& fields) {
  return fields.require("direction").choice({"warp", "weft", "bias"});
}

void read_length(Fields& fields, const SpecimenDefaults& defaults, TestSpec& spec) {
  spec.length = read_size(fields, "length", defaults.length);
}

void read_strip(Fields& fields, const SpecimenDefaults& defaults, TestSpec& spec) {
  read_length(fields, defaults, spec);
  spec.width = read_size(fields, "width", defaults.width);
}

void read_recorded_width(Fields& fields, const SpecimenDefaults& defaults, TestSpec& spec) {
  spec.width = defaults.width;
  if (auto v = fields.optional("width")) spec.width = v->positive_quantity(Dimension::length);
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

Clamps read_clamps(Fields& fields, const Clamps& defaults) {
  Clamps clamps = defaults;
  read_clamp(fields, "slip", clamps.slip, clamps.slip_is_known);
  read_clamp(fields, "compliance", clamps.compliance, clamps.compliance_is_known);
  return clamps;
}

double read_from_zero(Fields& fields, std::string_view key, Dimension dimension) {
  const auto v = fields.optional(key);
  return v ? v->quantity_from_zero(dimension) : 0;
}

WrittenFields written_size(const TestSpec& spec) {
  WrittenFields fields;
  if (spec.length > 0)
    fields.emplace_back("length", exact_quantity(spec.length, Dimension::length));
  if (spec.width > 0) fields.emplace_back("width", exact_quantity(spec.width, Dimension::length));
  return fields;
}

std::pair<std::string, std::string> written(InitialFriction friction) {
  return {"initial_friction", friction == InitialFriction::rest ? "rest" : "unknown"};
}

std::pair<std::string, std::string> written(RestLength rest_length) {
  return {"rest_length", rest_length == RestLength::known ? "known" : "unknown"};
}

WrittenFields written(const Clamps& clamps) {
  const auto text = [](double value, bool is_known) {
    return is_known ? exact_quantity(value, Dimension::compliance) : "unknown";
  };
  return {{"slip", text(clamps.slip, clamps.slip_is_known)},
          {"compliance", text(clamps.compliance, clamps.compliance_is_known)}};
}

}  // namespace pliant
