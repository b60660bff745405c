#include "pliant/contact/box_tree.h"

#include <algorithm>
#include <numeric>

namespace pliant {

BoxTree::BoxTree(const Eigen::Matrix3Xd& middles) {
  std::vector<int> all(static_cast<size_t>(middles.cols()));
  std::iota(all.begin(), all.end(), 0);
  nodes_.reserve(2 * all.size());
  build(all, 0, all.size(), middles);
}

// Halves a range at the median along the axis in which it is widest.
int BoxTree::build(std::vector<int>& things, size_t begin, size_t end,
                   const Eigen::Matrix3Xd& middles) {
  const int number = static_cast<int>(nodes_.size());
  nodes_.push_back({-1, things[begin]});
  if (end - begin == 1) return number;
  Eigen::Array3d low = middles.col(things[begin]), high = low;
  for (size_t i = begin; i < end; ++i) {
    low = low.min(middles.col(things[i]).array());
    high = high.max(middles.col(things[i]).array());
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const size_t half = begin + (end - begin) / 2;
  const auto at = [&](size_t i) { return things.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(half), at(end), [&](int a, int b) {
    const double x = middles(axis, a), y = middles(axis, b);
    return x < y || (x == y && a < b);
  });
  const int first = build(things, begin, half, middles);
  const int second = build(things, half, end, middles);
  nodes_[static_cast<size_t>(number)] = {first, second};
  return number;
}

BoxTree::Fitted BoxTree::fitted(const std::vector<SweptBox>& boxes) const {
  std::vector<SweptBox> spans(nodes_.size());
  for (size_t n = nodes_.size(); n-- > 0;) {
    const Node& node = nodes_[n];
    if (node.is_leaf()) {
      spans[n] = boxes[static_cast<size_t>(node.second)];
    } else {
      spans[n] = spans[static_cast<size_t>(node.first)];
      spans[n].include(spans[static_cast<size_t>(node.second)]);
    }
  }
  return {nodes_, std::move(spans)};
}

}  // namespace pliant
