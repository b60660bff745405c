#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/experiment/test_type.h"
#include "pliant/study/virtual_lab.h"

#include "apps/pliant/file_info.h"

namespace pliant {
namespace {

std::string specimens_text(const VirtualLab& lab) {
  if (lab.specimen_variation == 0) return fmt::format("{}", lab.specimens);
  return fmt::format("{}, whose parameters vary by {}", lab.specimens,
                     format_quantity(lab.specimen_variation, Dimension::fraction, kInfoDigits));
}

void add_experiment(const VirtualTest& test, FileInfo& info) {
  Json json{{"name", test.name}, {"type", test.type().name}};
  json.update(test.facts());
  info.json["experiments"].push_back(std::move(json));
  const std::string heading = test.heading();
  info.lines.push_back(labelled(
      test.name, fmt::format("{}{}{}", test.type().name, heading.empty() ? "" : ", ", heading)));
  for (const auto& [label, text] : test.description()) {
    info.lines.push_back(labelled(label, text, 1));
  }
}

}  // namespace

FileInfo lab_info(const std::filesystem::path& path) {
  const VirtualLab lab = read_lab(path);
  FileInfo info = begin_info(path, "lab/1");
  info.json["name"] = lab.name;
  info.json["material"] = lab.material.name;
  info.json["specimens"] = lab.specimens;
  info.json["specimen_variation"] = lab.specimen_variation;
  info.json["experiments"] = Json::array();
  info.lines.push_back(labelled("name", lab.name));
  info.lines.push_back(labelled("material", lab.material.name));
  info.lines.push_back(labelled("specimens", specimens_text(lab)));
  for (const auto& test : lab.experiments) add_experiment(*test, info);
  info.json["warnings"] = info.warnings;
  return info;
}

}  // namespace pliant
