#pragma once

#include <string>
#include <string_view>

#include "pliant/io/document.h"

namespace pliant {

/// Stands in a study that was written for someone where they alone know what belongs there.
inline constexpr std::string_view kBlank = "???";

/// What belongs in a field of a study, in words: of `width` "the width of the strip, e.g. 50 mm".
std::string blank_hint(std::string_view field);

/// @throws InputError that names every field that is left blank, with its line and what belongs
///         there
void refuse_blanks(const Document& document);

}  // namespace pliant
