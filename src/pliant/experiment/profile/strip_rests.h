#pragma once

#include <optional>
#include <vector>

#include "pliant/experiment/profile/hanging_strip.h"
#include "pliant/measurement/profile_rows.h"

namespace pliant {

/// The shapes that a strip which was rolled and let go may rest in: that which a quiet release ends
/// in; that which it comes to where no point turns back on its way, as when it is let go faster;
/// and those in which it stays when it is bent on from the first, by up to `kPushedBy`.
///
/// The others are looked for when they are asked for: a release is followed for each prediction of
/// a fit, and most strips have no other. Where the law snaps, a strip has as many as it has points,
/// and without friction it has one: only the first is told.
class StripRests {
 public:
  /// @param hanging  after the quiet release
  /// @param law      outlives this
  /// @param rolled   curvature of the cylinder (1/m)
  StripRests(HangingStrip hanging, const ComponentLaw& law, double rolled, double weight);

  /// The others, at least half a percent of the length away.
  const std::vector<HangingStrip>& others();

  /// The rest whose profile is nearest to a measured one, in the sense of least squares: 0 is the
  /// end of the release, also where that is as near as matters; 1 and on are the others.
  std::size_t nearest(const ProfileRows& measured);

  /// @param with_derivatives  as those of the release, which must have them
  StripProfile profile(std::size_t rest, bool with_derivatives);

 private:
  double length() const { return hanging_.line.line().length(); }
  double distance(const ProfileRows& measured, std::size_t rest);
  void add(HangingStrip other);
  void add_let_go_faster();
  void add_pushed();

  HangingStrip hanging_;
  const ComponentLaw& law_;
  double rolled_, weight_;
  std::optional<std::vector<HangingStrip>> others_;
};

}  // namespace pliant
