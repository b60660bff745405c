#include "pliant/math/ssor_cg.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/math/ssor_matrix.h"

namespace pliant {
namespace {

double norm(const SsorMatrix& matrix, const Eigen::VectorXd& b) {
  Quads r = matrix.scaled(b);
  matrix.solve_lower(r);
  double squared = 0;
  for (const Quad& one : r) squared += dot(one, one);
  return std::sqrt(squared);
}

// How conjugate gradients went in single precision.
struct Pass {
  int iterations = 0;
  bool positive = true;
  double residual = 0;  // as the iteration carries it along
};

// The correction of x by a residual, until the preconditioned residual is below `target`.
Pass correct(const SsorMatrix& matrix, const Eigen::VectorXd& residual, double target,
             int max_iterations, Eigen::VectorXd& x) {
  Quads r = matrix.scaled(residual);
  matrix.solve_lower(r);
  Quads y(r.size(), Quad{}), p = y, t(r.size()), w(r.size());
  double rr = 0, ratio = 0;
  for (const Quad& one : r) rr += dot(one, one);
  Pass pass;
  while (std::sqrt(rr) > target && pass.iterations < max_iterations) {
    const double curvature = matrix.apply(ratio, r, p, t, w);
    if (!(curvature > 0)) {
      pass.positive = false;
      break;
    }
    const double next = matrix.advance(rr / curvature, p, t, w, y, r);
    ratio = next / rr;
    rr = next;
    ++pass.iterations;
  }
  pass.residual = std::sqrt(rr);
  matrix.solve_upper(y, t);
  matrix.add_unscaled(t, x);
  return pass;
}

}  // namespace

SsorCg::SsorCg(const BlockMatrix& matrix, const Options& options)
    : options_(options),
      matrix_(&matrix),
      scaled_(std::make_unique<SsorMatrix>(matrix.pattern())) {}

SsorCg::~SsorCg() = default;

bool SsorCg::factorize(const BlockMatrix& matrix) {
  matrix_ = &matrix;
  return scaled_->take(matrix);
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
  const double scale = norm(*scaled_, b / unit);
  const double target = options_.tolerance * scale;
  const bool from_zero = x.isZero(0);
  Eigen::VectorXd residual = b / unit;
  if (!from_zero) residual -= *matrix_ * (x / unit);
  double now = from_zero ? scale : norm(*scaled_, residual);
  while (now > target && summary.iterations < options_.max_iterations) {
    const double size = residual.cwiseAbs().maxCoeff();
    Eigen::VectorXd correction = Eigen::VectorXd::Zero(x.size());
    const Pass pass = correct(*scaled_, residual / size, std::max(target, kReach * now) / size,
                              options_.max_iterations - summary.iterations, correction);
    summary.iterations += pass.iterations;
    x += unit * size * correction;
    const bool first = summary.iterations == pass.iterations;
    if (first && pass.positive && target > kTrusted * now && pass.residual * size <= target) {
      now = pass.residual * size;
      break;
    }
    residual = (b - *matrix_ * x) / unit;
    const double before = std::exchange(now, norm(*scaled_, residual));
    if (!pass.positive || !(now < before / 2)) break;
  }
  summary.residual = now / scale;
  summary.converged = now <= 1.01 * target;
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
