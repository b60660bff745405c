#include "pliant/math/block_matrix.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "pliant/base/assert.h"
#include "pliant/math/simd.h"

namespace pliant {
namespace {

// Three numbers of a block row and a zero, as they are in registers and, four by four, in vectors.
using PaddedRow = simd::Four;
constexpr std::ptrdiff_t kPadded = 4;

PLIANT_INLINE PaddedRow padded_column(const double* entries) {
  return simd::load<PaddedRow>(entries);
}
PLIANT_INLINE PaddedRow padded_column(const float* entries) {
  float __attribute__((vector_size(16))) quad;
  std::memcpy(&quad, entries, sizeof(quad));
  return __builtin_convertvector(quad, PaddedRow);
}

PLIANT_INLINE PaddedRow repeated(const PaddedRow& x, int k) {
  return PaddedRow{x[k], x[k], x[k], x[k]};
}

// y += K x, K being a matrix without what stands beside its pattern.
struct MatrixProduct {
  template <class V, class Number>
  PLIANT_INLINE static void run(const BlockMatrix* matrix, const Number* entries, const double* x,
                                double* y) {
    const BlockPattern& pattern = matrix->pattern();
    for (int i = 0; i < pattern.size(); ++i) {
      const double* const d = matrix->diagonal(i).data();
      const PaddedRow own = simd::load<PaddedRow>(x + kPadded * i);
      PaddedRow sum = PaddedRow{d[0], d[1], d[2], 0} * repeated(own, 0) +
                      PaddedRow{d[3], d[4], d[5], 0} * repeated(own, 1) +
                      PaddedRow{d[6], d[7], d[8], 0} * repeated(own, 2);
      for (int k = pattern.row_begin(i) + 1; k < pattern.row_end(i); ++k) {
        const int j = pattern.column(k);
        const Number* const block = entries + 9 * k;
        const PaddedRow a = padded_column(block), b = padded_column(block + 3),
                        c = padded_column(block + 6);
        const PaddedRow other = simd::load<PaddedRow>(x + kPadded * j);
        sum += a * repeated(other, 0) + b * repeated(other, 1) + c * repeated(other, 2);
        const PaddedRow p = a * own, q = b * own, r = c * own;
        add(PaddedRow{p[0], q[0], r[0], 0} + PaddedRow{p[1], q[1], r[1], 0} +
                PaddedRow{p[2], q[2], r[2], 0},
            y + kPadded * j);
      }
      add(sum, y + kPadded * i);
    }
  }

