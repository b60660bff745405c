#include "pliant/math/ssor_cg.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant {
namespace {

// Three numbers of one block row and a zero, which the compiler keeps in one register.
using Quad = float __attribute__((vector_size(16)));
using Quads = std::vector<Quad>;

// A 3x3 block by its columns.
struct QuadBlock {
  Quad column[3];
};

inline Quad spread(const Quad& x, int k) { return Quad{x[k], x[k], x[k], x[k]}; }

inline Quad product(const QuadBlock& block, const Quad& x) {
  return block.column[0] * spread(x, 0) + block.column[1] * spread(x, 1) +
         block.column[2] * spread(x, 2);
}

inline Quad transposed_product(const QuadBlock& block, const Quad& x) {
  const Quad a = block.column[0] * x, b = block.column[1] * x, c = block.column[2] * x;
  const Quad zero{};
  // The sums within a, within b and within c: the table of three columns, transposed and added up.
  const Quad ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);    // a0 b0 a1 b1
  const Quad ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);   // a2 b2 0 0
  const Quad c_low = __builtin_shufflevector(c, zero, 0, 4, 1, 5);  // c0 0 c1 0
  const Quad c_high = __builtin_shufflevector(c, zero, 2, 6, 3, 7);
  return __builtin_shufflevector(ab_low, c_low, 0, 1, 4, 5) +
         __builtin_shufflevector(ab_low, c_low, 2, 3, 6, 7) +
         __builtin_shufflevector(ab_high, c_high, 0, 1, 4, 5);
}

// Sums in double precision, over all rows.
double dot(const Quads& x, const Quads& y) {
  double sum = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    const Quad p = x[i] * y[i];
    sum += static_cast<double>(p[0] + p[1] + p[2]);
  }
  return sum;
}

void add_scaled(Quads& x, double factor, const Quads& y) {
  const auto f = static_cast<float>(factor);
  for (size_t i = 0; i < x.size(); ++i) x[i] += f * y[i];
}

Quad quad(const Eigen::Vector3d& x) {
  return Quad{static_cast<float>(x(0)), static_cast<float>(x(1)), static_cast<float>(x(2)), 0};
}

Eigen::Vector3d vector(const Quad& x) { return {x[0], x[1], x[2]}; }

QuadBlock quad_block(const Eigen::Ref<const Eigen::Matrix3d>& m) {
  return {{quad(m.col(0)), quad(m.col(1)), quad(m.col(2))}};
}

// L B R^T with lower triangular L and R.
QuadBlock scaled_block(const QuadBlock& l, const QuadBlock& b, const QuadBlock& r) {
  QuadBlock left;
  for (int c = 0; c < 3; ++c) left.column[c] = product(l, b.column[c]);
  QuadBlock result;
  for (int c = 0; c < 3; ++c) {
    result.column[c] = left.column[0] * spread(r.column[0], c);
    for (int k = 1; k <= c; ++k) result.column[c] += left.column[k] * spread(r.column[k], c);
  }
  return result;
}

// C^-1 of C C^T = m, lower triangular.
// @return whether m is positive definite and its factor finite
bool invert_cholesky(const Eigen::Ref<const Eigen::Matrix3d>& m, Eigen::Matrix3d& inverse) {
  const double d0 = m(0, 0), p0 = 1 / std::sqrt(d0);
  const double l10 = m(1, 0) * p0, l20 = m(2, 0) * p0;
  const double d1 = m(1, 1) - l10 * l10, p1 = 1 / std::sqrt(d1);
  const double l21 = (m(2, 1) - l20 * l10) * p1;
  const double d2 = m(2, 2) - l20 * l20 - l21 * l21, p2 = 1 / std::sqrt(d2);
  if (!(d0 > 0 && d1 > 0 && d2 > 0)) return false;
  inverse << p0, 0, 0, -l10 * p0 * p1, p1, 0, (l10 * l21 * p1 - l20) * p0 * p2, -l21 * p1 * p2, p2;
  return inverse.allFinite();
}

}  // namespace

struct SsorCg::Scaled {
  std::vector<int> row_begin, columns;     // of the blocks above the diagonal
  std::vector<QuadBlock> upper;            // U, blocks of the scaled matrix I + U + U^T
  std::vector<Eigen::Matrix3d> inverse_c;  // C^-1 of every row, lower triangular

  // What couples rows beside the pattern: the sum of f u u^T without its diagonal blocks.
  struct OuterProduct {
    float factor = 0;
    int begin = 0, end = 0;  // of u's rows
  };
  std::vector<OuterProduct> products;
  std::vector<std::pair<int, Quad>> vectors;  // rows of all u

