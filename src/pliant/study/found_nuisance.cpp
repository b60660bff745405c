#include "pliant/study/found_nuisance.h"

#include "pliant/io/document.h"
#include "pliant/io/fields.h"

namespace pliant {
namespace {

bool is_of_cord(const std::string& name) { return name.ends_with(".cord_friction"); }

/// Whether a fit wrote the material.
bool made(Fields& fit, const Material& material) {
  for (const char* key : {"study_sha256", "created"}) {
    const auto stated = material.provenance.find(key);
    const auto own = fit.optional(key);
    if (!own || stated == material.provenance.end() || own->text() != stated->second) return false;
  }
  return true;
}

}  // namespace

FoundNuisance nuisance_beside(const std::filesystem::path& file, const Material& material,
                              const std::string& study_sha256) {
  FoundNuisance found;
  const std::filesystem::path results = file.parent_path() / "fit.json";
  if (!std::filesystem::exists(results)) return found;
  const Document document = read_json(results);
  Fields fit = Value(document).fields();
  if (!made(fit, material)) return found;
  const bool same_study = fit.require("study_sha256").text() == study_sha256;
  for (const Value& item : fit.require("nuisance").items()) {
    Fields fields = item.fields();
    const std::string name = fields.require("name").text();
    const auto value = fields.optional("value");
    if (!value) continue;
    if (is_of_cord(name)) found.cords[name] = value->number();
    if (!is_of_cord(name) && same_study) found.others[name] = value->number();
  }
  return found;
}

}  // namespace pliant
