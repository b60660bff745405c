#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "pliant/contact/contact_surface.h"
#include "pliant/mechanics/search_costs.h"

namespace pliant {

/// The pairs of a surface that are near, looked for again only where points have moved so far that
/// others may be. What it tells does not depend on what it was asked before, but for pairs further
/// apart than `reach`. May be asked by several threads, each with costs of its own.
class NearPairs {
 public:
  /// @param reach  of which pairs none is left out (m)
  /// @param skin   by how much further it looks: points may move by half of it (m)
  NearPairs(std::shared_ptr<const ContactSurface> surface, double reach, double skin)
      : surface_(std::move(surface)), reach_(reach), skin_(skin) {}

  const ContactSurface& surface() const { return *surface_; }

  using Pairs = std::shared_ptr<const std::vector<SurfacePair>>;

  /// All pairs nearer than the reach, sorted, and some others.
  Pairs at(const Eigen::Matrix3Xd& positions, SearchCosts* costs = nullptr) const;

  /// All pairs that come nearer than the reach on straight ways, sorted, and some others.
  Pairs between(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                SearchCosts* costs = nullptr) const;

  /// The same; null where ways are so long, and so unlike each other, that nearly everything may
  /// meet nearly everything. Never where none goes further than the skin beyond the mean of all.
  Pairs between_if_few(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                       SearchCosts* costs = nullptr) const;

 private:
  struct List {
    Eigen::Matrix3Xd positions;
    Pairs pairs;
  };

  bool serves(const List& list, const Eigen::Matrix3Xd& positions) const;
  std::shared_ptr<const List> last() const;
  std::shared_ptr<const List> keep(const Eigen::Matrix3Xd& positions,
                                   std::vector<SurfacePair> pairs) const;

  std::shared_ptr<const ContactSurface> surface_;
  double reach_, skin_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const List> list_;  // the last that was made
};

}  // namespace pliant
