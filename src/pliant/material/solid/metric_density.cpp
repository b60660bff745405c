#include "pliant/material/solid/metric_density.h"

namespace pliant {
namespace {

/// What the law of one strain sees: the scalar now, at the last step and before it.
class MetricSamples {
 public:
  MetricSamples(const StrainMetric& metric, const Samples& samples)
      : now(metric.jet(samples.strain)),
        last(metric.jet(samples.last)),
        before_(metric.jet(samples.before).value),
        history_(samples.history) {}

  Samples samples() const { return {view(now.value), view(last.value), view(before_), history_}; }

  MetricJet now, last;

 private:
  static LaneView view(const Lane& lane) { return LaneView(lane.data(), kLanes, 1); }

  Lane before_;
  LaneView history_;
};

}  // namespace

MetricDensity::MetricDensity(const StrainMetric& metric,
                             std::shared_ptr<const ParametricDensity> law)
    : metric_(&metric), law_(std::move(law)) {}

void MetricDensity::add(const Samples& samples, const StepTime& time, Response& response) const {
  const MetricSamples own(*metric_, samples);
  Response inner(1);
  law_->add(own.samples(), time, inner);
  const Lane stress = inner.stress.col(0), tangent = inner.tangent.col(0);
  response.stored += inner.stored;
  response.work += inner.work;
  const MetricJet& jet = own.now;
  for (int i = 0; i < kSolidStrains; ++i) {
    response.stress.col(i) += stress * jet.gradient.col(i);
    for (int j = i; j < kSolidStrains; ++j) {
      const Lane second = tangent * jet.gradient.col(i) * jet.gradient.col(j) +
                          stress * jet.hessian.col(kSolidStrains * i + j);
      response.tangent.col(kSolidStrains * i + j) += second;
      if (j != i) response.tangent.col(kSolidStrains * j + i) += second;
    }
  }
}

void MetricDensity::add_stored(const Samples& samples, Lane& stored) const {
  const MetricSamples own(*metric_, samples);
  law_->add_stored(own.samples(), stored);
}

void MetricDensity::advance(const Samples& samples, const StepTime& time, MutableLaneView next,
                            Lane& work) const {
  const MetricSamples own(*metric_, samples);
  law_->advance(own.samples(), time, next, work);
}

std::unique_ptr<ParametricDensity> MetricDensity::with_parameters(
    const Eigen::VectorXd& values) const {
  return std::make_unique<MetricDensity>(*metric_, law_->with_parameters(values));
}

void MetricDensity::differentiate(const Samples& samples, int lane, int first_history,
                                  int first_parameter, SampleDerivatives& derivatives) const {
  const MetricSamples own(*metric_, samples);
  const auto history = history_size(), count = static_cast<int>(parameters().size());
  SampleDerivatives inner(1, history, count);
  law_->differentiate(own.samples(), lane, 0, 0, inner);
  const Eigen::VectorXd now = own.now.gradient.row(lane).transpose().matrix();
  const Eigen::RowVectorXd last = own.last.gradient.row(lane).matrix();
  derivatives.stress_by_last += now * inner.stress_by_last(0, 0) * last;
  derivatives.stress_by_history.middleCols(first_history, history) += now * inner.stress_by_history;
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

}  // namespace pliant
