#pragma once

#include "pliant/measurement/session.h"

namespace pliant {

/// The test whose sample is a strip that was cut at 45 degrees to the yarns.
inline constexpr const char* kBiasExtension = "bias-extension";

/// A session of such a strip, whose rest plane has weft and warp for axes in place of the
/// directions across and along it. Its length halves the angle between them.
Session in_yarn_axes(Session strip);

}  // namespace pliant
