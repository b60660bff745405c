#include "pliant/estimation/mesh_error.h"

#include <cmath>

#include "pliant/estimation/estimating_equations.h"

namespace pliant {
namespace {

Eigen::VectorXd gradient_of(const EstimatingSums& sums) {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(sums.unknowns());
  for (const GroupSum& group : sums.groups) gradient += group.part;
  return gradient;
}

}  // namespace

Eigen::VectorXd moved_on(const Problem& other, const std::vector<Eigen::VectorXd>& weight,
                         const Problem& problem, const Eigen::VectorXd& values,
                         const Uncertainty& known, const ToldUnknowns& told) {
  const auto there = predicted_sums(other, values, weight, known.free, told);
  if (!there) return {};
  const EstimatingSums here = estimating_sums(problem, known.noise.rows, known.noise.weight,
                                              known.noise.scatter, known.free, told);
  const std::vector<double> infinite(weight.size(), INFINITY);
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(values.size());
  // G_2h^-1 (g_h - g_2h): docs/estimation.md, The error of the mesh.
  moved(known.free) = formula_covariance(*there, known.unit, infinite).inverse_slope *
                      (gradient_of(here) - gradient_of(*there));
  return moved;
}

}  // namespace pliant
