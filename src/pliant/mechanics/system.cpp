#include "pliant/mechanics/system.h"

#include <algorithm>
#include <numeric>

#include "pliant/base/assert.h"

namespace pliant {

System::System(Eigen::Matrix3Xd positions, Eigen::VectorXd masses)
    : masses_(std::move(masses)),
      coordinates_(static_cast<int>(positions.cols())),
      initial_{std::move(positions), {}} {
  PLIANT_ASSERT(masses_.size() == initial_.positions.cols(), "one mass for each point");
}

void System::add(std::shared_ptr<Potential> potential) {
  PLIANT_ASSERT(!pattern_, "a system is constant once finished");
  Part part{potential,
            dynamic_cast<const HistoryPotential*>(potential.get()),
            dynamic_cast<const ParametricPotential*>(potential.get()),
            parts_.size(),
            history_size_,
            0};
  if (part.with_history) part.history_size = part.with_history->history_size();
  history_size_ += part.history_size;
  parts_.push_back(std::move(part));
}

std::vector<int> System::add_parameters(const std::vector<std::string>& names,
                                        const Eigen::VectorXd& values) {
  PLIANT_ASSERT(!pattern_, "a system is constant once finished");
  std::vector<int> places(names.size());
  std::iota(places.begin(), places.end(), static_cast<int>(parameters_.names.size()));
  parameters_.names.insert(parameters_.names.end(), names.begin(), names.end());
  parameters_.values.insert(parameters_.values.end(), values.begin(), values.end());
  return places;
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

std::vector<int> System::all_parameters() const {
  std::vector<int> all(parameters_.names.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Parameters System::with(const Eigen::VectorXd& values) const {
  Parameters parameters;
  for (const Part& part : parts_) {
    parameters.laws.push_back(part.parametric ? part.parametric->law(values) : nullptr);
  }
  return parameters;
}

State System::initial_state(const Parameters& parameters) const {
  State state;
  state.configuration = initial_;
  state.velocities = Eigen::Matrix3Xd::Zero(3, points());
  state.history.resize(history_size_);
  for (const Part& part : parts_) {
    if (!part.with_history) continue;
    state.history.segment(part.first_history, part.history_size) =
        part.with_history->initial_history({initial_, nullptr, parameters.law(part.number)});
  }
  return state;
}

const double* System::history_of(const Potential& potential, const State& state) const {
  for (const Part& part : parts_) {
    if (part.potential.get() == &potential) return state.history.data() + part.first_history;
  }
  PLIANT_ASSERT(false, "the potential belongs to the system");
  return nullptr;
}

Hessian System::make_hessian(Precision precision) const {
  return {coordinates_, BlockMatrix(pattern_, precision)};
}

std::optional<Eigen::Matrix3Xd> System::made_way(const Eigen::Matrix3Xd& led,
                                                 const Conditions& under) const {
  Eigen::Matrix3Xd positions = led;
  for (const Part& part : parts_) {
    const Evaluation last = evaluation(part, under.from.configuration, under);
    if (!part.potential->make_way(last, positions)) return std::nullopt;
  }
  return positions - led;
}

bool System::obstructs() const {
  return std::ranges::any_of(parts_, [](const Part& part) { return part.potential->obstructs(); });
}

bool System::is_limited() const {
  return std::ranges::any_of(parts_, [](const Part& part) { return part.potential->is_limited(); });
}

double System::share_left(const Configuration& at, const Conditions& under) const {
  double left = 1;
  for (const Part& part : parts_) {
    left = std::min(left, part.potential->share_left(evaluation(part, at, under)));
  }
  return left;
}

WayLimits System::way_limits(const Configuration& from, const Configuration& to,
                             const Conditions& under, double kept) const {
  WayLimits limits{.shares = Eigen::VectorXd::Ones(points()), .kept = kept};
  for (const Part& part : parts_) {
    part.potential->limit(evaluation(part, from, under), to.positions, limits);
  }
  return limits;
}

double System::outside_work(const Configuration& at, const Conditions& under,
                            const Controls& before) const {
  double work = 0;
  for (const Part& part : parts_) {
    work +=
        part.potential->outside_work(evaluation(part, at, under), under.from.configuration, before);
  }
  return work;
}

void System::evaluate(const Configuration& at, const Conditions& under, Curvature curvature,
                      Derivatives& derivatives) const {
  for (const Part& part : parts_) {
    part.potential->evaluate(evaluation(part, at, under, curvature), derivatives);
  }
  if (derivatives.hessian) coordinates_.complete_diagonals(derivatives.hessian->matrix);
}

Energy System::advance_history(const Configuration& at, const Conditions& under,
                               Eigen::VectorXd& history) const {
  history.resize(history_size_);
  Derivatives of_others;
  Energy energy;
  for (const Part& part : parts_) {
    if (!part.with_history) {
      part.potential->evaluate(evaluation(part, at, under), of_others);
      continue;
    }
    energy += part.with_history->advance(evaluation(part, at, under),
                                         history.data() + part.first_history);
  }
  energy.stored += of_others.energy.stored;
  return energy;
}

void System::add_force_sensitivity(const Configuration& at, const Conditions& under,
                                   const std::vector<int>& by,
                                   const Eigen::MatrixXd& history_by_parameter,
                                   Eigen::MatrixXd& gradient_by_parameter) const {
  for (const Part& part : parts_) {
    if (!part.parametric) continue;
    part.parametric->add_force_sensitivity(
        evaluation(part, at, under), by,
        history_by_parameter.middleRows(part.first_history, part.history_size),
        gradient_by_parameter);
  }
}

void System::advance_sensitivity(const Configuration& at, const Conditions& under,
                                 const std::vector<int>& by,
                                 const Eigen::MatrixXd& positions_by_parameter,
                                 Eigen::MatrixXd& history_by_parameter) const {
  for (const Part& part : parts_) {
    if (!part.parametric) continue;
    part.parametric->advance_sensitivity(
        evaluation(part, at, under), by, positions_by_parameter,
        history_by_parameter.middleRows(part.first_history, part.history_size));
  }
}

}  // namespace pliant
