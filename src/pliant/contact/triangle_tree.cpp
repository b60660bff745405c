#include "pliant/contact/triangle_tree.h"

#include <algorithm>
#include <numeric>

namespace pliant {

TriangleTree::TriangleTree(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles)
    : triangles_(triangles) {
  Eigen::Matrix3Xd middles(3, triangles.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    middles.col(t) = positions(Eigen::all, triangles.col(t)).rowwise().mean();
  }
  std::vector<int> all(static_cast<size_t>(triangles.cols()));
  std::iota(all.begin(), all.end(), 0);
  nodes_.reserve(2 * all.size());
  build(all, 0, all.size(), middles);
}

// Halves a range at the median along the axis in which it is widest.
int TriangleTree::build(std::vector<int>& triangles, size_t begin, size_t end,
                        const Eigen::Matrix3Xd& middles) {
  const int number = static_cast<int>(nodes_.size());
  nodes_.push_back({-1, triangles[begin]});
  if (end - begin == 1) return number;
  Eigen::Array3d low = middles.col(triangles[begin]), high = low;
  for (size_t i = begin; i < end; ++i) {
    low = low.min(middles.col(triangles[i]).array());
    high = high.max(middles.col(triangles[i]).array());
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const size_t half = begin + (end - begin) / 2;
  const auto at = [&](size_t i) { return triangles.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(half), at(end), [&](int a, int b) {
    const double x = middles(axis, a), y = middles(axis, b);
    return x < y || (x == y && a < b);
  });
  const int first = build(triangles, begin, half, middles);
  const int second = build(triangles, half, end, middles);
  nodes_[static_cast<size_t>(number)] = {first, second};
  return number;
}

void TriangleTree::Span::include(const Span& other) {
  low = low.min(other.low);
  high = high.max(other.high);
  least_way = least_way.min(other.least_way);
  most_way = most_way.max(other.most_way);
}

std::vector<TriangleTree::Span> TriangleTree::fitted(const Eigen::Matrix3Xd& positions,
                                                     const Eigen::Matrix3Xd& ways) const {
  std::vector<Span> spans(nodes_.size());
  for (size_t n = nodes_.size(); n-- > 0;) {
    const Node& node = nodes_[n];
    if (!node.is_leaf()) {
      spans[n] = spans[static_cast<size_t>(node.first)];
      spans[n].include(spans[static_cast<size_t>(node.second)]);
      continue;
    }
    const auto corner = [&](int k) -> Span {
      const int point = triangles_(k, node.second);
      return {positions.col(point), positions.col(point), ways.col(point), ways.col(point)};
    };
    spans[n] = corner(0);
    spans[n].include(corner(1));
    spans[n].include(corner(2));
  }
  return spans;
}

// One seen from the other goes a way between the differences of theirs.
bool TriangleTree::may_meet(const Span& one, const Span& other, double reach) {
  const Eigen::Array3d back = (one.least_way - other.most_way).min(0.0) - reach;
  const Eigen::Array3d forth = (one.most_way - other.least_way).max(0.0) + reach;
  return (one.low + back <= other.high).all() && (one.high + forth >= other.low).all();
}

void TriangleTree::pairs(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xd& ways,
                         double reach, const std::function<void(int, int)>& visit) const {
  const std::vector<Span> spans = fitted(positions, ways);
  std::vector<std::pair<int, int>> left{{0, 0}};
  while (!left.empty()) {
    const auto [a, b] = left.back();
    left.pop_back();
    const Node &one = nodes_[static_cast<size_t>(a)], &other = nodes_[static_cast<size_t>(b)];
    if (a == b) {
      if (one.is_leaf()) continue;
      left.insert(left.end(),
                  {{one.first, one.first}, {one.second, one.second}, {one.first, one.second}});
      continue;
    }
    const Span &here = spans[static_cast<size_t>(a)], &there = spans[static_cast<size_t>(b)];
    if (!may_meet(here, there, reach)) continue;
    if (one.is_leaf() && other.is_leaf()) {
      visit(std::min(one.second, other.second), std::max(one.second, other.second));
    } else if (other.is_leaf() || (!one.is_leaf() && here.volume() >= there.volume())) {
      left.insert(left.end(), {{one.first, b}, {one.second, b}});
    } else {
      left.insert(left.end(), {{a, other.first}, {a, other.second}});
    }
  }
}

}  // namespace pliant
