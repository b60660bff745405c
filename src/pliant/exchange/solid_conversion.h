#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "pliant/exchange/converted_solid.h"

namespace pliant {

/// A format of another tool's files.
struct ConversionFormat {
  std::string_view name;    ///< "febio", as the command line has it
  std::string_view tool;    ///< "FEBio"
  std::string_view ending;  ///< of its files, ".feb"
  ConvertedSolid (*convert)(const SolidToConvert& solid);
};

std::span<const ConversionFormat> conversion_formats();

/// @throws InputError for an unknown name, with the nearest one
const ConversionFormat& conversion_format(std::string_view name);

}  // namespace pliant
