#include "pliant/measurement/session/sample_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/nearest_name.h"
#include "pliant/base/number_text.h"
#include "pliant/base/plausibility.h"
#include "pliant/measurement/session/balance.h"

namespace pliant {
namespace {

constexpr double kLeastGravity = 9.7, kMostGravity = 9.9;  // m/s^2, at sea level and above
constexpr std::array<std::string_view, 8> kTests{"stretch-weft",  "stretch-warp",  "shear",
                                                 "bend-weft",     "bend-warp",     "corner-pull",
                                                 "complex-shear", "bias-extension"};

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

std::vector<std::string> sample_questions(const Session& session) {
  const SessionSample& sample = session.sample;
  Plausibility sheet;
  const auto width = sheet.field("width", Dimension::length, sample.width);
  const auto height = sheet.field("height", Dimension::length, sample.height);
  // The mesh is as large as the sample, else the session is refused: one slip for both.
  const auto positions =
      sheet.column("rest` and its frames, `width` and `height", Dimension::length, "m");
  sheet.add(figures::kSide, sample.width, {{width}, {positions}});
  sheet.add(figures::kSide, sample.height, {{height}, {positions}});
  if (sample.density) {
    sheet.add(figures::kAreaDensity, *sample.density,
              {{sheet.field("density", Dimension::area_density, *sample.density)}});
  } else if (sample.mass) {
    sheet.add(figures::kAreaDensity, area_density(session),
              {{sheet.field("mass", Dimension::mass, *sample.mass)}, {positions, -2}});
  }
  if (const auto carried = carried_share(session)) {
    sheet.add(figures::kCarried, *carried,
              {{sheet.column("fx`, `fy`, `fz", Dimension::force, "N")}});
  }
  const auto question = sheet.question();
  return question ? std::vector{*question} : std::vector<std::string>();
}

std::vector<std::string> sample_warnings(const Session& session) {
  std::vector<std::string> warnings;
  warn_of_gravity(session, warnings);
  warn_of_name(session, warnings);
  if (session.clips.empty() && !session.table) {
    warnings.emplace_back("nothing holds the sheet (expected: `clips` or a `table`)");
  }
  return warnings;
}

}  // namespace pliant
