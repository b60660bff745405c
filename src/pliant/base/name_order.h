#pragma once

#include <string_view>

namespace pliant {

/// Whether a name comes before another as people count: digits that follow each other are one
/// number, so that 2.png comes before 10.png.
bool comes_before(std::string_view one, std::string_view other);

}  // namespace pliant