  int rows() const { return static_cast<int>(inverse_c.size()); }

  // (I + U)^-1 v
  void solve_upper(const Quads& v, Quads& t) const {
    for (int i = rows() - 1; i >= 0; --i) {
      Quad sum = v[static_cast<size_t>(i)];
      for (int k = row_begin[static_cast<size_t>(i)]; k < row_begin[static_cast<size_t>(i) + 1];
           ++k) {
        sum -= product(upper[static_cast<size_t>(k)],
                       t[static_cast<size_t>(columns[static_cast<size_t>(k)])]);
      }
      t[static_cast<size_t>(i)] = sum;
    }
  }

  // (I + U^T)^-1 v in place
  void solve_lower(Quads& v) const {
    for (int i = 0; i < rows(); ++i) {
      const Quad vi = v[static_cast<size_t>(i)];
      for (int k = row_begin[static_cast<size_t>(i)]; k < row_begin[static_cast<size_t>(i) + 1];
           ++k) {
        v[static_cast<size_t>(columns[static_cast<size_t>(k)])] -=
            transposed_product(upper[static_cast<size_t>(k)], vi);
      }
    }
  }

  void add_products(const Quads& t, Quads& result) const {
    for (const OuterProduct& product : products) {
      Quad parts{};
      for (int k = product.begin; k < product.end; ++k) {
        const auto& [row, u] = vectors[static_cast<size_t>(k)];
        parts += u * t[static_cast<size_t>(row)];
      }
      const float dot = parts[0] + parts[1] + parts[2];
      for (int k = product.begin; k < product.end; ++k) {
        const auto& [row, u] = vectors[static_cast<size_t>(k)];
        const Quad own = u * t[static_cast<size_t>(row)];
        result[static_cast<size_t>(row)] += product.factor * (dot - (own[0] + own[1] + own[2])) * u;
      }
    }
  }

  // (I + U^T)^-1 (I + U + U^T + P) (I + U)^-1 v, P being the products; t is scratch.
  void apply(const Quads& v, Quads& t, Quads& result) const {
    solve_upper(v, t);
    for (size_t i = 0; i < v.size(); ++i) result[i] = v[i] - t[i];
    add_products(t, result);
    solve_lower(result);
    for (size_t i = 0; i < v.size(); ++i) result[i] += t[i];
  }

  void take_products(const BlockMatrix& matrix) {
    products.clear();
    vectors.clear();
    for (int p = 0; p < matrix.outer_products(); ++p) {
      const int begin = static_cast<int>(vectors.size());
      for (const auto& [row, value] : matrix.vector(p)) {
        vectors.emplace_back(row, quad(inverse_c[static_cast<size_t>(row)] * value));
      }
      products.push_back(
          {static_cast<float>(matrix.factor(p)), begin, static_cast<int>(vectors.size())});
    }
  }

  Quads scaled(const Eigen::VectorXd& b) const {
    Quads result(inverse_c.size());
    for (size_t i = 0; i < inverse_c.size(); ++i) {
      result[i] = quad(inverse_c[i] * b.segment<3>(static_cast<Eigen::Index>(3 * i)));
    }
    return result;
  }

  void add_unscaled(const Quads& y, Eigen::VectorXd& x) const {
    for (size_t i = 0; i < inverse_c.size(); ++i) {
      x.segment<3>(static_cast<Eigen::Index>(3 * i)) += inverse_c[i].transpose() * vector(y[i]);
    }
  }

  // Conjugate gradients for the correction of x by the residual r, until the preconditioned
  // residual is below `target`.
  struct Pass {
    int iterations = 0;
    bool positive = true;
    double residual = 0;  // as the iteration carries it along
  };
  Pass correct(const Eigen::VectorXd& residual, double target, int max_iterations,
               Eigen::VectorXd& x) const {
    Quads r = scaled(residual);
    solve_lower(r);
    Quads y(r.size(), Quad{}), p = r, t(r.size()), ap(r.size());
    double rr = dot(r, r);
    Pass pass;
    while (std::sqrt(rr) > target && pass.iterations < max_iterations) {
      apply(p, t, ap);
      const double curvature = dot(p, ap);
      if (!(curvature > 0)) {
        pass.positive = false;
        break;
      }
      const double step = rr / curvature;
      add_scaled(y, step, p);
      add_scaled(r, -step, ap);
      const double next = dot(r, r);
      const auto ratio = static_cast<float>(next / rr);
      for (size_t i = 0; i < p.size(); ++i) p[i] = r[i] + ratio * p[i];
      rr = next;
      ++pass.iterations;
    }
    pass.residual = std::sqrt(rr);
    solve_upper(y, t);
    add_unscaled(t, x);
    return pass;
  }

