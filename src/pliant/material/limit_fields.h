#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "pliant/io/fields.h"
#include "pliant/material/material.h"

namespace pliant {

/// Reads the list `limits` of a material.
/// @param material  with its kind and its components
/// @throws InputError for a limit that is not above 0, which no material at rest could keep, for
///         components that are not there, or are in two limits
std::vector<EnergyLimit> read_limits(const Value& list, const Material& material);

/// The same list, written.
nlohmann::ordered_json limits_json(const std::vector<EnergyLimit>& limits);

/// What is known of the error of a number, as material files hold it.
NumberError read_number_error(const Value& node);
nlohmann::ordered_json number_error_json(const NumberError& error);

/// The components that a limit is about: known ones, each once, in the order of their kind.
/// @param taken  components of other limits; gets the new ones
/// @throws InputError
std::vector<std::string> read_limited_components(const Value& of, MaterialKind kind,
                                                 std::vector<std::string>& taken);

}  // namespace pliant
