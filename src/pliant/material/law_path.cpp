#include "pliant/material/law_path.h"

#include <utility>

namespace pliant {
namespace {

/// Without times all has come to rest.
double seconds_between(double before, double now) { return now == kEndless ? now : now - before; }

}  // namespace

LawPath::LawPath(const ComponentLaw& law, PathPoint start, double time)
    : law_(law), start_(std::move(start)), row_{start_.strain, start_.strain_gradient, time} {
  Eigen::Index numbers = 0;
  for (const Addend& addend : law_.addends) numbers += addend.history_size();
  if (numbers == 0 || start_.history.size() > 0) return;
  start_.history = Eigen::VectorXd::Zero(numbers);
  start_.history_gradient = Eigen::MatrixXd::Zero(numbers, start_.strain_gradient.size());
}

LawPath::Moment LawPath::last_moment(const Addend& addend) const {
  return addend.flows() ? row_ : Moment{start_.strain, start_.strain_gradient, row_.time};
}

double LawPath::stress_at(double strain, double time) const {
  const FrictionStress friction = law_.friction_stress(strain, {start_.strain, start_.friction});
  double stress = law_.elastic_stress(strain) + friction.stress;
  if (start_.history.size() == 0) return stress;
  Eigen::Index first = 0;
  for (const Addend& addend : law_.addends) {
    if (addend.is_elastic()) continue;
    const Eigen::VectorXd history = start_.history.segment(first, addend.history_size());
    const double last = addend.flows() ? row_.strain : start_.strain;
    stress += addend.at(strain, last, history, seconds_between(row_.time, time)).stress;
    first += addend.history_size();
  }
  return stress;
}

PathStress LawPath::at(double strain, double time) const {
  const FrictionStress friction = law_.friction_stress(strain, {start_.strain, start_.friction});
  PathStress result;
  result.friction = friction.stress;
  result.friction_slope = friction.slope;
  result.stress = law_.elastic_stress(strain) + friction.stress;
  result.slope = law_.elastic_tangent(strain) + friction.slope;
  if (with_gradients()) {
    result.friction_gradient = friction.from_strain * start_.strain_gradient +
                               friction.from_stress * start_.friction_gradient;
    const int stiffness = law_.stiffness.size();
    for (int i = 0; i < law_.friction_count(); ++i) {
      result.friction_gradient(stiffness + i) += friction.parameters[static_cast<size_t>(i)];
    }
    result.gradient = result.friction_gradient;
    law_.add_elastic_gradient(strain, result.gradient);
  }
  if (start_.history.size() > 0) add_memory(strain, time, result);
  return result;
}

// Adds the stress of the addends that remember.
void LawPath::add_memory(double strain, double time, PathStress& result) const {
  Eigen::Index first = 0, parameter = law_.first_addend_parameter();
  for (const Addend& addend : law_.addends) {
    const Eigen::Index numbers = addend.history_size();
    if (numbers > 0) {
      const Eigen::VectorXd history = start_.history.segment(first, numbers);
      const Moment last = last_moment(addend);
      const double seconds = seconds_between(last.time, time);
      const Addend::Answer answer = addend.at(strain, last.strain, history, seconds);
      result.stress += answer.stress;
      result.slope += answer.tangent;
      if (with_gradients()) {
        const SampleDerivatives by = addend.derivatives(strain, last.strain, history, seconds);
        result.gradient +=
            by.stress_by_last(0, 0) * last.strain_gradient +
            (by.stress_by_history * start_.history_gradient.middleRows(first, numbers)).transpose();
        result.gradient.segment(parameter, addend.size()) += by.stress_by_parameter.transpose();
      }
    }
    first += numbers;
    parameter += addend.size();
  }
}

// The history that a turn leaves, or a row of what flows.
void LawPath::advance_memory(bool of_flow, double strain, const Eigen::VectorXd& strain_gradient,
                             double time) {
  Eigen::Index first = 0, parameter = law_.first_addend_parameter();
  for (const Addend& addend : law_.addends) {
    const Eigen::Index numbers = addend.history_size();
    if (numbers > 0 && addend.flows() == of_flow) {
      const Moment last = last_moment(addend);
      const double seconds = seconds_between(last.time, time);
      const Eigen::VectorXd history = start_.history.segment(first, numbers);
      if (with_gradients()) {
        const SampleDerivatives by = addend.derivatives(strain, last.strain, history, seconds);
        Eigen::MatrixXd next =
            by.next_by_strain * strain_gradient.transpose() +
            by.next_by_last * last.strain_gradient.transpose() +
            by.next_by_history * start_.history_gradient.middleRows(first, numbers);
        next.middleCols(parameter, addend.size()) += by.next_by_parameter;
        start_.history_gradient.middleRows(first, numbers) = next;
      }
      start_.history.segment(first, numbers) =
          addend.advanced(strain, last.strain, history, seconds);
    }
    first += numbers;
    parameter += addend.size();
  }
}

void LawPath::pass(double strain, const Eigen::VectorXd& strain_gradient, double time) {
  if (!law_.flows()) return;
  advance_memory(/*of_flow=*/true, strain, strain_gradient, time);
  row_ = {strain, strain_gradient, time};
}

void LawPath::turn_at(double strain, const Eigen::VectorXd& strain_gradient) {
  const PathStress here = at(strain);
  if (start_.history.size() > 0) {
    advance_memory(/*of_flow=*/false, strain, strain_gradient, row_.time);
  }
  if (with_gradients()) {
    start_.friction_gradient = here.friction_gradient + here.friction_slope * strain_gradient;
    start_.strain_gradient = strain_gradient;
  }
  start_.strain = strain;
  start_.friction = here.friction;
}

}  // namespace pliant
