#include "pliant/math/block_matrix.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"

namespace pliant {

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

BlockMatrix::BlockMatrix(std::shared_ptr<const BlockPattern> pattern)
    : pattern_(std::move(pattern)),
      values_(static_cast<size_t>(pattern_->block_count()) * 9, 0.0) {}

void BlockMatrix::set_zero() {
  std::fill(values_.begin(), values_.end(), 0.0);
  factors_.clear();
  vector_begin_.assign(1, 0);
  vectors_.clear();
}

void BlockMatrix::add(int i, int j, const Eigen::Matrix3d& value) {
  if (i <= j) {
    block(pattern_->find(i, j)) += value;
  } else {
    block(pattern_->find(j, i)) += value.transpose();
  }
}

void BlockMatrix::add_to_diagonal(int row, double value) {
  block(pattern_->diagonal(row)).diagonal().array() += value;
}

void BlockMatrix::add_outer_product(double factor, std::span<const RowVector> u) {
  for (const auto& [row, value] : u) {
    block(pattern_->diagonal(row)) += factor * value * value.transpose();
  }
  factors_.push_back(factor);
  vectors_.insert(vectors_.end(), u.begin(), u.end());
  vector_begin_.push_back(vectors_.size());
}

bool BlockMatrix::all_finite() const {
  return std::all_of(values_.begin(), values_.end(), [](double x) { return std::isfinite(x); });
}

Eigen::VectorXd BlockMatrix::operator*(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
  for (int i = 0; i < pattern_->size(); ++i) {
    const Eigen::Vector3d xi = x.segment<3>(3 * i);
    Eigen::Vector3d sum = block(pattern_->diagonal(i)) * xi;
    for (int k = pattern_->row_begin(i) + 1; k < pattern_->row_end(i); ++k) {
      const int j = pattern_->column(k);
      sum += block(k) * x.segment<3>(3 * j);
      y.segment<3>(3 * j) += block(k).transpose() * xi;
    }
    y.segment<3>(3 * i) += sum;
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
  PLIANT_ASSERT(factors_.empty(), "a matrix with all of it in its pattern");
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
