#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "pliant/base/parallel.h"
#include "pliant/contact/swept_box.h"

namespace pliant {

/// Things in a hierarchy of their boxes, made once and fitted to where they are.
class BoxTree {
 public:
  /// @param middles  of the things: those that are near each other come into one branch (m, one
  ///                 column a thing, at least one)
  explicit BoxTree(const Eigen::Matrix3Xd& middles);

  /// Number of things.
  Eigen::Index size() const { return (std::ssize(nodes_) + 1) / 2; }

  /// Calls `visit` with the numbers of each two different things whose boxes may meet, the smaller
  /// first, until it returns false. Parts of the search, whose numbers it is told first, are made
  /// by several threads at once, each in a fixed order.
  /// @param boxes  of all things
  /// @param reach  of `SweptBox::may_meet` (m)
  template <class Visit>
  void pairs(const std::vector<SweptBox>& boxes, float reach, const Visit& visit) const;
  static constexpr int kParts = 32;  ///< of the search

  /// The same, in one go, for each thing with each of another tree, this tree's first.
  template <class Visit>
  void pairs_with(const BoxTree& other, const std::vector<SweptBox>& boxes,
                  const std::vector<SweptBox>& boxes_of_other, float reach,
                  const Visit& visit) const;

 private:
  // Children follow their parent; a leaf has a thing in place of a second child.
  struct Node {
    int first = -1, second = 0;
    bool is_leaf() const { return first < 0; }
  };

  // A tree fitted to where its things are.
  struct Fitted {
    const std::vector<Node>& nodes;
    std::vector<SweptBox> spans;
  };

  int build(std::vector<int>& things, size_t begin, size_t end, const Eigen::Matrix3Xd& middles);
  Fitted fitted(const std::vector<SweptBox>& boxes) const;
  template <class Visit>
  static bool meet(const Fitted& ours, int branch, const Fitted& theirs, int other_branch,
                   float reach, const Visit& visit);

  std::vector<Node> nodes_;
};

template <class Visit>
void BoxTree::pairs(const std::vector<SweptBox>& boxes, float reach, const Visit& visit) const {
  const Fitted all = fitted(boxes);
  parallel_for(kParts, [&](int part) {
    for (auto n = static_cast<size_t>(part); n < nodes_.size(); n += kParts) {
      const Node& node = nodes_[n];
      if (node.is_leaf()) continue;
      const bool goes_on = meet(all, node.first, all, node.second, reach, [&](int one, int other) {
        return visit(part, std::min(one, other), std::max(one, other));
      });
      if (!goes_on) return;
    }
  });
}

template <class Visit>
void BoxTree::pairs_with(const BoxTree& other, const std::vector<SweptBox>& boxes,
                         const std::vector<SweptBox>& boxes_of_other, float reach,
                         const Visit& visit) const {
  meet(fitted(boxes), 0, other.fitted(boxes_of_other), 0, reach, visit);
}

// The larger of two branches that may meet is opened.
// @return whether `visit` goes on
template <class Visit>
bool BoxTree::meet(const Fitted& ours, int branch, const Fitted& theirs, int other_branch,
                   float reach, const Visit& visit) {
  std::vector<std::pair<int, int>> left{{branch, other_branch}};
  while (!left.empty()) {
    const auto [a, b] = left.back();
    left.pop_back();
    const Node &one = ours.nodes[static_cast<size_t>(a)],
               &other = theirs.nodes[static_cast<size_t>(b)];
    const SweptBox &here = ours.spans[static_cast<size_t>(a)],
                   &there = theirs.spans[static_cast<size_t>(b)];
    if (!SweptBox::may_meet(here, there, reach)) continue;
    if (one.is_leaf() && other.is_leaf()) {
      if (!visit(one.second, other.second)) return false;
    } else if (other.is_leaf() || (!one.is_leaf() && here.volume() >= there.volume())) {
      left.emplace_back(one.first, b);
      left.emplace_back(one.second, b);
    } else {
      left.emplace_back(a, other.first);
      left.emplace_back(a, other.second);
    }
  }
  return true;
}

}  // namespace pliant
