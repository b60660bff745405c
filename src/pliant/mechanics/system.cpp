#include "pliant/mechanics/system.h"

#include "pliant/base/assert.h"

namespace pliant {

System::System(Eigen::Matrix3Xd positions, Eigen::VectorXd masses)
    : masses_(std::move(masses)),
      coordinates_(static_cast<int>(positions.cols())),
      initial_{std::move(positions), {}} {
  PLIANT_ASSERT(masses_.size() == initial_.positions.cols(), "one mass for each point");
}

void System::add(std::shared_ptr<Potential> potential) {
  Part part{potential, dynamic_cast<const HistoryPotential*>(potential.get()),
            dynamic_cast<ParametricPotential*>(potential.get()), history_size_, 0};
  if (part.with_history) part.history_size = part.with_history->history_size();
  history_size_ += part.history_size;
  parts_.push_back(std::move(part));
}

void System::finish() {
  coordinates_.number();
  initial_ = coordinates_.initial_configuration(initial_.positions);
  std::vector<std::pair<int, int>> couplings;
  for (const Part& part : parts_) {
    const auto pairs = part.potential->couplings();
    couplings.insert(couplings.end(), pairs.begin(), pairs.end());
  }
  pattern_ = coordinates_.pattern(couplings);
  for (const Part& part : parts_) part.potential->bind(coordinates_, *pattern_);
}

State System::initial_state() const {
  State state;
  state.configuration = initial_;
  state.velocities = Eigen::Matrix3Xd::Zero(3, points());
  state.history.resize(history_size_);
  for (const Part& part : parts_) {
    if (!part.with_history) continue;
    state.history.segment(part.first_history, part.history_size) =
        part.with_history->initial_history(initial_);
  }
  return state;
}

void System::drive(double time, Configuration& configuration) const {
  for (const Drive& drive : drives_) drive(time, configuration);
}

const double* System::history_of(const Potential& potential, const State& state) const {
  for (const Part& part : parts_) {
    if (part.potential.get() == &potential) return state.history.data() + part.first_history;
  }
  PLIANT_ASSERT(false, "the potential belongs to the system");
  return nullptr;
}

Hessian System::make_hessian() const { return {coordinates_, BlockMatrix(pattern_)}; }

void System::evaluate(const Configuration& at, const State& from, const StepTime& time,
                      Curvature curvature, Derivatives& derivatives) const {
  for (const Part& part : parts_) {
    part.potential->evaluate(evaluation(part, at, from, time, curvature), derivatives);
  }
}

double System::advance_history(const Configuration& at, const State& from, const StepTime& time,
                               Eigen::VectorXd& history) const {
  history.resize(history_size_);
  double work = 0;
  for (const Part& part : parts_) {
    if (!part.with_history) continue;
    work += part.with_history->advance(evaluation(part, at, from, time, Curvature::exact),
                                       history.data() + part.first_history);
  }
  return work;
}

void System::set_parameters(const Eigen::VectorXd& values) {
  for (const Part& part : parts_) {
    if (part.parametric) part.parametric->set_parameters(values);
  }
}

void System::set_parameter_count(int count) {
  parameter_count_ = count;
  derivative_count_ = count;
}

void System::differentiate_by(const std::vector<int>& parameters) {
  std::vector<int> column_of(static_cast<size_t>(parameter_count_), -1);
  derivative_count_ = static_cast<int>(parameters.size());
  for (int k = 0; k < derivative_count_; ++k) {
    column_of[static_cast<size_t>(parameters[static_cast<size_t>(k)])] = k;
  }
  for (const Part& part : parts_) {
    if (part.parametric) part.parametric->differentiate_by(column_of);
  }
}

void System::add_force_sensitivity(const Configuration& at, const State& from,
                                   const Eigen::MatrixXd& history_by_parameter,
                                   Eigen::MatrixXd& gradient_by_parameter) const {
  for (const Part& part : parts_) {
    if (!part.parametric) continue;
    part.parametric->add_force_sensitivity(
        evaluation(part, at, from, {}, Curvature::exact),
        history_by_parameter.middleRows(part.first_history, part.history_size),
        gradient_by_parameter);
  }
}

void System::advance_sensitivity(const Configuration& at, const State& from,
                                 const Eigen::MatrixXd& positions_by_parameter,
                                 Eigen::MatrixXd& history_by_parameter) const {
  for (const Part& part : parts_) {
    if (!part.parametric) continue;
    Eigen::MatrixXd own = history_by_parameter.middleRows(part.first_history, part.history_size);
    part.parametric->advance_sensitivity(evaluation(part, at, from, {}, Curvature::exact),
                                         positions_by_parameter, own);
    history_by_parameter.middleRows(part.first_history, part.history_size) = own;
  }
}

}  // namespace pliant
