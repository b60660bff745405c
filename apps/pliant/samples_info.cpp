#include "apps/pliant/samples_info.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/quantity.h"
#include "pliant/material/material_samples.h"

namespace pliant {
namespace {

constexpr int kWidthDigits = 4;

}  // namespace

void add_samples(const Material& material, FileInfo& info) {
  if (!is_heterogeneous(material)) return;
  std::vector<std::string> differing;
  for (const auto& [name, component] : material.samples.at.front().components) {
    differing.push_back(name);
  }
  const std::size_t count = material.samples.at.size();
  info.json["samples"] = {{"count", count}, {"width", material.samples.width}, {"of", differing}};
  info.lines.push_back(
      labelled("samples",
               fmt::format("{} places with Gaussians of {}; {} above and below: their mean", count,
                           format_quantity(material.samples.width, Dimension::length, kWidthDigits),
                           fmt::join(differing, ", "))));
}

}  // namespace pliant
