#include "pliant/material/density/blended_density.h"

#include <algorithm>
#include <utility>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

void add_times(const Lane& factor, const Response& own, Response& response) {
  response.stored += factor * own.stored;
  response.work += factor * own.work;
  response.stress += own.stress.colwise() * factor;
  response.tangent += own.tangent.colwise() * factor;
}

}  // namespace

BlendedDensity::BlendedDensity(Laws laws, bool alike) : laws_(std::move(laws)), alike_(alike) {
  PLIANT_ASSERT(!laws_.empty(), "a heterogeneous material has at least one sample");
  for (const auto& law : laws_) {
    PLIANT_ASSERT(law->history_size() == 0, "what is blended remembers nothing");
    first_.push_back(first_.back() + law->parameters().size());
  }
  linear_ = alike && std::ranges::all_of(laws_, [](const auto& law) { return law->is_linear(); });
  if (!linear_) return;
  const Eigen::Index numbers = first_[1];
  const Eigen::VectorXd all = parameters();
  values_ = all.reshaped(numbers, std::ssize(laws_)).transpose();
  for (Eigen::Index p = 0; p < numbers; ++p) {
    units_.push_back(laws_.front()->with_parameters(Eigen::VectorXd::Unit(numbers, p)));
  }
}

void BlendedDensity::add(const Samples& samples, const StepTime& time, Response& response) const {
  const auto strains = static_cast<int>(samples.strain.cols());
  const Laws& parts = linear_ ? units_ : laws_;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto place = static_cast<Eigen::Index>(i);
    const Lane factor = linear_ ? Lane((samples.weights.matrix() * values_.col(place)).array())
                                : Lane(samples.weights.col(place));
    if ((factor == 0).all()) continue;
    Response own(strains);
    parts[i]->add(samples, time, own);
    add_times(factor, own, response);
  }
}

Eigen::VectorXd BlendedDensity::parameters() const {
  Eigen::VectorXd all(first_.back());
  for (std::size_t k = 0; k < laws_.size(); ++k) {
    all.segment(first_[k], first_[k + 1] - first_[k]) = laws_[k]->parameters();
  }
  return all;
}

std::unique_ptr<ParametricDensity> BlendedDensity::with_parameters(
    const Eigen::VectorXd& values) const {
  Laws laws;
  for (std::size_t k = 0; k < laws_.size(); ++k) {
    laws.push_back(laws_[k]->with_parameters(values.segment(first_[k], first_[k + 1] - first_[k])));
  }
  return std::make_unique<BlendedDensity>(std::move(laws), alike_);
}

void BlendedDensity::differentiate(const Samples& samples, const StepTime& time, int lane, int,
                                   int first_parameter, SampleDerivatives& derivatives) const {
  const auto strains = static_cast<int>(samples.strain.cols());
  const auto derivatives_of = [&](std::size_t k) {
    SampleDerivatives own(strains, 0, static_cast<int>(first_[k + 1] - first_[k]));
    laws_[k]->differentiate(samples, time, lane, 0, 0, own);
    return own;
  };
  SampleDerivatives own = derivatives_of(0);  // of laws that are linear, those of all samples
  for (std::size_t k = 0; k < laws_.size(); ++k) {
    const double weight = samples.weights(lane, static_cast<Eigen::Index>(k));
    if (weight == 0) continue;
    if (!linear_) own = derivatives_of(k);
    const Eigen::Index first = first_parameter + first_[k], count = first_[k + 1] - first_[k];
    derivatives.stored_by_parameter.segment(first, count) += weight * own.stored_by_parameter;
    derivatives.stress_by_parameter.middleCols(first, count) += weight * own.stress_by_parameter;
  }
}

}  // namespace pliant
