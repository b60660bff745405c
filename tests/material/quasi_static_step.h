#pragma once

#include "pliant/material/density/density.h"

#include "support/density_samples.h"

namespace pliant::test {

/// Of one material point: (stress, next history) as a function of (strain, last strain, history,
/// parameters), in statics; of a law that remembers nothing also its energy, in front.
class QuasiStaticStep {
 public:
  /// @param strain_scale  a change over which the law changes noticeably
  /// @param time          how long the step takes; without rates
  QuasiStaticStep(const ParametricDensity& law, const LaneState& state, int lane,
                  double strain_scale, const StepTime& time = {})
      : law_(law), state_(state), lane_(lane), strain_scale_(strain_scale), time_(time) {}

  Eigen::VectorXd arguments() const {
    Eigen::VectorXd x(2 * strains() + history() + parameters());
    x << state_.strain.row(lane_).transpose().matrix(), state_.last.row(lane_).transpose().matrix(),
        state_.history.row(lane_).transpose().matrix(), law_.parameters();
    return x;
  }

  Eigen::VectorXd scale() const {
    Eigen::VectorXd x(2 * strains() + history() + parameters());
    x << Eigen::VectorXd::Constant(2 * strains(), strain_scale_), Eigen::VectorXd::Ones(history()),
        law_.parameters().cwiseAbs() / 2;
    return x;
  }

  Eigen::VectorXd operator()(const Eigen::VectorXd& x) const {
    const auto law = law_.with_parameters(x.tail(parameters()));
    LaneState state = state_;
    state.strain.row(lane_) = x.head(strains()).transpose().array();
    state.last.row(lane_) = x.segment(strains(), strains()).transpose().array();
    state.history.row(lane_) = x.segment(2 * strains(), history()).transpose().array();
    const Response response = response_of(*law, state, time_);
    Eigen::VectorXd result(energies() + strains() + history());
    if (energies() > 0) result(0) = response.stored(lane_);
    result.segment(energies(), strains()) = response.stress.row(lane_).transpose().matrix();
    advance(*law, state, time_);
    result.tail(history()) = state.history.row(lane_).transpose().matrix();
    return result;
  }

  Eigen::MatrixXd stated() const {
    SampleDerivatives d(static_cast<int>(strains()), static_cast<int>(history()),
                        static_cast<int>(parameters()));
    law_.differentiate(state_.samples(), time_, lane_, 0, 0, d);
    const Response response = response_of(law_, state_, time_);
    Eigen::MatrixXd tangent(strains(), strains());
    for (int k = 0; k < tangent.size(); ++k) {
      tangent(k / strains(), k % strains()) = response.tangent(lane_, k);
    }
    Eigen::MatrixXd jacobian(energies() + strains() + history(),
                             2 * strains() + history() + parameters());
    if (energies() > 0) {
      jacobian.row(0).setZero();
      jacobian.row(0).head(strains()) = response.stress.row(lane_).matrix();
      jacobian.row(0).tail(parameters()) = d.stored_by_parameter.transpose();
    }
    jacobian.bottomRows(strains() + history()) << tangent, d.stress_by_last, d.stress_by_history,
        d.stress_by_parameter, d.next_by_strain, d.next_by_last, d.next_by_history,
        d.next_by_parameter;
    return jacobian;
  }

 private:
  Eigen::Index energies() const { return history() == 0 ? 1 : 0; }
  Eigen::Index strains() const { return state_.strain.cols(); }
  Eigen::Index history() const { return law_.history_size(); }
  Eigen::Index parameters() const { return law_.parameters().size(); }

  const ParametricDensity& law_;
  LaneState state_;
  int lane_;
  double strain_scale_;
  StepTime time_;
};

}  // namespace pliant::test
