#include "pliant/experiment/drape/virtual_drape.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/base/add_once.h"
#include "pliant/experiment/drape/drape_tables.h"
#include "pliant/experiment/drape/draped_sheet.h"
#include "pliant/experiment/drape/silhouette_picture.h"
#include "pliant/experiment/virtual_sheet.h"

namespace pliant {
namespace {

constexpr int kDigits = 4;

/// 1, 2, ...
std::vector<NamedSilhouette> numbered(const std::vector<DrapedSheet>& draped) {
  std::vector<NamedSilhouette> silhouettes;
  for (const DrapedSheet& sheet : draped) {
    silhouettes.push_back({std::to_string(silhouettes.size() + 1), sheet});
  }
  return silhouettes;
}

}  // namespace

void VirtualDrape::require(const Material& material) const { require_drapable(material, where); }

VirtualData VirtualDrape::measure(const VirtualSpecimen& specimen, const VirtualWork& work) const {
  const Material material = sheet_of(specimen);
  const RandomStream random = specimen.random.split(specimen.name);
  std::vector<DrapedSheet> draped;
  VirtualData data;
  for (int repeat = 1; repeat <= repeats; ++repeat) {
    draped.push_back(drape(material, setup, random.split(fmt::format("repeat {}", repeat)),
                           {.stop = work.stop}));
    for (const std::string& warning : draped.back().warnings) add_once(warning, data.warnings);
    work.done(1);
  }
  for (const std::string& advice : size_advice(draped, setup)) add_once(advice, data.warnings);
  data.files = {{specimen.name + ".csv", drape_table(draped)},
                {fmt::format("silhouettes/{}.csv", specimen.name), outline_table(draped)},
                {fmt::format("silhouettes/{}.svg", specimen.name),
                 silhouette_picture(specimen.name, numbered(draped), setup)}};
  return data;
}

WrittenFields VirtualDrape::study_fields() const { return written(setup); }

WrittenFields VirtualDrape::description() const {
  const auto length = [](double value) {
    return format_quantity(value, Dimension::length, kDigits);
  };
  return {
      {"specimen", fmt::format("{} on a disc of {}", length(setup.specimen), length(setup.disc))},
      {"history", std::string(name_of(setup.history))},
      {"repeats", std::to_string(repeats)},
      {"mesh", "edges of " + length(setup.edge)}};
}

nlohmann::ordered_json VirtualDrape::facts() const {
  return {{"specimen", setup.specimen},
          {"disc", setup.disc},
          {"history", name_of(setup.history)},
          {"repeats", repeats},
          {"edge", setup.edge}};
}

}  // namespace pliant
