#include "pliant/study/found_nuisance.h"

#include "pliant/study/results.h"

namespace pliant {
namespace {

bool is_of_cord(const std::string& name) { return name.ends_with(".cord_friction"); }

/// Whether a fit wrote the material.
bool made(const RunFacts& fit, const Material& material) {
  const auto states = [&](const char* key, const std::string& own) {
    const auto stated = material.provenance.find(key);
    return !own.empty() && stated != material.provenance.end() && stated->second == own;
  };
  return states("study_sha256", fit.study_sha256) && states("created", fit.created);
}

}  // namespace

FoundNuisance nuisance_beside(const std::filesystem::path& file, const Material& material,
                              const std::string& study_sha256) {
  FoundNuisance found;
  const std::filesystem::path directory = file.parent_path();
  if (!std::filesystem::exists(directory / "fit.json")) return found;
  const Results fit = read_results(directory);
  if (!made(fit.facts, material)) return found;
  const bool same_study = fit.facts.study_sha256 == study_sha256;
  for (const ResultParameter& number : fit.nuisance) {
    if (!number.value) continue;
    if (is_of_cord(number.name)) {
      found.cords[number.name] = *number.value;
    } else if (same_study) {
      found.others[number.name] = *number.value;
    }
  }
  return found;
}

}  // namespace pliant