  double norm(const Eigen::VectorXd& b) const {
    Quads r = scaled(b);
    solve_lower(r);
    return std::sqrt(dot(r, r));
  }
};

SsorCg::SsorCg(const BlockMatrix& matrix, const Options& options)
    : options_(options), matrix_(&matrix), scaled_(std::make_unique<Scaled>()) {
  const BlockPattern& pattern = matrix.pattern();
  const auto rows = static_cast<size_t>(pattern.size());
  scaled_->row_begin.push_back(0);
  for (int i = 0; i < pattern.size(); ++i) {
    for (int k = pattern.row_begin(i) + 1; k < pattern.row_end(i); ++k) {
      scaled_->columns.push_back(pattern.column(k));
    }
    scaled_->row_begin.push_back(static_cast<int>(scaled_->columns.size()));
  }
  scaled_->upper.resize(scaled_->columns.size());
  scaled_->inverse_c.resize(rows);
}

SsorCg::~SsorCg() = default;

bool SsorCg::factorize(const BlockMatrix& matrix) {
  matrix_ = &matrix;
  const BlockPattern& pattern = matrix.pattern();
  std::vector<QuadBlock> scales(static_cast<size_t>(pattern.size()));  // inverse_c
  for (int i = 0; i < pattern.size(); ++i) {
    Eigen::Matrix3d& inverse_c = scaled_->inverse_c[static_cast<size_t>(i)];
    if (!invert_cholesky(matrix.block(pattern.diagonal(i)), inverse_c)) return false;
    scales[static_cast<size_t>(i)] = quad_block(inverse_c);
  }
  QuadBlock* next = scaled_->upper.data();
  for (int i = 0; i < pattern.size(); ++i) {
    const QuadBlock& left = scales[static_cast<size_t>(i)];
    for (int k = pattern.row_begin(i) + 1; k < pattern.row_end(i); ++k) {
      const QuadBlock& right = scales[static_cast<size_t>(pattern.column(k))];
      *next++ = scaled_block(left, quad_block(matrix.block(k)), right);
    }
  }
  scaled_->take_products(matrix);
  return true;
}

// Single precision has a small range: what goes into it is scaled to 1 before.
LinearSummary SsorCg::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  constexpr double kReach = 1e-4;    // what single precision gives in one pass
  constexpr double kTrusted = 5e-3;  // so far rounding changes the residual of a pass little
  LinearSummary summary;
  const double unit = b.size() > 0 ? b.cwiseAbs().maxCoeff() : 0;
  if (unit == 0) {
    x.setZero(b.size());
    return summary;
  }
  const double scale = scaled_->norm(b / unit);
  const double target = options_.tolerance * scale;
  const bool from_zero = x.isZero(0);
  Eigen::VectorXd residual = b / unit;
  if (!from_zero) residual -= *matrix_ * (x / unit);
  double norm = from_zero ? scale : scaled_->norm(residual);
  while (norm > target && summary.iterations < options_.max_iterations) {
    const double size = residual.cwiseAbs().maxCoeff();
    Eigen::VectorXd correction = Eigen::VectorXd::Zero(x.size());
    const Scaled::Pass pass =
        scaled_->correct(residual / size, std::max(target, kReach * norm) / size,
                         options_.max_iterations - summary.iterations, correction);
    summary.iterations += pass.iterations;
    x += unit * size * correction;
    const bool first = summary.iterations == pass.iterations;
    if (first && pass.positive && target > kTrusted * norm && pass.residual * size <= target) {
      norm = pass.residual * size;
      break;
    }
    residual = (b - *matrix_ * x) / unit;
    const double before = std::exchange(norm, scaled_->norm(residual));
    if (!pass.positive || !(norm < before / 2)) break;
  }
  summary.residual = norm / scale;
  summary.converged = norm <= 1.01 * target;
  return summary;
}

Eigen::MatrixXd SsorCg::solve_all(const Eigen::MatrixXd& b) const {
  Eigen::MatrixXd all(b.rows(), b.cols());
  for (Eigen::Index k = 0; k < b.cols(); ++k) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.rows());
    solve(b.col(k), x);
    all.col(k) = x;
  }
  return all;
}

std::unique_ptr<LinearSolver> SsorCg::another() const {
  return std::make_unique<SsorCg>(*matrix_, options_);
}

}  // namespace pliant
