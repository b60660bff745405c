#pragma once

#include <string_view>
#include <vector>

namespace pliant {

/// How a specimen comes to hang: with internal friction it keeps something of the way.
enum class DrapeHistory {
  lowered,  ///< a platform under the overhang goes down slowly: the test's own way, from flat
  shaken,  ///< then its weight swings about what it is, less and less: friction is worked out of it
  pulled,  ///< then it weighs twice as much, and slowly no more: it comes up, not down
};

/// All of them, in this order.
const std::vector<DrapeHistory>& drape_histories();
/// As documents write it.
std::string_view name_of(DrapeHistory history);

/// Diameter from which on a specimen hangs over its disc enough for a test.
/// @param disc  its diameter (m)
constexpr double least_specimen(double disc) { return 1.1 * disc; }

/// A round specimen on a disc, and how it is computed.
struct DrapeSetup {
  double specimen = 0.3;  ///< diameter (m); 0.24, 0.3 or 0.36 by ISO 9073-9
  double disc = 0.18;     ///< diameter of the discs that hold its middle (m)
  DrapeHistory history = DrapeHistory::lowered;
  double edge = 0.008;  ///< mean edge of the mesh (m)

  double overhang() const { return (specimen - disc) / 2; }
};

}  // namespace pliant
