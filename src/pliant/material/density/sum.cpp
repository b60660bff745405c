#include "pliant/material/density/sum.h"

#include <algorithm>

namespace pliant {

void Sum::add_addend(std::shared_ptr<const Density> addend) {
  Addend entry;
  entry.density = std::move(addend);
  entry.parametric = dynamic_cast<const ParametricDensity*>(entry.density.get());
  entry.first_history = history_size_;
  entry.history_size = entry.density->history_size();
  entry.first_parameter = parameter_count_;
  if (entry.parametric) {
    entry.parameter_count = static_cast<int>(entry.parametric->parameters().size());
  }
  history_size_ += entry.history_size;
  parameter_count_ += entry.parameter_count;
  addends_.push_back(std::move(entry));
}

void Sum::add(const Samples& samples, const StepTime& time, Response& response) const {
  for (const Addend& addend : addends_) {
    addend.density->add(own(addend, samples), time, response);
  }
}

bool Sum::is_limited() const {
  return std::ranges::any_of(addends_,
                             [](const Addend& addend) { return addend.density->is_limited(); });
}

void Sum::lower_to_share_left(const Samples& samples, Lane& left) const {
  for (const Addend& addend : addends_) {
    addend.density->lower_to_share_left(own(addend, samples), left);
  }
}

void Sum::add_stored(const Samples& samples, Lane& stored) const {
  for (const Addend& addend : addends_) addend.density->add_stored(own(addend, samples), stored);
}

void Sum::advance(const Samples& samples, const StepTime& time, MutableLaneView next,
                  Lane& work) const {
  for (const Addend& addend : addends_) {
    const MutableLaneView own_next(next.data() + kLanes * addend.first_history, kLanes,
                                   addend.history_size);
    addend.density->advance(own(addend, samples), time, own_next, work);
  }
}

bool Sum::is_linear() const {
  return std::ranges::all_of(addends_, [](const Addend& addend) {
    return addend.parametric && addend.parametric->is_linear();
  });
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

std::unique_ptr<ParametricDensity> Sum::with_parameters(const Eigen::VectorXd& values) const {
  auto other = std::make_unique<Sum>();
  for (const Addend& addend : addends_) {
    if (!addend.parametric) {
      other->add_addend(addend.density);
      continue;
    }
    other->add_addend(addend.parametric->with_parameters(
        values.segment(addend.first_parameter, addend.parameter_count)));
  }
  return other;
}

void Sum::differentiate(const Samples& samples, const StepTime& time, int lane, int first_history,
                        int first_parameter, SampleDerivatives& derivatives) const {
  for (const Addend& addend : addends_) {
    if (!addend.parametric) continue;
    addend.parametric->differentiate(own(addend, samples), time, lane,
                                     first_history + addend.first_history,
                                     first_parameter + addend.first_parameter, derivatives);
  }
}

}  // namespace pliant
