#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "pliant/material/material.h"

namespace pliant {

/// What a fit has found beside its material, of single experiments: numbers by their names (SI).
struct FoundNuisance {
  std::map<std::string, double> cords;  ///< friction of cords, which belongs to the apparatus
  std::map<std::string, double> others;
};

/// What fit.json beside a material tells, where it is of the fit that made the material; nothing
/// else.
/// @param file          of the material
/// @param study_sha256  of the study to be predicted: force offsets and the like are those of the
///                      data, and taken where this is the study of the fit
/// @throws InputError where fit.json cannot be read
FoundNuisance nuisance_beside(const std::filesystem::path& file, const Material& material,
                              const std::string& study_sha256);

}  // namespace pliant
