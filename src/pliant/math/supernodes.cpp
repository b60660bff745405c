#include "pliant/math/supernodes.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace pliant {
namespace {

/// Zeros that a panel may have for being merged with its parent's, as a part of its entries, and
/// block columns up to which it is merged anyway where it has no more than half.
constexpr double kZeros = 0.05, kZerosOfSmall = 0.5;
constexpr int kSmall = 8;

using Rows = std::vector<int>;

std::vector<int> minimum_degree(const BlockPattern& pattern) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < pattern.size(); ++i) {
    for (int k = pattern.row_begin(i); k < pattern.row_end(i); ++k) {
      entries.emplace_back(pattern.column(k), i, 1);
    }
  }
  Eigen::SparseMatrix<double> lower(pattern.size(), pattern.size());
  lower.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), order);
  std::vector<int> place(static_cast<std::size_t>(pattern.size()));
  for (int k = 0; k < pattern.size(); ++k) {
    place[static_cast<std::size_t>(order.indices()(k))] = k;
  }
  return place;
}

/// Rows of the factor below the diagonal, column by column: those of the matrix and those of the
/// columns whose first row this is.
std::vector<Rows> factor_rows(const BlockPattern& pattern, const std::vector<int>& place) {
  const auto count = static_cast<std::size_t>(pattern.size());
  std::vector<Rows> rows(count);
  for (int i = 0; i < pattern.size(); ++i) {
    const int p = place[static_cast<std::size_t>(i)];
    for (int k = pattern.row_begin(i) + 1; k < pattern.row_end(i); ++k) {
      const int q = place[static_cast<std::size_t>(pattern.column(k))];
      rows[static_cast<std::size_t>(std::min(p, q))].push_back(std::max(p, q));
    }
  }
  std::vector<Rows> children(count);
  for (std::size_t j = 0; j < count; ++j) {
    std::ranges::sort(rows[j]);
    for (const int child : children[j]) {
      const Rows& below = rows[static_cast<std::size_t>(child)];
      Rows both;
      std::set_union(rows[j].begin(), rows[j].end(), below.begin() + 1, below.end(),
                     std::back_inserter(both));
      rows[j] = std::move(both);
    }
    if (!rows[j].empty()) {
      children[static_cast<std::size_t>(rows[j].front())].push_back(static_cast<int>(j));
    }
  }
  return rows;
}

/// Where each column comes when every column follows its children, all of one branch together.
std::vector<int> postorder(const std::vector<Rows>& rows) {
  const auto count = rows.size();
  std::vector<int> descendants(count, 1), place(count), next(count + 1, 0);
  for (std::size_t j = 0; j < count; ++j) {
    if (!rows[j].empty()) descendants[static_cast<std::size_t>(rows[j].front())] += descendants[j];
  }
  // From the roots down: each branch takes the places that its parent, or the forest, has left.
  int roots = 0;
  for (std::size_t j = count; j-- > 0;) {
    int& free = rows[j].empty() ? roots : next[static_cast<std::size_t>(rows[j].front())];
    place[j] = free + descendants[j] - 1;
    next[j] = free;
    free += descendants[j];
  }
  return place;
}

double entries(double columns, double size) { return columns * (size - columns / 2); }

/// Whether one panel of a supernode and its last child costs little more than two.
bool are_alike(const Supernode& child, const Supernode& parent) {
  const int columns = child.columns + parent.columns;
  const int size = child.columns + parent.size();
  const double together = entries(columns, size);
  const double zeros =
      together - entries(child.columns, child.size()) - entries(parent.columns, parent.size());
  return zeros <= (columns <= kSmall ? kZerosOfSmall : kZeros) * together;
}

std::vector<Supernode> merged(const std::vector<Rows>& rows) {
  std::vector<Supernode> nodes;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    Supernode node{static_cast<int>(j), 1, rows[j], -1};
    while (!nodes.empty() && !nodes.back().rows.empty() &&
           nodes.back().rows.front() < node.first + node.columns && are_alike(nodes.back(), node)) {
      node.first = nodes.back().first;
      node.columns += nodes.back().columns;
      nodes.pop_back();
    }
    nodes.push_back(std::move(node));
  }
  std::vector<int> node_of(rows.size());
  for (std::size_t s = 0; s < nodes.size(); ++s) {
    std::fill_n(node_of.begin() + nodes[s].first, nodes[s].columns, static_cast<int>(s));
  }
  for (Supernode& node : nodes) {
    if (!node.rows.empty()) node.parent = node_of[static_cast<std::size_t>(node.rows.front())];
  }
  return nodes;
}

}  // namespace

SymbolicFactor::SymbolicFactor(const BlockPattern& pattern) : place(minimum_degree(pattern)) {
  const std::vector<int> after = postorder(factor_rows(pattern, place));
  for (int& p : place) p = after[static_cast<std::size_t>(p)];
  supernodes = merged(factor_rows(pattern, place));
}

}  // namespace pliant
