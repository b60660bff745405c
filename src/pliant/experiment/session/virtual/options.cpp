#include "pliant/experiment/session/virtual/options.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSmallClip = 1.9e-3, kBar = 10.1e-3, kLongBar = 13.3e-3;  // kg

constexpr std::array<SessionTestKind, 8> kKinds{{
    {"stretch-weft", "strain", Dimension::fraction, 0.05, kBar, 2},
    {"stretch-warp", "strain", Dimension::fraction, 0.05, kBar, 2},
    {"shear", "angle", Dimension::angle, 15 * kDegree, kLongBar, 2},
    {"bend-weft", "overhang", Dimension::length, 0.06, 0, 0},
    {"bend-warp", "overhang", Dimension::length, 0.06, 0, 0},
    {"corner-pull", "strain", Dimension::fraction, 0.05, kSmallClip, 4},
    {"complex-shear", "displacement", Dimension::length, 0.01, kBar, 2},
    {"bias-extension", "strain", Dimension::fraction, 0.1, kBar, 2},
}};

}  // namespace

std::span<const SessionTestKind> session_test_kinds() { return kKinds; }

const SessionTestKind& session_test_kind(std::string_view test) {
  const auto* found = std::ranges::find(kKinds, test, &SessionTestKind::test);
  PLIANT_ASSERT(found != kKinds.end(), "a virtual session has a known test");
  return *found;
}

VirtualSession usual_session(std::string_view test) {
  const SessionTestKind& kind = session_test_kind(test);
  VirtualSession session;
  session.test = test;
  session.amplitude = kind.usual_amplitude;
  session.clip_mass = kind.clip_mass;
  if (test == "bias-extension") {
    session.width = 0.05;
    session.height = 0.15;
  }
  return session;
}

}  // namespace pliant
