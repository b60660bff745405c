#pragma once

#include <utility>
#include <vector>

#include "pliant/contact/swept_box.h"

namespace pliant {

/// Things in a hierarchy of their boxes, made once and fitted to where they are.
class BoxTree {
 public:
  /// @param middles  of the things: those that are near each other come into one branch (m, one
  ///                 column a thing, at least one)
  explicit BoxTree(const Eigen::Matrix3Xd& middles);

  /// Calls `visit` with the numbers of each two different things whose boxes may meet, the smaller
  /// first, in a fixed order.
  /// @param boxes  of all things
  /// @param reach  of `SweptBox::may_meet` (m)
  template <class Visit>
  void pairs(const std::vector<SweptBox>& boxes, float reach, const Visit& visit) const;

 private:
  // Children follow their parent; a leaf has a thing in place of a second child.
  struct Node {
    int first = -1, second = 0;
    bool is_leaf() const { return first < 0; }
  };

  int build(std::vector<int>& things, size_t begin, size_t end, const Eigen::Matrix3Xd& middles);
  std::vector<SweptBox> fitted(const std::vector<SweptBox>& boxes) const;

  std::vector<Node> nodes_;
};

template <class Visit>
void BoxTree::pairs(const std::vector<SweptBox>& boxes, float reach, const Visit& visit) const {
  const std::vector<SweptBox> spans = fitted(boxes);
  std::vector<std::pair<int, int>> left{{0, 0}};
  while (!left.empty()) {
    const auto [a, b] = left.back();
    left.pop_back();
    const Node &one = nodes_[static_cast<size_t>(a)], &other = nodes_[static_cast<size_t>(b)];
    if (a == b) {
      if (one.is_leaf()) continue;
      left.emplace_back(one.first, one.first);
      left.emplace_back(one.second, one.second);
      left.emplace_back(one.first, one.second);
      continue;
    }
    const SweptBox &here = spans[static_cast<size_t>(a)], &there = spans[static_cast<size_t>(b)];
    if (!SweptBox::may_meet(here, there, reach)) continue;
    if (one.is_leaf() && other.is_leaf()) {
      visit(std::min(one.second, other.second), std::max(one.second, other.second));
    } else if (other.is_leaf() || (!one.is_leaf() && here.volume() >= there.volume())) {
      left.emplace_back(one.first, b);
      left.emplace_back(one.second, b);
    } else {
      left.emplace_back(a, other.first);
      left.emplace_back(a, other.second);
    }
  }
}

}  // namespace pliant
