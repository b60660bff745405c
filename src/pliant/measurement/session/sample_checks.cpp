#include "pliant/measurement/session/sample_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/nearest_name.h"
#include "pliant/base/number_text.h"
#include "pliant/measurement/session/balance.h"

namespace pliant {
namespace {

constexpr double kShortestSide = 5e-3, kLongestSide = 5;   // m
constexpr double kLightest = 2e-3, kHeaviest = 5;          // kg/m^2
constexpr double kLeastGravity = 9.7, kMostGravity = 9.9;  // m/s^2, at sea level and above
constexpr std::array<std::string_view, 8> kTests{"stretch-weft",  "stretch-warp",  "shear",
                                                 "bend-weft",     "bend-warp",     "corner-pull",
                                                 "complex-shear", "bias-extension"};

void warn_of_size(const Session& session, std::vector<std::string>& warnings) {
  const auto [shorter, longer] = std::minmax(session.sample.width, session.sample.height);
  if (shorter >= kShortestSide && longer <= kLongestSide) return;
  warnings.push_back(fmt::format(
      "the sample measures {} x {}: are its lengths in metres? (expected: sides from {} to {})",
      format_quantity(session.sample.width, Dimension::length),
      format_quantity(session.sample.height, Dimension::length),
      format_quantity(kShortestSide, Dimension::length),
      format_quantity(kLongestSide, Dimension::length)));
}

void warn_of_density(const Session& session, std::vector<std::string>& warnings) {
  const double density = area_density(session);
  if (density >= kLightest && density <= kHeaviest) return;
  warnings.push_back(
      fmt::format("the sheet weighs {} kg/m^2: is its mass right? (expected: {} to {} kg/m^2)",
                  format_number(density, 4), kLightest, kHeaviest));
}

void warn_of_gravity(const Session& session, std::vector<std::string>& warnings) {
  const double size = session.gravity.norm();
  if (size == 0 || (size >= kLeastGravity && size <= kMostGravity)) return;
  warnings.push_back(fmt::format("gravity is {} m/s^2 (expected: {} to {}, or 0 without weights)",
                                 format_number(size, 4), kLeastGravity, kMostGravity));
}

void warn_of_name(const Session& session, std::vector<std::string>& warnings) {
  if (std::ranges::find(kTests, session.test) != kTests.end()) return;
  const std::string nearest = nearest_name(session.test, kTests);
  if (nearest.empty()) return;
  warnings.push_back(
      fmt::format("the test {} is a name of its own, which tells nothing of what is measured: "
                  "did you mean {}?",
                  quoted_value(session.test), quoted_value(nearest)));
}

}  // namespace

std::vector<std::string> sample_warnings(const Session& session) {
  std::vector<std::string> warnings;
  warn_of_size(session, warnings);
  warn_of_density(session, warnings);
  warn_of_gravity(session, warnings);
  warn_of_name(session, warnings);
  if (session.clips.empty() && !session.table) {
    warnings.emplace_back("nothing holds the sheet (expected: `clips` or a `table`)");
  }
  return warnings;
}

}  // namespace pliant
