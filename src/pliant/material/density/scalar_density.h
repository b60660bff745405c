#pragma once

#include <memory>
#include <utility>

#include "pliant/material/density/density.h"

namespace pliant {

/// A law of one strain on a scalar of the strains of a material point: with the scalar's gradient g
/// and Hessian H the stress is psi' g and the tangent psi'' g g^T + psi' H. What the law of one
/// strain remembers, the point remembers.
///
/// `Scalar::jet` gives value, gradient (a column a strain) and Hessian (column i strains + j) at
/// eight points; one that is linear in the strains has no Hessian.
template <class Scalar>
class ScalarDensity : public ParametricDensity {
 public:
  /// @param law  of one strain
  ScalarDensity(Scalar scalar, std::shared_ptr<const ParametricDensity> law)
      : scalar_(std::move(scalar)), law_(std::move(law)) {}

  int history_size() const override { return law_->history_size(); }

  void add(const Samples& samples, const StepTime& time, Response& response) const override {
    const Own own(scalar_, samples);
    Response inner(1);
    law_->add(own.samples(), time, inner);
    const Lane stress = inner.stress.col(0), tangent = inner.tangent.col(0);
    response.stored += inner.stored;
    response.work += inner.work;
    const Eigen::Index strains = samples.strain.cols();
    for (Eigen::Index i = 0; i < strains; ++i) {
      response.stress.col(i) += stress * own.now.gradient.col(i);
      for (Eigen::Index j = i; j < strains; ++j) {
        Lane second = tangent * own.now.gradient.col(i) * own.now.gradient.col(j);
        if constexpr (requires { own.now.hessian; }) {
          second += stress * own.now.hessian.col(strains * i + j);
        }
        response.tangent.col(strains * i + j) += second;
        if (j != i) response.tangent.col(strains * j + i) += second;
      }
    }
  }

  void add_stored(const Samples& samples, Lane& stored) const override {
    const Own own(scalar_, samples);
    law_->add_stored(own.samples(), stored);
  }

  void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
               Lane& work) const override {
    const Own own(scalar_, samples);
    law_->advance(own.samples(), time, next, work);
  }

  Eigen::VectorXd parameters() const override { return law_->parameters(); }
  bool is_linear() const override { return law_->is_linear(); }

  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& values) const override {
    return std::make_unique<ScalarDensity>(scalar_, law_->with_parameters(values));
  }

  void differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                     int first_parameter, SampleDerivatives& derivatives) const override {
    const Own own(scalar_, samples);
    const auto history = history_size(), count = static_cast<int>(parameters().size());
    SampleDerivatives inner(1, history, count);
    law_->differentiate(own.samples(), time, lane, 0, 0, inner);
    const Eigen::VectorXd now = own.now.gradient.row(lane).transpose().matrix();
    const Eigen::RowVectorXd last = own.last.gradient.row(lane).matrix();
    derivatives.stored_by_parameter.segment(first_parameter, count) += inner.stored_by_parameter;
    derivatives.stress_by_last += now * inner.stress_by_last(0, 0) * last;
    derivatives.stress_by_history.middleCols(first_history, history) +=
        now * inner.stress_by_history;
    derivatives.stress_by_parameter.middleCols(first_parameter, count) +=
        now * inner.stress_by_parameter;
    derivatives.next_by_strain.middleRows(first_history, history) +=
        inner.next_by_strain * now.transpose();
    derivatives.next_by_last.middleRows(first_history, history) += inner.next_by_last * last;
    derivatives.next_by_history.block(first_history, first_history, history, history) +=
        inner.next_by_history;
    derivatives.next_by_parameter.block(first_history, first_parameter, history, count) +=
        inner.next_by_parameter;
  }

 private:
  /// What the law of one strain sees: the scalar now, at the last step and before it.
  struct Own {
    Own(const Scalar& scalar, const Samples& samples)
        : now(scalar.jet(samples.strain)),
          last(scalar.jet(samples.last)),
          before(scalar.jet(samples.before).value),
          history(samples.history),
          weights(samples.weights) {}

    Samples samples() const {
      return {view(now.value), view(last.value), view(before), history, weights};
    }
    static LaneView view(const Lane& lane) { return LaneView(lane.data(), kLanes, 1); }

    decltype(std::declval<const Scalar&>().jet(std::declval<const LaneView&>())) now, last;
    Lane before;
    LaneView history, weights;
  };

  Scalar scalar_;
  std::shared_ptr<const ParametricDensity> law_;
};

}  // namespace pliant
