#include "pliant/math/sparse_cholesky.h"

#include <algorithm>

#include <Eigen/Cholesky>

#include "pliant/math/supernodes.h"

namespace pliant {
namespace {

/// Block row of a front that an eliminated row stands in.
int row_in_front(const Supernode& node, int row) {
  if (row < node.first + node.columns) return row - node.first;
  const auto found = std::ranges::lower_bound(node.rows, row);
  return node.columns + static_cast<int>(found - node.rows.begin());
}

/// The supernode of each eliminated column.
std::vector<std::size_t> nodes_of_columns(const SymbolicFactor& symbolic) {
  std::vector<std::size_t> node_of(symbolic.place.size());
  for (std::size_t s = 0; s < symbolic.supernodes.size(); ++s) {
    const Supernode& node = symbolic.supernodes[s];
    std::fill_n(node_of.begin() + node.first, node.columns, s);
  }
  return node_of;
}

/// Adds the lower triangle of what a child has left to its parent's front.
void extend_add(const Eigen::MatrixXd& left, const std::vector<int>& rows, Eigen::MatrixXd& front) {
  for (std::size_t j = 0; j < rows.size(); ++j) {
    const auto column = static_cast<Eigen::Index>(3 * j);
    for (std::size_t i = j; i < rows.size(); ++i) {
      front.block<3, 3>(3 * rows[i], 3 * rows[j]) +=
          left.block<3, 3>(static_cast<Eigen::Index>(3 * i), column);
    }
  }
}

}  // namespace

struct SparseCholesky::Analysis {
  /// A block of the matrix in the front of a supernode.
  struct Entry {
    int block = 0, row = 0, column = 0;  // of the matrix; block row and column of the front
    bool transposed = false;
  };

  SymbolicFactor symbolic;
  std::vector<std::vector<Entry>> entries;    // of each supernode
  std::vector<std::vector<int>> children;     // of each supernode
  std::vector<std::vector<int>> parent_rows;  // in the parent's front, of each of `rows`

  explicit Analysis(const BlockPattern& pattern)
      : symbolic(pattern),
        entries(symbolic.supernodes.size()),
        children(symbolic.supernodes.size()),
        parent_rows(symbolic.supernodes.size()) {
    place_entries(pattern);
    for (std::size_t s = 0; s < symbolic.supernodes.size(); ++s) {
      const Supernode& node = symbolic.supernodes[s];
      if (node.parent < 0) continue;
      const auto parent = static_cast<std::size_t>(node.parent);
      children[parent].push_back(static_cast<int>(s));
      for (const int row : node.rows) {
        parent_rows[s].push_back(row_in_front(symbolic.supernodes[parent], row));
      }
    }
  }

