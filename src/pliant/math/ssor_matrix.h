#pragma once

#include <utility>
#include <vector>

#include "pliant/math/block_matrix.h"
#include "pliant/math/quad.h"
#include "pliant/math/row_parts.h"

namespace pliant {

using Quads = std::vector<Quad>;

/// A block matrix K for conjugate gradients with symmetric over-relaxation as preconditioner: A =
/// C^-1 K C^-T with C C^T = the diagonal blocks over the relaxation factor w, so that A = w I + U +
/// U^T + P. P is what K has beside its pattern. The preconditioner is (I + U^T)(I + U).
///
/// Rows stand in the order of `RowParts`; the result of a sweep does not depend on who makes which
/// half.
class SsorMatrix {
 public:
  explicit SsorMatrix(const BlockPattern& pattern);

  /// @return whether all diagonal blocks are positive definite
  bool take(const BlockMatrix& matrix);

  size_t rows() const { return inverse_c_.size(); }

  /// C^-1 b
  Quads scaled(const Eigen::VectorXd& b) const;
  /// Adds C^-T y.
  void add_unscaled(const Quads& y, Eigen::VectorXd& x) const;

  /// (I + U)^-1 v
  void solve_upper(const Quads& v, Quads& t) const;
  /// (I + U^T)^-1 v in place
  void solve_lower(Quads& v) const;

  /// The next direction p = r + ratio p, and the preconditioned product (I + U^T)^-1 A (I + U)^-1 p
  /// = t + rest.
  /// @return p . (t + rest)
  double apply(double ratio, const Quads& r, Quads& p, Quads& t, Quads& rest) const;

  /// y += step p, r -= step (t + rest).
  /// @return r . r
  double advance(double step, const Quads& p, const Quads& t, const Quads& rest, Quads& y,
                 Quads& r) const;

 private:
  struct OuterProduct {
    float factor = 0;
    int begin = 0, end = 0;  // of u's rows
  };
  // Where a block above the diagonal of the matrix stands.
  struct Source {
    int block = 0;
    bool transposed = false;
  };

  // What is made in the widest instructions.
  struct Scaling;
  struct Upper;
  struct Lower;

  void find_blocks(const BlockPattern& pattern);
  void take_products(const BlockMatrix& matrix);
  void add_products(const Quads& t, Quads& result) const;

  void upper_of(int part, const Quads& v, Quads& t) const;
  void lower_of(int part, Quads& v) const;

  int begin_of(int part) const { return parts_.begin[static_cast<size_t>(part)]; }
  int end_of(int part) const { return parts_.begin[static_cast<size_t>(part) + 1]; }
  float* upper_block(int k) { return upper_.data() + static_cast<size_t>(kBlockSize) * k; }
  const float* upper_block(int k) const {
    return upper_.data() + static_cast<size_t>(kBlockSize) * k;
  }

  RowParts parts_;
  std::vector<int> row_begin_;  // of the blocks above the diagonal, by row
  std::vector<int> inner_end_;  // of those within a row's own part, which come first
  std::vector<int> columns_;
  std::vector<Source> sources_;
  std::vector<float> upper_;                // U, block by block
  std::vector<Eigen::Matrix3d> inverse_c_;  // lower triangular

  // Of the rows of the middle: the blocks that couple them with the halves.
  struct OfHalf {
    int block = 0, row = 0;
  };
  std::vector<int> of_halves_begin_;
  std::vector<OfHalf> of_halves_;

  std::vector<OuterProduct> products_;
  std::vector<std::pair<int, Quad>> vectors_;  // rows of all u
};

}  // namespace pliant
