#include "pliant/imaging/photo_study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/quantity.h"

namespace pliant {

void begin_study(const std::vector<std::filesystem::path>& photos, const PhotoStudyHead& head,
                 YAML::Emitter& yaml) {
  constexpr int kDigits = 15;  // as many as a double always keeps
  std::vector<std::string> names;
  for (const auto& photo : photos) names.push_back(photo.filename().string());
  yaml << YAML::BeginMap;
  yaml << YAML::Key << "pliant" << YAML::Value << "study/1";
  yaml << YAML::Key << "name" << YAML::Value << YAML::DoubleQuoted << head.name;
  if (head.density) {
    yaml << YAML::Key << "density" << YAML::Value
         << format_quantity(*head.density, Dimension::area_density, kDigits);
  }
  yaml << YAML::Key << "info" << YAML::Value << YAML::BeginMap;
  yaml << YAML::Key << "source" << YAML::Value << YAML::DoubleQuoted
       << fmt::format("photographs {}", fmt::join(names, ", "));
  yaml << YAML::Key << "scale" << YAML::Value
       << format_quantity(head.scale, Dimension::length, kDigits) + " a pixel";
  yaml << YAML::EndMap;
  yaml << YAML::Key << "experiments" << YAML::Value;
}

std::string drawing_name(const std::filesystem::path& photo, const char* what,
                         std::set<std::string>& taken) {
  std::string name = photo.stem().string();
  while (!taken.insert(name).second) name += "-";
  return fmt::format("{}-{}.png", name, what);
}

}  // namespace pliant
