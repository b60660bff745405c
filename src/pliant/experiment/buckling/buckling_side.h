#pragma once

#include <string_view>

namespace pliant {

/// Which way a strip buckles between clamps that come nearer: as gravity pulls, or against it.
enum class BucklingSide { down, up };

/// `down` or `up`.
constexpr std::string_view name_of(BucklingSide side) {
  return side == BucklingSide::up ? "up" : "down";
}

}  // namespace pliant
