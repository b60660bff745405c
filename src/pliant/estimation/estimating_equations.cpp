#include "pliant/estimation/estimating_equations.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace pliant {
namespace {

/// Adds up J^T W J and J^T W r of the frames of a part.
class SummedFrames : public FrameSink {
 public:
  SummedFrames(int part, const Experiment& experiment, const Eigen::VectorXd& weight,
               const Eigen::VectorXd& scatter, const std::vector<Eigen::Index>& free,
               std::vector<char> told)
      : part_(part),
        experiment_(experiment),
        frames_(experiment.frames()),
        weight_(weight),
        scatter_(scatter),
        free_(free),
        told_(std::move(told)),
        sums_(frames_.size()) {}

  void take(int frame, const PredictedFrame& rows) override {
    const auto index = static_cast<std::size_t>(frame);
    const Frame& at = frames_[index];
    const auto weight = weight_.segment(at.first, at.count);
    const Eigen::VectorXd residual =
        weight.cwiseProduct(rows.value - experiment_.measured().segment(at.first, at.count));
    const Eigen::MatrixXd jacobian =
        weight.asDiagonal() * Eigen::MatrixXd(rows.by(Eigen::all, free_));
    sums_[index] =
        group_sum(part_, jacobian, residual, scatter_.segment(at.first, at.count), told_);
  }

  std::vector<GroupSum> sums() && { return std::move(sums_); }

 private:
  int part_;
  const Experiment& experiment_;
  std::vector<Frame> frames_;
  const Eigen::VectorXd &weight_, &scatter_;
  const std::vector<Eigen::Index>& free_;
  std::vector<char> told_;
  std::vector<GroupSum> sums_;
};

Eigen::MatrixXd sums_of_priors(const Problem& problem, const std::vector<Eigen::Index>& free) {
  const auto n = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
  for (const SumPrior& prior : problem.priors()) {
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(n);
    for (const auto& [unknown, factor] : prior.sum) {
      const auto at = std::ranges::find(free, unknown);
      if (at != free.end()) direction(at - free.begin()) += factor / prior.sd;
    }
    sum += direction * direction.transpose();
  }
  return sum;
}

}  // namespace

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
                               const std::vector<Eigen::VectorXd>& scatter,
                               const std::vector<Eigen::Index>& free,
                               const std::vector<std::vector<char>>& told) {
  EstimatingSums sums;
  for (std::size_t p = 0; p < rows.size(); ++p) {
    const Experiment& experiment = *problem.parts()[p].experiment;
    SummedFrames summed(static_cast<int>(p), experiment, weight[p], scatter[p], free,
                        told_of(told, p, free));
    int number = 0;
    for (const Frame& frame : experiment.frames()) {
      summed.take(number++, {rows[p].value.segment(frame.first, frame.count),
                             rows[p].by.middleRows(frame.first, frame.count)});
    }
    std::ranges::move(std::move(summed).sums(), std::back_inserter(sums.groups));
  }
  sums.priors = sums_of_priors(problem, free);
  return sums;
}

std::optional<EstimatingSums> predicted_sums(const Problem& problem, const Eigen::VectorXd& values,
                                             const std::vector<Eigen::VectorXd>& weight,
                                             const std::vector<Eigen::Index>& free,
                                             const std::vector<std::vector<char>>& told) {
  EstimatingSums sums;
  for (std::size_t p = 0; p < problem.parts().size(); ++p) {
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(weight[p].size());
    SummedFrames summed(static_cast<int>(p), *problem.parts()[p].experiment, weight[p], one, free,
                        told_of(told, p, free));
    if (!problem.predict(p, values, summed)) return std::nullopt;
    std::ranges::move(std::move(summed).sums(), std::back_inserter(sums.groups));
  }
  sums.priors = sums_of_priors(problem, free);
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
