#include "pliant/material/limit_fields.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

double read_largest(const Value& value) {
  const double largest = value.number();
  if (largest <= 0) {
    value.fail("is not above 0, the energy of the material at rest", "an energy above 0");
  }
  return largest;
}

std::map<std::string, NumberError> read_limit_errors(const Value& node) {
  Fields fields = node.fields();
  std::map<std::string, NumberError> errors;
  if (auto v = fields.optional("energy")) errors["energy"] = read_number_error(*v);
  fields.finish();
  return errors;
}

void require_law(const Value& of, const EnergyLimit& limit, const Material& material) {
  for (const std::string& component : limit.of) {
    const auto found = material.components.find(component);
    if (found != material.components.end() && found->second.stiffness) continue;
    of.fail(fmt::format("names {}, of which the material has no law", quoted_value(component)),
            "components with a stiffness or addends");
  }
}

}  // namespace

NumberError read_number_error(const Value& node) {
  Fields fields = node.fields();
  NumberError error;
  if (auto sd = fields.optional("std_error")) {
    error.std_error = sd->number();
    if (*error.std_error < 0) sd->fail("is negative", "a number of at least 0");
  }
  if (auto limit = fields.optional("limit")) error.limit = limit->number();
  error.determined =
      *determination_named(fields.require("determined")
                               .choice({"within 10 %", "within 30 %", "weak", "not determined"}));
  if (auto told_by = fields.optional("told_by")) error.told_by = told_by->text();
  fields.finish();
  return error;
}

Json number_error_json(const NumberError& error) {
  Json json{{"determined", name_of(error.determined)}};
  if (error.std_error) json["std_error"] = *error.std_error;
  if (error.limit) json["limit"] = *error.limit;
  if (!error.told_by.empty()) json["told_by"] = error.told_by;
  return json;
}

std::vector<std::string> read_limited_components(const Value& of, MaterialKind kind,
                                                 std::vector<std::string>& taken) {
  const std::vector<std::string> known = limitable_components(kind);
  const std::vector<std::string_view> names(known.begin(), known.end());
  std::vector<std::string> chosen;
  for (const Value& item : of.items()) {
    const std::string component = item.choice(names);
    if (std::ranges::find(taken, component) != taken.end()) {
      item.fail("is in two limits, or twice in one", "each component once");
    }
    taken.push_back(component);
    chosen.push_back(component);
  }
  if (chosen.empty()) of.fail("is empty", "at least one component");
  const auto place = [&](const std::string& component) {
    return std::ranges::find(known, component) - known.begin();
  };
  std::ranges::sort(chosen, {}, place);
  return chosen;
}

std::vector<EnergyLimit> read_limits(const Value& list, const Material& material) {
  std::vector<EnergyLimit> limits;
  std::vector<std::string> taken;
  for (const Value& item : list.items()) {
    Fields fields = item.fields();
    EnergyLimit limit;
    const Value of = fields.require("of");
    limit.of = read_limited_components(of, material.kind, taken);
    require_law(of, limit, material);
    limit.energy = read_largest(fields.require("energy"));
    if (auto v = fields.optional("errors")) limit.errors = read_limit_errors(*v);
    fields.finish();
    limits.push_back(std::move(limit));
  }
  return limits;
}

Json limits_json(const std::vector<EnergyLimit>& limits) {
  Json list = Json::array();
  for (const EnergyLimit& limit : limits) {
    Json& json = list.emplace_back(Json{{"of", limit.of}, {"energy", limit.energy}});
    for (const auto& [number, error] : limit.errors) {
      json["errors"][number] = number_error_json(error);
    }
  }
  return list;
}

}  // namespace pliant
