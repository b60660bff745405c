#include "pliant/math/sparse_cholesky.h"

#include <initializer_list>
#include <limits>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "math/block_matrices.h"

namespace pliant {
namespace {

using test::cloth_matrix;
using test::dense;
using test::random_vector;

TEST(SparseCholesky, SolvesLikeADenseFactorisation) {
  RandomStream random(1);
  for (const int nodes : {1, 3, 7}) {
    const BlockMatrix matrix = cloth_matrix(random, nodes, 5, 100, 1);
    SparseCholesky solver(matrix);
    ASSERT_TRUE(solver.factorize(matrix));
    const Eigen::VectorXd b = random_vector(random, 15 * nodes);
    Eigen::VectorXd x;
    const LinearSummary summary = solver.solve(b, x);
    EXPECT_TRUE(summary.converged);
    EXPECT_EQ(summary.iterations, 0);
    // The condition number is about a thousand.
    EXPECT_TRUE(x.isApprox(dense(matrix).llt().solve(b), 1e-12));
  }
}

// Large enough for panels of many columns, and for branches of the elimination tree that meet
// again.
TEST(SparseCholesky, SolvesLargeGridsAndManyColumnsAtOnce) {
  RandomStream random(6);
  for (const int nodes : {12, 25}) {
    const BlockMatrix matrix = cloth_matrix(random, nodes, 25, 100, 1);
    SparseCholesky solver(matrix);
    ASSERT_TRUE(solver.factorize(matrix));
    Eigen::MatrixXd b(75 * nodes, 3);
    for (auto column : b.colwise()) column = random_vector(random, b.rows());
    const Eigen::MatrixXd x = solver.solve_all(b);
    // The condition number is about a thousand.
    EXPECT_TRUE((dense(matrix) * x).isApprox(b, 1e-11));
    Eigen::VectorXd alone;
    solver.solve(b.col(1), alone);
    EXPECT_TRUE(alone.isApprox(x.col(1), 1e-12));
  }
}

// Two cloths that do not touch, and a point that touches nothing: the elimination is a forest.
TEST(SparseCholesky, SolvesMatricesOfSeveralParts) {
  RandomStream random(7);
  std::vector<std::pair<int, int>> couplings;
  for (const auto& [i, j] : test::grid_couplings(3, 4)) {
    couplings.emplace_back(i, j);
    couplings.emplace_back(13 + i, 13 + j);
  }
  BlockMatrix matrix(std::make_shared<BlockPattern>(25, couplings));
  for (const auto& [i, j] : couplings) {
    const Eigen::Vector3d along = test::random_block(random).col(0);
    const Eigen::Matrix3d spring = along * along.transpose();
    matrix.add(i, i, spring);
    matrix.add(j, j, spring);
    matrix.add(i, j, -spring);
  }
  for (int i = 0; i < 25; ++i) matrix.add_to_diagonal(i, 1);
  SparseCholesky solver(matrix);
  ASSERT_TRUE(solver.factorize(matrix));
  const Eigen::VectorXd b = random_vector(random, 75);
  Eigen::VectorXd x;
  solver.solve(b, x);
  EXPECT_TRUE(x.isApprox(dense(matrix).llt().solve(b), 1e-12));
}

TEST(SparseCholesky, TakesNewValuesOfTheSamePattern) {
  RandomStream random(2);
  const BlockMatrix first = cloth_matrix(random, 5, 5, 100, 1);
  BlockMatrix second = first;
  for (int i = 0; i < 25; ++i) second.add_to_diagonal(i, random.uniform(0, 5));
  const Eigen::VectorXd b = random_vector(random, 75);
  SparseCholesky solver(first);
  Eigen::VectorXd x;
  for (const BlockMatrix* matrix :
       std::initializer_list<const BlockMatrix*>{&first, &second, &first}) {
    ASSERT_TRUE(solver.factorize(*matrix));
    solver.solve(b, x);
    EXPECT_TRUE(x.isApprox(dense(*matrix).llt().solve(b), 1e-12));
  }
}

TEST(SparseCholesky, KnowsValuesOnlyFromFactorize) {
  RandomStream random(3);
  BlockMatrix matrix = cloth_matrix(random, 3, 3, 10, 1);
  const Eigen::MatrixXd before = dense(matrix);
  const Eigen::VectorXd b = random_vector(random, 27);
  SparseCholesky solver(matrix);
  ASSERT_TRUE(solver.factorize(matrix));
  matrix.set_zero();
  Eigen::VectorXd x;
  solver.solve(b, x);
  EXPECT_TRUE(x.isApprox(before.llt().solve(b), 1e-12));
}

TEST(SparseCholesky, RefusesAMatrixThatIsNotPositiveDefinite) {
  RandomStream random(4);
  const BlockMatrix good = cloth_matrix(random, 4, 4, 10, 1);
  SparseCholesky solver(good);

  BlockMatrix zero = good;
  zero.set_zero();
  EXPECT_FALSE(solver.factorize(zero));

  BlockMatrix negative_diagonal = good;
  negative_diagonal.add_to_diagonal(7, -1000);
  EXPECT_FALSE(solver.factorize(negative_diagonal));

  // Positive diagonal blocks, and a saddle: two nodes that push each other apart.
  BlockMatrix saddle = good;
  saddle.add(4, 5, 1000 * Eigen::Matrix3d::Identity());
  EXPECT_FALSE(solver.factorize(saddle));

  BlockMatrix negative = good;
  for (int k = 0; k < negative.pattern().block_count(); ++k) negative.block(k) *= -1;
  EXPECT_FALSE(solver.factorize(negative));

  EXPECT_TRUE(solver.factorize(good));  // and is none the worse for it
}

TEST(SparseCholesky, RefusesWhatIsNotANumberWhereverItStands) {
  RandomStream random(5);
  const BlockMatrix good = cloth_matrix(random, 4, 4, 10, 1);
  SparseCholesky solver(good);
  for (int k = 0; k < good.pattern().block_count(); ++k) {
    BlockMatrix bad = good;
    bad.block(k)(0, 2) = bad.block(k)(2, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(solver.factorize(bad)) << "block " << k;
  }
}

TEST(SparseCholesky, SolvesNothingForNoUnknowns) {
  const BlockMatrix matrix(std::make_shared<BlockPattern>(0, std::vector<std::pair<int, int>>{}));
  SparseCholesky solver(matrix);
  EXPECT_TRUE(solver.factorize(matrix));
  Eigen::VectorXd x;
  EXPECT_TRUE(solver.solve(Eigen::VectorXd(), x).converged);
  EXPECT_EQ(x.size(), 0);
}

}  // namespace
}  // namespace pliant
