#include "pliant/math/ssor_cg.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

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

}  // namespace

struct SsorCg::Scaled {
  std::vector<int> row_begin, columns;     // of the blocks above the diagonal
  std::vector<QuadBlock> upper;            // U, blocks of the scaled matrix I + U + U^T
  std::vector<Eigen::Matrix3d> inverse_c;  // C^-1 of every row, lower triangular

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

  // (I + U^T)^-1 (I + U + U^T) (I + U)^-1 v; t is scratch.
  void apply(const Quads& v, Quads& t, Quads& result) const {
    solve_upper(v, t);
    for (size_t i = 0; i < v.size(); ++i) result[i] = v[i] - t[i];
    solve_lower(result);
    for (size_t i = 0; i < v.size(); ++i) result[i] += t[i];
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
  for (int i = 0; i < pattern.size(); ++i) {
    const Eigen::LLT<Eigen::Matrix3d> llt(matrix.block(pattern.diagonal(i)));
    if (llt.info() != Eigen::Success) return false;
    Eigen::Matrix3d& inverse_c = scaled_->inverse_c[static_cast<size_t>(i)];
    inverse_c = llt.matrixL().solve(Eigen::Matrix3d::Identity());
    if (!inverse_c.allFinite()) return false;
  }
  size_t next = 0;
  for (int i = 0; i < pattern.size(); ++i) {
    for (int k = pattern.row_begin(i) + 1; k < pattern.row_end(i); ++k) {
      const Eigen::Matrix3d block =
          scaled_->inverse_c[static_cast<size_t>(i)] * matrix.block(k) *
          scaled_->inverse_c[static_cast<size_t>(pattern.column(k))].transpose();
      for (int c = 0; c < 3; ++c) scaled_->upper[next].column[c] = quad(block.col(c));
      ++next;
    }
  }
  return true;
}

// Single precision has a small range: what goes into it is scaled to 1 before.
LinearSummary SsorCg::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  constexpr double kReach = 1e-4;  // what single precision gives in one pass
  LinearSummary summary;
  const double unit = b.size() > 0 ? b.cwiseAbs().maxCoeff() : 0;
  if (unit == 0) {
    x.setZero(b.size());
    return summary;
  }
  const double scale = scaled_->norm(b / unit);
  const double target = options_.tolerance * scale;
  Eigen::VectorXd residual = (b - *matrix_ * x) / unit;
  double norm = scaled_->norm(residual);
  while (norm > target && summary.iterations < options_.max_iterations) {
    const double size = residual.cwiseAbs().maxCoeff();
    Eigen::VectorXd correction = Eigen::VectorXd::Zero(x.size());
    const Scaled::Pass pass =
        scaled_->correct(residual / size, std::max(target, kReach * norm) / size,
                         options_.max_iterations - summary.iterations, correction);
    summary.iterations += pass.iterations;
    x += unit * size * correction;
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
