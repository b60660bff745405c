// How the forces and the history of volumes around nodes depend on the parameters of their law.

#include <algorithm>

#include "pliant/mechanics/nodal_dilatation.h"

namespace pliant {

std::vector<int> NodalDilatation::columns_of_parameters(const std::vector<int>& by) const {
  std::vector<int> columns;
  for (const int place : parameter_places_) {
    const auto found = std::ranges::find(by, place);
    columns.push_back(found == by.end() ? -1 : static_cast<int>(found - by.begin()));
  }
  return columns;
}

void NodalDilatation::add_force_sensitivity(
    const Evaluation& at, const std::vector<int>& by,
    const Eigen::Ref<const Eigen::MatrixXd>& history_by_parameter,
    Eigen::MatrixXd& gradient_by_parameter) const {
  const int own = density_->history_size();
  const std::vector<int> own_columns = columns_of_parameters(by);
  const bool has_own = std::ranges::any_of(own_columns, [](int column) { return column >= 0; });
  if (own == 0 && !has_own) return;
  const Eigen::VectorXd strains = this->strains(at.configuration.positions);
  const std::vector<Gradient> gradients = volume_gradients(at.configuration.positions);
  Eigen::MatrixXd pressures = Eigen::MatrixXd::Zero(strains.size(), history_by_parameter.cols());
  for (Eigen::Index p = 0; p < rest_volumes_.size(); ++p) {
    const auto batch = static_cast<int>(p / kLanes), lane = static_cast<int>(p % kLanes);
    const LaneStrains strain = strains.segment<kLanes>(kLanes * batch).array();
    SampleDerivatives d(1, own, static_cast<int>(own_columns.size()));
    law_at(at).differentiate(samples(batch, strain, at.history), at.time, lane, 0, 0, d);
    for (Eigen::Index k = 0; k < pressures.cols(); ++k) {
      const LaneView history(
          history_by_parameter.col(k).data() + Eigen::Index(kLanes) * columns() * batch, kLanes,
          columns());
      pressures(p, k) = d.stress_by_last(0, 0) * history(lane, 0);
      for (int i = 0; i < own; ++i) {
        pressures(p, k) += d.stress_by_history(0, i) * history(lane, 2 + i);
      }
    }
    for (size_t j = 0; j < own_columns.size(); ++j) {
      if (own_columns[j] < 0) continue;
      pressures(p, own_columns[j]) += d.stress_by_parameter(0, static_cast<Eigen::Index>(j));
    }
  }
  for (Eigen::Index k = 0; k < pressures.cols(); ++k) {
    add_forces(gradients, pressures.col(k), gradient_by_parameter.col(k).data());
  }
}

void NodalDilatation::advance_sensitivity(const Evaluation& at, const std::vector<int>& by,
                                          const Eigen::MatrixXd& positions_by_parameter,
                                          Eigen::Ref<Eigen::MatrixXd> history_by_parameter) const {
  const int own = density_->history_size();
  if (own == 0) return;
  const std::vector<int> own_columns = columns_of_parameters(by);
  const Eigen::VectorXd strains = this->strains(at.configuration.positions);
  const std::vector<Gradient> gradients = volume_gradients(at.configuration.positions);
  for (Eigen::Index p = 0; p < rest_volumes_.size(); ++p) {
    const auto batch = static_cast<int>(p / kLanes), lane = static_cast<int>(p % kLanes);
    const LaneStrains strain = strains.segment<kLanes>(kLanes * batch).array();
    SampleDerivatives d(1, own, static_cast<int>(own_columns.size()));
    law_at(at).differentiate(samples(batch, strain, at.history), at.time, lane, 0, 0, d);
    const Patch& patch = patches_[static_cast<size_t>(p)];
    const Eigen::Matrix3Xd gradient = patch_gradient(patch, gradients) / rest_volumes_(p);
    for (Eigen::Index k = 0; k < history_by_parameter.cols(); ++k) {
      MutableLaneView history(
          history_by_parameter.col(k).data() + Eigen::Index(kLanes) * columns() * batch, kLanes,
          columns());
      const Eigen::Map<const Eigen::Matrix3Xd> motion(positions_by_parameter.col(k).data(), 3,
                                                      positions_by_parameter.rows() / 3);
      const double change = gradient.cwiseProduct(motion(Eigen::all, patch.points)).sum();
      const double last = history(lane, 0);
      const Eigen::VectorXd before = history.row(lane).tail(own).matrix().transpose();
      Eigen::VectorXd next = d.next_by_strain.col(0) * change + d.next_by_last.col(0) * last +
                             d.next_by_history * before;
      for (size_t j = 0; j < own_columns.size(); ++j) {
        if (own_columns[j] == k) next += d.next_by_parameter.col(static_cast<Eigen::Index>(j));
      }
      history(lane, 0) = change;
      history(lane, 1) = last;
      history.row(lane).tail(own) = next.transpose().array();
    }
  }
}

}  // namespace pliant
