#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace pliant {

/// Which 3x3 blocks of a symmetric matrix may differ from zero. Row i lists its blocks (i, j) with
/// j >= i in the order of j, the diagonal block first; the blocks of all rows are numbered through.
class BlockPattern {
 public:
  /// @param size       blocks in a row of the whole matrix
  /// @param couplings  pairs of different block rows in any order, repeated at will
  BlockPattern(int size, std::vector<std::pair<int, int>> couplings);

  int size() const { return static_cast<int>(row_begin_.size()) - 1; }
  int block_count() const { return static_cast<int>(columns_.size()); }
  int row_begin(int row) const { return row_begin_[static_cast<size_t>(row)]; }
  int row_end(int row) const { return row_begin_[static_cast<size_t>(row) + 1]; }
  int column(int block) const { return columns_[static_cast<size_t>(block)]; }
  int diagonal(int row) const { return row_begin(row); }

  /// The number of block (row, column), row <= column.
  /// @throws AssertionError when the pattern does not have it
  int find(int row, int column) const;

 private:
  std::vector<int> row_begin_;
  std::vector<int> columns_;
};

/// Three entries of a vector, in a block row.
struct RowVector {
  int row = 0;
  Eigen::Vector3d value;
};

/// How the blocks of a matrix beside its diagonal are kept: those on it are always of double
/// precision. An iterative solver of a large system is bound by memory.
enum class Precision { full, single };

/// A sparse symmetric matrix of 3x3 blocks, of which the upper triangle is stored, and beside the
/// pattern a sum of products f u u^T of vectors u that are zero but in a few rows. The pattern
/// holds the diagonal blocks of those, too.
class BlockMatrix {
 public:
  using Block = Eigen::Map<Eigen::Matrix3d>;
  using ConstBlock = Eigen::Map<const Eigen::Matrix3d>;

  explicit BlockMatrix(std::shared_ptr<const BlockPattern> pattern,
                       Precision precision = Precision::full);

  const BlockPattern& pattern() const { return *pattern_; }
  void set_zero();

  /// Block number `block` of the pattern, column by column, of a matrix of full precision.
  Block block(int block) { return Block(values_.data() + 9 * block); }
  ConstBlock block(int block) const { return ConstBlock(values_.data() + 9 * block); }

  /// The diagonal block of a row.
  Block diagonal(int row) { return Block(values_.data() + 9 * place_of_diagonal(row)); }
  ConstBlock diagonal(int row) const {
    return ConstBlock(values_.data() + 9 * place_of_diagonal(row));
  }

  /// work(entries), where the nine numbers of block k that is not on the diagonal begin at entries
  /// + 9 k, column by column: float or double.
  template <class Work>
  auto with_entries(const Work& work) {
    return precision_ == Precision::full ? work(values_.data()) : work(singles_.data());
  }
  template <class Work>
  auto with_entries(const Work& work) const {
    return precision_ == Precision::full ? work(values_.data()) : work(singles_.data());
  }

  /// Subtracts from the diagonal blocks of the first rows the sums of the blocks that couple them
  /// with each other. What depends on differences of positions alone need not add to diagonals.
  void complete_diagonals(int rows);

  /// Adds to block (i, j) or, transposed, to (j, i): whichever is stored. For i = j, `value` is
  /// symmetric.
  void add(int i, int j, const Eigen::Matrix3d& value);
  /// Adds `value` to every entry of the diagonal of row `row`.
  void add_to_diagonal(int row, double value);

  /// Adds factor u u^T, which may couple any rows.
  /// @param u  its rows, each once
  void add_outer_product(double factor, std::span<const RowVector> u);

  /// @name What stands beside the pattern
  /// @{
  int outer_products() const { return static_cast<int>(factors_.size()); }
  double factor(int product) const { return factors_[static_cast<size_t>(product)]; }
  std::span<const RowVector> vector(int product) const {
    const size_t begin = vector_begin_[static_cast<size_t>(product)];
    return std::span(vectors_).subspan(begin,
                                       vector_begin_[static_cast<size_t>(product) + 1] - begin);
  }
  std::span<RowVector> vectors() { return vectors_; }
  /// @}

  bool all_finite() const;

  Eigen::VectorXd operator*(const Eigen::VectorXd& x) const;

  /// The lower triangle, entry by entry, of a matrix without anything beside its pattern.
  Eigen::SparseMatrix<double> lower_triangle() const;
  /// Overwrites the values of a matrix that `lower_triangle` made for the same pattern.
  void copy_to(Eigen::SparseMatrix<double>& lower) const;

 private:
  int place_of_diagonal(int row) const {
    return precision_ == Precision::full ? pattern_->diagonal(row) : row;
  }

  std::shared_ptr<const BlockPattern> pattern_;
  Precision precision_;
  std::vector<double> values_;   // of all blocks, or of those on the diagonal
  std::vector<float> singles_;   // of all blocks in single precision; on the diagonal nothing
  std::vector<double> factors_;  // of the products beside the pattern
  std::vector<size_t> vector_begin_{0};
  std::vector<RowVector> vectors_;
};

}  // namespace pliant
