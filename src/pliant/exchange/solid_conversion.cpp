#include "pliant/exchange/solid_conversion.h"

#include <algorithm>
#include <array>

#include "pliant/base/errors.h"
#include "pliant/base/nearest_name.h"
#include "pliant/exchange/febio_file.h"
#include "pliant/exchange/keyword_file.h"

namespace pliant {
namespace {

constexpr std::array kFormats{
    ConversionFormat{"febio", "FEBio", ".feb", febio_file},
    ConversionFormat{"abaqus", "Abaqus", ".inp",
                     [](const SolidToConvert& s) { return keyword_file(s, KeywordTool::abaqus); }},
    ConversionFormat{
        "calculix", "CalculiX", ".inp",
        [](const SolidToConvert& s) { return keyword_file(s, KeywordTool::calculix); }},
};

}  // namespace

std::span<const ConversionFormat> conversion_formats() { return kFormats; }

const ConversionFormat& conversion_format(std::string_view name) {
  const auto found = std::ranges::find(kFormats, name, &ConversionFormat::name);
  if (found != kFormats.end()) return *found;
  std::vector<std::string> names;
  for (const ConversionFormat& format : kFormats) names.emplace_back(format.name);
  throw InputError({"--to"}, quoted_value(name) + did_you_mean(name, names), list_of_names(names));
}

}  // namespace pliant