 private:
  void place_entries(const BlockPattern& pattern) {
    const std::vector<std::size_t> node_of = nodes_of_columns(symbolic);
    for (int i = 0; i < pattern.size(); ++i) {
      for (int k = pattern.row_begin(i); k < pattern.row_end(i); ++k) {
        const int p = symbolic.place[static_cast<std::size_t>(i)];
        const int q = symbolic.place[static_cast<std::size_t>(pattern.column(k))];
        const std::size_t s = node_of[static_cast<std::size_t>(std::min(p, q))];
        const Supernode& node = symbolic.supernodes[s];
        entries[s].push_back(
            {k, row_in_front(node, std::max(p, q)), std::min(p, q) - node.first, q > p});
      }
    }
  }
};

SparseCholesky::SparseCholesky(const BlockMatrix& matrix)
    : SparseCholesky(std::make_shared<const Analysis>(matrix.pattern())) {}

SparseCholesky::SparseCholesky(std::shared_ptr<const Analysis> analysis)
    : analysis_(std::move(analysis)),
      panels_(analysis_->symbolic.supernodes.size()),
      left_(panels_.size()) {
  for (std::size_t s = 0; s < panels_.size(); ++s) {
    const Supernode& node = analysis_->symbolic.supernodes[s];
    panels_[s].resize(3 * node.size(), 3 * node.columns);
  }
}

SparseCholesky::~SparseCholesky() = default;

std::unique_ptr<LinearSolver> SparseCholesky::another() const {
  return std::unique_ptr<LinearSolver>(new SparseCholesky(analysis_));
}

// @return what stands on the diagonal of the node's own rows before anything is eliminated
Eigen::VectorXd SparseCholesky::gather(const BlockMatrix& matrix, std::size_t node,
                                       Eigen::MatrixXd& front) {
  const Eigen::Index size = 3 * analysis_->symbolic.supernodes[node].size();
  front.setZero(size, size);
  for (const Analysis::Entry& entry : analysis_->entries[node]) {
    auto place = front.block<3, 3>(3 * entry.row, 3 * entry.column);
    if (entry.transposed) {
      place = matrix.block(entry.block).transpose();
    } else {
      place = matrix.block(entry.block);
    }
  }
  const Eigen::VectorXd diagonal = front.diagonal().head(panels_[node].cols());
  for (const int child : analysis_->children[node]) {
    const auto c = static_cast<std::size_t>(child);
    extend_add(left_[c], analysis_->parent_rows[c], front);
    left_[c].resize(0, 0);
  }
  return diagonal;
}

bool SparseCholesky::factorize(const BlockMatrix& matrix) {
  constexpr double kOfDiagonal = 1e-13;  // a pivot below that is what rounding left of zero
  // A pivot that is not a number would pass for positive.
  if (!matrix.all_finite()) return false;
  Eigen::MatrixXd front;
  for (std::size_t s = 0; s < panels_.size(); ++s) {
    const Eigen::VectorXd diagonal = gather(matrix, s, front);
    const Eigen::Index own = panels_[s].cols(), below = panels_[s].rows() - own;
    Eigen::Ref<Eigen::MatrixXd> pivots = front.topLeftCorner(own, own);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> llt(pivots);
    if (llt.info() != Eigen::Success) return false;
    const auto squares = pivots.diagonal().array().square();
    if ((squares < kOfDiagonal * diagonal.array()).any()) return false;
    auto rest = front.bottomLeftCorner(below, own);
    pivots.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(rest);
    panels_[s] = front.leftCols(own);
    if (below == 0) continue;
    auto left = front.bottomRightCorner(below, below);
    left.selfadjointView<Eigen::Lower>().rankUpdate(rest, -1.0);
    left_[s] = left;
  }
  return true;
}

// Forwards through the lower factor and backwards through its transpose, panel by panel.
void SparseCholesky::substitute(Eigen::MatrixXd& x) const {
  const auto rows_below = [&](std::size_t s) {
    std::vector<Eigen::Index> rows;
    for (const int row : analysis_->symbolic.supernodes[s].rows) {
      for (int a = 0; a < 3; ++a) rows.push_back(3 * row + a);
    }
    return rows;
  };
  for (std::size_t s = 0; s < panels_.size(); ++s) {
    const Eigen::Index own = panels_[s].cols(), below = panels_[s].rows() - own;
    auto part = x.middleRows(3 * analysis_->symbolic.supernodes[s].first, own);
    panels_[s].topRows(own).triangularView<Eigen::Lower>().solveInPlace(part);
    if (below > 0) x(rows_below(s), Eigen::all) -= panels_[s].bottomRows(below) * part;
  }
  for (std::size_t s = panels_.size(); s-- > 0;) {
    const Eigen::Index own = panels_[s].cols(), below = panels_[s].rows() - own;
    auto part = x.middleRows(3 * analysis_->symbolic.supernodes[s].first, own);
    if (below > 0) {
      const Eigen::MatrixXd known = x(rows_below(s), Eigen::all);
      part.noalias() -= panels_[s].bottomRows(below).transpose() * known;
    }
    panels_[s].topRows(own).triangularView<Eigen::Lower>().transpose().solveInPlace(part);
  }
}

Eigen::MatrixXd SparseCholesky::solve_all(const Eigen::MatrixXd& b) const {
  Eigen::MatrixXd eliminated(b.rows(), b.cols());
  for (std::size_t i = 0; i < analysis_->symbolic.place.size(); ++i) {
    eliminated.middleRows<3>(3 * analysis_->symbolic.place[i]) =
        b.middleRows<3>(static_cast<Eigen::Index>(3 * i));
  }
  substitute(eliminated);
  Eigen::MatrixXd x(b.rows(), b.cols());
  for (std::size_t i = 0; i < analysis_->symbolic.place.size(); ++i) {
    x.middleRows<3>(static_cast<Eigen::Index>(3 * i)) =
        eliminated.middleRows<3>(3 * analysis_->symbolic.place[i]);
  }
  return x;
}

LinearSummary SparseCholesky::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  x = solve_all(b);
  return {};
}

}  // namespace pliant
