#pragma once

#include <string>

#include "pliant/base/number_text.h"

namespace pliant {

/// A length in m as messages about contact tell it: "0.25 mm".
inline std::string millimetres(double length) { return format_number(1e3 * length, 3) + " mm"; }

}  // namespace pliant
