#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "pliant/base/random.h"
#include "pliant/math/block_matrix.h"

namespace pliant::test {

/// The couplings of a grid of nodes with both diagonals, as those of a cloth.
inline std::vector<std::pair<int, int>> grid_couplings(int nodes_u, int nodes_v) {
  std::vector<std::pair<int, int>> couplings;
  for (int j = 0; j < nodes_v; ++j) {
    for (int i = 0; i < nodes_u; ++i) {
      const int node = j * nodes_u + i;
      if (i + 1 < nodes_u) couplings.emplace_back(node, node + 1);
      if (j + 1 < nodes_v) couplings.emplace_back(node, node + nodes_u);
      if (i + 1 < nodes_u && j + 1 < nodes_v) couplings.emplace_back(node, node + nodes_u + 1);
      if (i > 0 && j + 1 < nodes_v) couplings.emplace_back(node, node + nodes_u - 1);
    }
  }
  return couplings;
}

inline Eigen::Matrix3d random_block(RandomStream& random) {
  Eigen::Matrix3d block;
  for (double& x : block.reshaped()) x = random.normal();
  return block;
}

/// A positive definite matrix as a cloth in motion has it: springs of random directions with
/// stiffness up to `stiffness` between the nodes of a grid, and `mass` on the diagonal.
inline BlockMatrix cloth_matrix(RandomStream& random, int nodes_u, int nodes_v, double stiffness,
                                double mass) {
  const auto couplings = grid_couplings(nodes_u, nodes_v);
  BlockMatrix matrix(std::make_shared<BlockPattern>(nodes_u * nodes_v, couplings));
  for (const auto& [i, j] : couplings) {
    const Eigen::Vector3d along = random_block(random).col(0).normalized();
    const Eigen::Matrix3d spring = random.uniform(0, stiffness) * along * along.transpose();
    matrix.add(i, i, spring);
    matrix.add(j, j, spring);
    matrix.add(i, j, -spring);
  }
  for (int i = 0; i < nodes_u * nodes_v; ++i) matrix.add_to_diagonal(i, mass);
  return matrix;
}

/// Adds products that couple rows far from each other.
inline void add_outer_products(RandomStream& random, int count, BlockMatrix& matrix) {
  const int rows = matrix.pattern().size();
  for (int p = 0; p < count; ++p) {
    std::vector<RowVector> u;
    for (int k = 0; k < 4; ++k) {
      u.push_back({(p + k * (rows / 4)) % rows, random_block(random).col(0)});
    }
    matrix.add_outer_product(random.uniform(0, 100), u);
  }
}

/// All entries, read block by block, with those of products beside the pattern.
inline Eigen::MatrixXd dense(const BlockMatrix& matrix) {
  const BlockPattern& pattern = matrix.pattern();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3 * pattern.size(), 3 * pattern.size());
  for (int i = 0; i < pattern.size(); ++i) {
    for (int k = pattern.row_begin(i); k < pattern.row_end(i); ++k) {
      const int j = pattern.column(k);
      result.block<3, 3>(3 * i, 3 * j) = matrix.block(k);
      result.block<3, 3>(3 * j, 3 * i) = matrix.block(k).transpose();
    }
  }
  for (int p = 0; p < matrix.outer_products(); ++p) {
    for (const auto& [i, u] : matrix.vector(p)) {
      for (const auto& [j, v] : matrix.vector(p)) {
        if (i == j) continue;
        result.block<3, 3>(3 * i, 3 * j) += matrix.factor(p) * u * v.transpose();
      }
    }
  }
  return result;
}

inline Eigen::VectorXd random_vector(RandomStream& random, Eigen::Index size) {
  Eigen::VectorXd v(size);
  for (double& x : v) x = random.normal();
  return v;
}

}  // namespace pliant::test
