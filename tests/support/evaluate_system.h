#pragma once

#include <utility>

#include <Eigen/Core>

#include "pliant/mechanics/system.h"

namespace pliant::test {

inline Energy energy_of(const System& system, const Configuration& at, const State& from,
                        const StepTime& time = {}, const Parameters& parameters = kAsBuilt) {
  Derivatives derivatives;
  system.evaluate(at, {.from = from, .parameters = parameters, .time = time}, Curvature::exact,
                  derivatives);
  return derivatives.energy;
}

/// dE / d points (N).
inline Eigen::Matrix3Xd gradient_of(const System& system, const Configuration& at,
                                    const State& from, const StepTime& time = {},
                                    const Parameters& parameters = kAsBuilt) {
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, system.points());
  Derivatives derivatives;
  derivatives.gradient = &gradient;
  system.evaluate(at, {.from = from, .parameters = parameters, .time = time}, Curvature::exact,
                  derivatives);
  return gradient;
}

/// dE / d unknowns.
inline Eigen::VectorXd reduced_gradient(const System& system, const Configuration& at,
                                        const State& from, const StepTime& time = {}) {
  return system.coordinates().reduce(at, gradient_of(system, at, from, time));
}

inline Eigen::MatrixXd dense(const BlockMatrix& matrix) {
  return Eigen::MatrixXd(matrix.lower_triangle()).selfadjointView<Eigen::Lower>();
}

/// d2E / d unknowns^2, all entries.
inline Eigen::MatrixXd hessian_of(const System& system, const Configuration& at, const State& from,
                                  const StepTime& time = {},
                                  Curvature curvature = Curvature::exact) {
  Hessian hessian = system.make_hessian();
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, system.points());
  Derivatives derivatives;
  derivatives.gradient = &gradient;
  derivatives.hessian = &hessian;
  system.evaluate(at, {.from = from, .time = time}, curvature, derivatives);
  if (curvature == Curvature::exact) {
    system.coordinates().add_rotation_terms(at, gradient, hessian.matrix);
  }
  return dense(hessian.matrix);
}

/// Ends a step at `at`.
/// @return the work done against friction and damping (J)
inline double accept(const System& system, State& state, const Configuration& at,
                     const StepTime& time = {}, const Parameters& parameters = kAsBuilt) {
  Eigen::VectorXd history;
  const double work =
      system.advance_history(at, {.from = state, .parameters = parameters, .time = time}, history)
          .work;
  state.history = std::move(history);
  state.configuration = at;
  return work;
}

}  // namespace pliant::test
