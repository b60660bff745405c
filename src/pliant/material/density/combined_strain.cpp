#include "pliant/material/density/combined_strain.h"

namespace pliant {
namespace {

/// What the law of one strain sees: the sum now, at the last step and before it.
class CombinedSamples {
 public:
  CombinedSamples(const Eigen::VectorXd& weights, const Samples& samples)
      : now_(sum(weights, samples.strain)),
        last_(sum(weights, samples.last)),
        before_(sum(weights, samples.before)),
        history_(samples.history) {}

  Samples samples() const { return {view(now_), view(last_), view(before_), history_}; }

 private:
  static Lane sum(const Eigen::VectorXd& weights, const LaneView& strain) {
    Lane result = Lane::Zero();
    for (Eigen::Index i = 0; i < weights.size(); ++i) result += weights(i) * strain.col(i);
    return result;
  }
  static LaneView view(const Lane& lane) { return LaneView(lane.data(), kLanes, 1); }

  Lane now_, last_, before_;
  LaneView history_;
};

}  // namespace

CombinedStrain::CombinedStrain(Eigen::VectorXd weights,
                               std::shared_ptr<const ParametricDensity> law)
    : weights_(std::move(weights)), law_(std::move(law)) {}

void CombinedStrain::add(const Samples& samples, const StepTime& time, Response& response) const {
  const CombinedSamples own(weights_, samples);
  Response inner(1);
  law_->add(own.samples(), time, inner);
  response.stored += inner.stored;
  response.work += inner.work;
  const Eigen::Index strains = weights_.size();
  for (Eigen::Index i = 0; i < strains; ++i) {
    if (weights_(i) == 0) continue;
    response.stress.col(i) += weights_(i) * inner.stress.col(0);
    for (Eigen::Index j = 0; j < strains; ++j) {
      if (weights_(j) == 0) continue;
      response.tangent.col(strains * i + j) += weights_(i) * weights_(j) * inner.tangent.col(0);
    }
  }
}

void CombinedStrain::add_stored(const Samples& samples, Lane& stored) const {
  const CombinedSamples own(weights_, samples);
  law_->add_stored(own.samples(), stored);
}

void CombinedStrain::advance(const Samples& samples, const StepTime& time, MutableLaneView next,
                             Lane& work) const {
  const CombinedSamples own(weights_, samples);
  law_->advance(own.samples(), time, next, work);
}

std::unique_ptr<ParametricDensity> CombinedStrain::with_parameters(
    const Eigen::VectorXd& values) const {
  return std::make_unique<CombinedStrain>(weights_, law_->with_parameters(values));
}

void CombinedStrain::differentiate(const Samples& samples, int lane, int first_history,
                                   int first_parameter, SampleDerivatives& derivatives) const {
  const CombinedSamples own(weights_, samples);
  const auto history = history_size(), count = static_cast<int>(parameters().size());
  SampleDerivatives inner(1, history, count);
  law_->differentiate(own.samples(), lane, 0, 0, inner);
  const Eigen::RowVectorXd across = weights_.transpose();
  derivatives.stress_by_last += weights_ * inner.stress_by_last(0, 0) * across;
  derivatives.stress_by_history.middleCols(first_history, history) +=
      weights_ * inner.stress_by_history;
  derivatives.stress_by_parameter.middleCols(first_parameter, count) +=
      weights_ * inner.stress_by_parameter;
  derivatives.next_by_strain.middleRows(first_history, history) += inner.next_by_strain * across;
  derivatives.next_by_last.middleRows(first_history, history) += inner.next_by_last * across;
  derivatives.next_by_history.block(first_history, first_history, history, history) +=
      inner.next_by_history;
  derivatives.next_by_parameter.block(first_history, first_parameter, history, count) +=
      inner.next_by_parameter;
}

}  // namespace pliant