  PLIANT_INLINE static void add(const PaddedRow& row, double* to) {
    simd::store(PaddedRow(simd::load<PaddedRow>(to) + row), to);
  }
};

}  // namespace

BlockPattern::BlockPattern(int size, std::vector<std::pair<int, int>> couplings) {
  for (auto& [i, j] : couplings) {
    PLIANT_ASSERT(i != j && std::min(i, j) >= 0 && std::max(i, j) < size,
                  "a coupling joins two different block rows of the matrix");
    if (i > j) std::swap(i, j);
  }
  for (int i = 0; i < size; ++i) couplings.emplace_back(i, i);
  std::sort(couplings.begin(), couplings.end());
  couplings.erase(std::unique(couplings.begin(), couplings.end()), couplings.end());

  row_begin_.assign(static_cast<size_t>(size) + 1, 0);
  columns_.reserve(couplings.size());
  for (const auto& [i, j] : couplings) {
    ++row_begin_[static_cast<size_t>(i) + 1];
    columns_.push_back(j);
  }
  for (size_t i = 1; i < row_begin_.size(); ++i) row_begin_[i] += row_begin_[i - 1];
}

int BlockPattern::find(int row, int column) const {
  const auto begin = columns_.begin() + row_begin(row), end = columns_.begin() + row_end(row);
  const auto found = std::lower_bound(begin, end, column);
  PLIANT_ASSERT(found != end && *found == column, "the pattern has a block of this coupling");
  return static_cast<int>(found - columns_.begin());
}

BlockMatrix::BlockMatrix(std::shared_ptr<const BlockPattern> pattern, Precision precision)
    : pattern_(std::move(pattern)), precision_(precision) {
  const auto blocks = static_cast<size_t>(pattern_->block_count());
  const bool full = precision == Precision::full;
  // A column of the last block is read with one number more.
  values_.assign(9 * (full ? blocks : static_cast<size_t>(pattern_->size())) + 1, 0.0);
  if (!full) singles_.assign(9 * blocks + 1, 0.0F);
}

void BlockMatrix::set_zero() {
  std::fill(values_.begin(), values_.end(), 0.0);
  std::fill(singles_.begin(), singles_.end(), 0.0F);
  factors_.clear();
  vector_begin_.assign(1, 0);
  vectors_.clear();
}

void BlockMatrix::add(int i, int j, const Eigen::Matrix3d& value) {
  if (i == j) {
    diagonal(i) += value;
    return;
  }
  const Eigen::Matrix3d upper = i < j ? value : value.transpose();
  const int k = pattern_->find(std::min(i, j), std::max(i, j));
  with_entries([&]<class Number>(Number* entries) {
    Eigen::Map<Eigen::Matrix<Number, 3, 3>>(entries + 9 * k) += upper.cast<Number>();
  });
}

void BlockMatrix::add_to_diagonal(int row, double value) {
  diagonal(row).diagonal().array() += value;
}

void BlockMatrix::add_outer_product(double factor, std::span<const RowVector> u) {
  for (const auto& [row, value] : u) {
    diagonal(row) += factor * value * value.transpose();
  }
  factors_.push_back(factor);
  vectors_.insert(vectors_.end(), u.begin(), u.end());
  vector_begin_.push_back(vectors_.size());
}

bool BlockMatrix::all_finite() const {
  const auto is_finite = [](auto x) { return std::isfinite(x); };
  return std::all_of(values_.begin(), values_.end(), is_finite) &&
         std::all_of(singles_.begin(), singles_.end(), is_finite);
}

void BlockMatrix::complete_diagonals(int rows) {
  with_entries([&](const auto* entries) {
    for (int i = 0; i < rows; ++i) {
      double own[9] = {};
      for (int k = pattern_->row_begin(i) + 1; k < pattern_->row_end(i); ++k) {
        const int j = pattern_->column(k);
        if (j >= rows) break;
        const auto* const block = entries + 9 * k;
        double* const others = diagonal(j).data();
        for (int e = 0; e < 9; ++e) own[e] += static_cast<double>(block[e]);
        for (int e = 0; e < 9; ++e) others[e] -= static_cast<double>(block[e % 3 * 3 + e / 3]);
      }
      diagonal(i) -= ConstBlock(own);
    }
  });
}

Eigen::VectorXd BlockMatrix::operator*(const Eigen::VectorXd& x) const {
  const std::ptrdiff_t rows = pattern_->size();
  const auto numbers = static_cast<size_t>(kPadded * rows);
  std::vector<double> from(numbers), to(numbers);
  for (std::ptrdiff_t i = 0; i < rows; ++i) {
    std::copy_n(x.data() + 3 * i, 3, from.data() + kPadded * i);
  }
  with_entries([&](const auto* entries) {
    simd::run<MatrixProduct>(this, entries, static_cast<const double*>(from.data()), to.data());
  });
  Eigen::VectorXd y(x.size());
  for (std::ptrdiff_t i = 0; i < rows; ++i) {
    std::copy_n(to.data() + kPadded * i, 3, y.data() + 3 * i);
  }
  for (int p = 0; p < outer_products(); ++p) {
    double dot = 0;
    for (const auto& [row, value] : vector(p)) dot += value.dot(x.segment<3>(3 * row));
    for (const auto& [row, value] : vector(p)) {
      const double others = dot - value.dot(x.segment<3>(3 * row));  // its own: in the diagonal
      y.segment<3>(3 * row) += factor(p) * others * value;
    }
  }
  return y;
}

// Scalar column 3 i + a of the lower triangle holds row a of the blocks (i, j), j >= i.
Eigen::SparseMatrix<double> BlockMatrix::lower_triangle() const {
  PLIANT_ASSERT(factors_.empty() && precision_ == Precision::full,
                "a matrix with all of it in its pattern, in full precision");
  const int n = 3 * pattern_->size();
  Eigen::SparseMatrix<double> lower(n, n);
  Eigen::VectorXi sizes(n);
  for (int i = 0; i < pattern_->size(); ++i) {
    const int blocks = pattern_->row_end(i) - pattern_->row_begin(i);
    for (int a = 0; a < 3; ++a) sizes(3 * i + a) = 3 * blocks - a;
  }
  lower.reserve(sizes);
  for (int i = 0; i < pattern_->size(); ++i) {
    for (int a = 0; a < 3; ++a) {
      for (int k = pattern_->row_begin(i); k < pattern_->row_end(i); ++k) {
        const int j = pattern_->column(k);
        for (int b = j == i ? a : 0; b < 3; ++b) lower.insert(3 * j + b, 3 * i + a) = 0;
      }
    }
  }
  if (n > 0) lower.makeCompressed();
  copy_to(lower);
  return lower;
}

void BlockMatrix::copy_to(Eigen::SparseMatrix<double>& lower) const {
  PLIANT_ASSERT(factors_.empty(), "a matrix with all of it in its pattern");
  double* value = lower.valuePtr();
  for (int i = 0; i < pattern_->size(); ++i) {
    for (int a = 0; a < 3; ++a) {
      for (int k = pattern_->row_begin(i); k < pattern_->row_end(i); ++k) {
        const bool diagonal = k == pattern_->row_begin(i);
        for (int b = diagonal ? a : 0; b < 3; ++b) *value++ = block(k)(a, b);
      }
    }
  }
}

}  // namespace pliant
