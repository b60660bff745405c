#include "pliant/material/density/sum.h"

#include <new>

namespace pliant {
namespace {

constexpr Eigen::Index kColumn = kLanes;  // numbers of one column of a history

}  // namespace

void Sum::add_addend(std::unique_ptr<Density> addend) {
  Addend entry{std::move(addend), nullptr, history_size_, parameter_count_, 0};
  entry.parametric = dynamic_cast<ParametricDensity*>(entry.density.get());
  if (entry.parametric) {
    entry.parameter_count = static_cast<int>(entry.parametric->parameters().size());
  }
  history_size_ += entry.density->history_size();
  parameter_count_ += entry.parameter_count;
  addends_.push_back(std::move(entry));
}

void Sum::add(const Samples& samples, const StepTime& time, Response& response) const {
  Samples own = samples;
  for (const Addend& addend : addends_) {
    new (&own.history) LaneHistory(samples.history.data() + kColumn * addend.first_history, kLanes,
                                   addend.density->history_size());
    addend.density->add(own, time, response);
  }
}

void Sum::advance(const Samples& samples, const StepTime& time, MutableLaneHistory next,
                  Lane& work) const {
  Samples own = samples;
  for (const Addend& addend : addends_) {
    const int size = addend.density->history_size();
    const Eigen::Index first = kColumn * addend.first_history;
    new (&own.history) LaneHistory(samples.history.data() + first, kLanes, size);
    addend.density->advance(own, time, MutableLaneHistory(next.data() + first, kLanes, size), work);
  }
}

Eigen::VectorXd Sum::parameters() const {
  Eigen::VectorXd values(parameter_count_);
  for (const Addend& addend : addends_) {
    if (!addend.parametric) continue;
    values.segment(addend.first_parameter, addend.parameter_count) =
        addend.parametric->parameters();
  }
  return values;
}

void Sum::set_parameters(const Eigen::VectorXd& values) {
  for (const Addend& addend : addends_) {
    if (!addend.parametric) continue;
    addend.parametric->set_parameters(
        values.segment(addend.first_parameter, addend.parameter_count));
  }
}

void Sum::differentiate(const Samples& samples, int lane, int first_history, int first_parameter,
                        SampleDerivatives& derivatives) const {
  Samples own = samples;
  for (const Addend& addend : addends_) {
    if (!addend.parametric) continue;
    new (&own.history) LaneHistory(samples.history.data() + kColumn * addend.first_history, kLanes,
                                   addend.density->history_size());
    addend.parametric->differentiate(own, lane, first_history + addend.first_history,
                                     first_parameter + addend.first_parameter, derivatives);
  }
}

}  // namespace pliant
