#include "pliant/estimation/estimating_equations.h"

#include <algorithm>

namespace pliant {

std::vector<char> told_of(const std::vector<std::vector<char>>& told, std::size_t part,
                          const std::vector<Eigen::Index>& free) {
  std::vector<char> own;
  if (told.empty()) return own;
  for (const Eigen::Index u : free) own.push_back(told[part][static_cast<std::size_t>(u)]);
  return own;
}

Eigen::VectorXd units_of(const std::vector<Unknown>& unknowns,
                         const std::vector<Eigen::Index>& free) {
  Eigen::VectorXd unit(static_cast<Eigen::Index>(free.size()));
  for (std::size_t i = 0; i < free.size(); ++i) {
    unit(static_cast<Eigen::Index>(i)) = unknowns[static_cast<std::size_t>(free[i])].scale;
  }
  return unit;
}

EstimatingSums estimating_sums(const Problem& problem, const std::vector<PredictedRows>& rows,
                               const std::vector<Eigen::VectorXd>& weight,
                               const std::vector<Eigen::Index>& free,
                               const std::vector<std::vector<char>>& told) {
  EstimatingSums sums;
  for (std::size_t p = 0; p < rows.size(); ++p) {
    const Experiment& experiment = *problem.parts()[p].experiment;
    const Eigen::VectorXd residual = weight[p].cwiseProduct(rows[p].value - experiment.measured());
    const Eigen::MatrixXd jacobian =
        weight[p].asDiagonal() * Eigen::MatrixXd(rows[p].by(Eigen::all, free));
    const std::vector<char> own = told_of(told, p, free);
    for (const Frame& frame : experiment.frames()) {
      sums.groups.push_back(group_sum(static_cast<int>(p),
                                      jacobian.middleRows(frame.first, frame.count),
                                      residual.segment(frame.first, frame.count), own));
    }
  }
  const auto n = static_cast<Eigen::Index>(free.size());
  sums.priors.setZero(n, n);
  for (const SumPrior& prior : problem.priors()) {
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(n);
    for (const auto& [unknown, factor] : prior.sum) {
      const auto at = std::ranges::find(free, unknown);
      if (at != free.end()) direction(at - free.begin()) += factor / prior.sd;
    }
    sums.priors += direction * direction.transpose();
  }
  return sums;
}

GroupLabels labels_of(const Problem& problem) {
  GroupLabels labels;
  int cycle = -1, specimen = -1;
  for (const ProblemPart& part : problem.parts()) {
    int last = -1, frames = 0;
    for (const Frame& frame : part.experiment->frames()) {
      if (frame.specimen != last) {
        last = frame.specimen;
        ++specimen;
        frames = 0;
      }
      if (frames++ % 2 == 0) ++cycle;
      labels.cycle.push_back(cycle);
      labels.specimen.push_back(specimen);
    }
  }
  return labels;
}

}  // namespace pliant
