#include "pliant/math/block_matrix.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/assert.h"

#include "math/block_matrices.h"

namespace pliant {
namespace {

using test::cloth_matrix;
using test::dense;
using test::random_block;
using test::random_vector;

std::vector<int> columns_of(const BlockPattern& pattern, int row) {
  std::vector<int> columns;
  for (int k = pattern.row_begin(row); k < pattern.row_end(row); ++k) {
    columns.push_back(pattern.column(k));
  }
  return columns;
}

TEST(BlockPattern, ListsTheUpperTriangleWithTheDiagonalFirst) {
  const BlockPattern pattern(4, {{3, 1}, {0, 1}, {1, 0}, {1, 3}, {1, 2}});
  EXPECT_EQ(pattern.size(), 4);
  EXPECT_EQ(pattern.block_count(), 7);  // four of the diagonal, three couplings
  EXPECT_EQ(columns_of(pattern, 0), (std::vector<int>{0, 1}));
  EXPECT_EQ(columns_of(pattern, 1), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(columns_of(pattern, 2), (std::vector<int>{2}));
  EXPECT_EQ(columns_of(pattern, 3), (std::vector<int>{3}));
}

TEST(BlockPattern, FindsEachOfItsBlocks) {
  const BlockPattern pattern(12, test::grid_couplings(4, 3));
  for (int i = 0; i < pattern.size(); ++i) {
    EXPECT_EQ(pattern.find(i, i), pattern.diagonal(i));
    for (int k = pattern.row_begin(i); k < pattern.row_end(i); ++k) {
      EXPECT_EQ(pattern.find(i, pattern.column(k)), k);
    }
  }
}

TEST(BlockPattern, RefusesABlockThatItDoesNotHave) {
  const BlockPattern pattern(3, {{0, 1}});
  EXPECT_THROW(pattern.find(0, 2), AssertionError);
  EXPECT_THROW(pattern.find(1, 0), AssertionError);  // below the diagonal
}

TEST(BlockPattern, RefusesCouplingsOutsideTheMatrix) {
  EXPECT_THROW(BlockPattern(3, {{0, 3}}), AssertionError);
  EXPECT_THROW(BlockPattern(3, {{-1, 2}}), AssertionError);
  EXPECT_THROW(BlockPattern(3, {{1, 1}}), AssertionError);
}

TEST(BlockMatrix, IsZeroAtFirstAndAfterSetZero) {
  RandomStream random(1);
  BlockMatrix matrix = cloth_matrix(random, 3, 3, 1, 1);
  EXPECT_GT(dense(matrix).norm(), 0);
  matrix.set_zero();
  EXPECT_EQ(dense(matrix).norm(), 0);
  EXPECT_EQ(
      dense(BlockMatrix(std::make_shared<BlockPattern>(2, test::grid_couplings(2, 1)))).norm(), 0);
}

TEST(BlockMatrix, AddsABlockInEitherOrder) {
  RandomStream random(2);
  const auto pattern = std::make_shared<BlockPattern>(5, test::grid_couplings(5, 1));
  BlockMatrix matrix(pattern);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(15, 15);
  for (const auto& [i, j] : {std::pair{1, 2}, {2, 1}, {4, 3}, {0, 1}, {2, 1}}) {
    const Eigen::Matrix3d block = random_block(random);
    matrix.add(i, j, block);
    expected.block<3, 3>(3 * i, 3 * j) += block;
    expected.block<3, 3>(3 * j, 3 * i) += block.transpose();
  }
  const Eigen::Matrix3d any = random_block(random);
  matrix.add(3, 3, any + any.transpose());
  expected.block<3, 3>(9, 9) += any + any.transpose();
  matrix.add_to_diagonal(0, 2.5);
  expected.block<3, 3>(0, 0) += 2.5 * Eigen::Matrix3d::Identity();
  EXPECT_TRUE(dense(matrix).isApprox(expected, 1e-15));
}

TEST(BlockMatrix, RefusesToAddWhereItsPatternHasNoBlock) {
  BlockMatrix matrix(std::make_shared<BlockPattern>(4, test::grid_couplings(4, 1)));
  EXPECT_THROW(matrix.add(0, 2, Eigen::Matrix3d::Identity()), AssertionError);
}

TEST(BlockMatrix, MultipliesLikeTheDenseMatrix) {
  RandomStream random(3);
  for (const int nodes : {1, 2, 5}) {
    const BlockMatrix matrix = cloth_matrix(random, nodes, 4, 10, 1);
    const Eigen::VectorXd x = random_vector(random, 12 * nodes);
    EXPECT_TRUE((matrix * x).isApprox(dense(matrix) * x, 1e-14));
  }
}

TEST(BlockMatrix, GivesItsLowerTriangleEntryByEntry) {
  RandomStream random(4);
  const BlockMatrix matrix = cloth_matrix(random, 4, 3, 10, 1);
  const Eigen::SparseMatrix<double> lower = matrix.lower_triangle();
  const Eigen::MatrixXd expected = dense(matrix).triangularView<Eigen::Lower>();
  EXPECT_EQ(Eigen::MatrixXd(lower), expected);
  // Every entry of the blocks has its place, those that happen to vanish too.
  const BlockPattern& pattern = matrix.pattern();
  EXPECT_EQ(lower.nonZeros(), 9 * pattern.block_count() - 3 * pattern.size());
}

TEST(BlockMatrix, OverwritesTheValuesOfALowerTriangle) {
  RandomStream random(5);
  BlockMatrix matrix = cloth_matrix(random, 4, 3, 10, 1);
  Eigen::SparseMatrix<double> lower = matrix.lower_triangle();
  matrix.set_zero();
  matrix.copy_to(lower);
  EXPECT_EQ(lower.nonZeros(), matrix.lower_triangle().nonZeros());
  EXPECT_EQ(lower.norm(), 0);
  for (int k = 0; k < matrix.pattern().block_count(); ++k) matrix.block(k) = random_block(random);
  matrix.copy_to(lower);
  EXPECT_EQ(Eigen::MatrixXd(lower), Eigen::MatrixXd(matrix.lower_triangle()));
}

// What is kept in single precision changes a product by its rounding, 6e-8 of each entry.
TEST(BlockMatrix, MultipliesInSinglePrecisionAsInFull) {
  RandomStream random(6);
  const BlockMatrix full = cloth_matrix(random, 5, 4, 10, 1);
  const BlockPattern& pattern = full.pattern();
  BlockMatrix single(std::make_shared<BlockPattern>(pattern), Precision::single);
  for (int i = 0; i < pattern.size(); ++i) {
    for (int k = pattern.row_begin(i); k < pattern.row_end(i); ++k) {
      single.add(pattern.column(k), i, full.block(k).transpose());
    }
    EXPECT_TRUE(single.diagonal(i).isApprox(full.diagonal(i),
                                            1e-15));  // springs are symmetric but for rounding
  }
  EXPECT_TRUE(single.all_finite());
  const Eigen::VectorXd x = random_vector(random, 3 * pattern.size());
  const Eigen::VectorXd expected = dense(full) * x;
  EXPECT_LT((full * x - expected).norm(), 1e-14 * expected.norm());
  EXPECT_LT((single * x - expected).norm(), 1e-7 * expected.norm());
  single.set_zero();
  EXPECT_EQ((single * x).norm(), 0);
}

// A translation of the first rows then meets what was on the diagonal before, and no more.
TEST(BlockMatrix, CompletesItsDiagonalsFromDifferences) {
  RandomStream random(7);
  for (const Precision precision : {Precision::full, Precision::single}) {
    constexpr int kRows = 12, kFirst = 9;
    BlockMatrix matrix(std::make_shared<BlockPattern>(kRows, test::grid_couplings(4, 3)),
                       precision);
    for (const auto& [i, j] : test::grid_couplings(4, 3)) {
      if (std::max(i, j) < kFirst) matrix.add(i, j, random_block(random));
    }
    for (int i = 0; i < kRows; ++i) matrix.add_to_diagonal(i, 2);
    matrix.complete_diagonals(kFirst);
    const Eigen::VectorXd moved = Eigen::Vector3d(1, -2, 3).replicate(kRows, 1);
    EXPECT_LT((matrix * moved - 2 * moved).norm(), 1e-13 * moved.norm());
  }
}

TEST(BlockMatrix, MayHaveNoRows) {
  const BlockMatrix matrix(std::make_shared<BlockPattern>(0, std::vector<std::pair<int, int>>{}));
  EXPECT_EQ((matrix * Eigen::VectorXd()).size(), 0);
  EXPECT_EQ(matrix.lower_triangle().rows(), 0);
}

}  // namespace
}  // namespace pliant
