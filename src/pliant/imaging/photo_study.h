#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace pliant {

/// What studies of photographs say of themselves.
struct PhotoStudyHead {
  std::string name;               ///< of the fabric
  std::optional<double> density;  ///< kg/m^2
  double scale = 0;               ///< length of a pixel (m)
};

/// Begins a study: what stands before its list of experiments, which goes on in the emitter.
void begin_study(const std::vector<std::filesystem::path>& photos, const PhotoStudyHead& head,
                 YAML::Emitter& yaml);

/// A name of its own for each drawing, where photographs of several folders are called alike:
/// NAME-what.png.
std::string drawing_name(const std::filesystem::path& photo, const char* what,
                         std::set<std::string>& taken);

}  // namespace pliant
