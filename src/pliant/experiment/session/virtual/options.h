#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "pliant/base/quantity.h"

namespace pliant {

/// A test of virtual sessions ([T] 3.2.2).
struct SessionTestKind {
  std::string_view test;
  std::string_view amplitude;  ///< key of how far it goes
  Dimension dimension;         ///< of the amplitude
  double usual_amplitude;
  double clip_mass;  ///< usual one, kg ([T] Table 3.1); 0: without clips
  int legs;          ///< ways between turning points in a cycle; 0: one way
};

std::span<const SessionTestKind> session_test_kinds();

/// @param test  the name of one of them
const SessionTestKind& session_test_kind(std::string_view test);

/// Standard deviations of what sees a session, and the hysteresis of its cords ([T] 3.2.3).
struct SessionNoise {
  double position = 0;       ///< of each coordinate of vertices and attachments (m)
  double force = 0;          ///< of each cord's pull (N)
  double cord_friction = 0;  ///< width of the loop between pulling and giving way (N)
};

/// What is done to a sheet, and how it is seen.
struct VirtualSession {
  std::string test = "stretch-weft";
  int frames = 50;
  int cycles = 1;                    ///< there and back
  double width = 0.1, height = 0.1;  ///< along weft and warp; bias-extension: across and along
                                     ///< the strip, which lies at 45 degrees to the yarns (m)
  double amplitude = 0;              ///< as the test's kind says
  double initial_strain = 0.002;     ///< that keeps a sheet between clips up
  double grip = 5e-3;                ///< depth of the cloth in a clip (m)
  double clip_mass = 0;              ///< kg
  double edge = 2.5e-3;              ///< mean edge of an irregular mesh (m)
  std::optional<std::pair<int, int>> nodes;  ///< of a regular grid, instead
  SessionNoise noise;
};

/// A test as it is done where nothing else is said.
VirtualSession usual_session(std::string_view test);

}  // namespace pliant
